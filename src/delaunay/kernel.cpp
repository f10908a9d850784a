// The kernel: a walk to the point, the cavity of all cells whose spheres have it inside, and a star of new cells in it.
#include "delaunay/kernel.hpp"

#include "base/error.hpp"
#include "base/large_pages.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/predicates.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Corners of a cavity for which a table of all pairs is kept, in fast memory. Cavities of well spaced points have 16 on
// average; larger ones are sorted.
constexpr int kCornersInTable = 128;
// For which memory is taken at once: well spaced points have 6.3 to 6.8, and the hull adds some.
constexpr size_t kCellsOfVertex = 7;
// After so many steps a walk by rounded signs may be in a circle.
constexpr int kMostWalkSteps = 1 << 12;

}  // namespace

void DelaunayKernel::clear(const Vec3& origin, double reach)
{
    origin_ = origin;
    rounding_ = 4 * DBL_EPSILON * reach;
    vertices_.clear();
    numbers_.clear();
    vertices_.push_back({Vec3::Zero(), 0, 0});
    numbers_.push_back(-1);
    cells_.clear();
    free_.clear();
    insertion_ = 0;
    edges_.resize(kCornersInTable * kCornersInTable);
}

int32_t DelaunayKernel::add_vertex(const Vec3& x, int32_t number)
{
    vertices_.push_back({x, 0, 0});
    numbers_.push_back(number);
    return static_cast<int32_t>(vertices_.size() - 1);
}

void DelaunayKernel::begin(const FixedArray<int32_t, 4>& vertices)
{
    if (cells_.capacity() < kCellsOfVertex * vertices_.size())
        reserve_large(cells_, kCellsOfVertex * vertices_.size());
    Tet tet = vertices;
    if (orient_sign(place(tet[0]), place(tet[1]), place(tet[2]), place(tet[3])) < 0)
        std::swap(tet[2], tet[3]);
    cells_.push_back(Cell{tet, {}, {}, -1, 0, 0, 0});
    for (const auto& f : kFaceCorners) {
        cells_.push_back(Cell{{{tet[f[0]], tet[f[1]], tet[f[2]], kGhost}}, {}, {}, 0, 0, 0, 0});
        leave_in_doubt(cells_.back());
    }
    const auto opposite = [&](int32_t cell, int32_t corner) {
        const Tet& c = cells_[cell].corners;
        return static_cast<int32_t>(std::find(c.begin(), c.end(), corner) - c.begin());
    };
    for (int face = 0; face < 4; ++face) {
        const int32_t ghost = face + 1;
        cells_[0].behind[face] = 4 * ghost + 3;
        cells_[ghost].behind[3] = face;
        for (int other = 0; other < 4; ++other)
            if (other != face)  // the ghosts of two faces meet where each lacks the corner of the other's face
                cells_[ghost].behind[opposite(ghost, tet[other])] = 4 * (other + 1) + opposite(other + 1, tet[face]);
    }
    const Vec3& p = place(tet[0]);
    FixedArray<SeenCorner, 3> corners;
    for (int i = 0; i < 3; ++i) {
        const Vec3 edge = place(tet[i + 1]) - p;
        corners[i] = {edge, edge.squaredNorm()};
    }
    const auto both = [&](int i) { return PairOfCorners(&corners[i], &corners[i]); };
    set_spheres_of_pair({cells_.data(), cells_.data()},
                        pair_of_spheres(p - origin_, rounding_, both(0), both(1), both(2)));
    last_ = 0;
}

DelaunayKernel::Seen DelaunayKernel::seen(int32_t vertex) const
{
    const Vec3& x = place(vertex);
    return {{&x, numbers_[vertex]}, x, x - origin_};
}

bool DelaunayKernel::has_inside(const Cell& cell, const NumberedPoint& point) const
{
    FixedArray<NumberedPoint, 4> tet;
    for (int i = 0; i < 4; ++i)
        tet[i] = {&place(cell.corners[i]), numbers_[cell.corners[i]]};
    return inside_perturbed_sphere(tet, point);
}

// Beyond the face of the hull. In its plane: inside of its circle, and so of any sphere through it. Lemma: the rise of
// the fourth corner does not count there, since the barycentric coordinate of that corner is zero.
bool DelaunayKernel::ghost_in_conflict(const Cell& cell, const Seen& p) const
{
    const auto corner = [&](int i) -> const Vec3& { return place(cell.corners[i]); };
    const int side = orient_sign(corner(0), corner(1), corner(2), p.x);
    return side != 0 ? side > 0 : in_conflict(cells_[cell.behind[3] >> 2], p);
}

// A face, other than `entry`, beyond which p lies; -1: none.
template <bool kExact>
int DelaunayKernel::exit_face(const Cell& cell, const Vec3& p, int entry) const
{
    for (int face = 0; face < 4; ++face) {
        if (face == entry)
            continue;
        const auto& f = kFaceCorners[face];
        const Vec3 &a = place(cell.corners[f[0]]), &b = place(cell.corners[f[1]]), &c = place(cell.corners[f[2]]);
        if constexpr (kExact) {
            if (orient_sign(a, b, c, p) > 0)
                return face;
        } else {
            if ((b - a).cross(c - a).dot(p - a) > 0)
                return face;
        }
    }
    return -1;
}

// From face to face towards p, which ends in Delaunay tetrahedra. Returns a cell in conflict with p, or -1 where
// rounding has led astray.
template <bool kExact>
int32_t DelaunayKernel::walk(const Seen& p) const
{
    int32_t at = last_;
    int entry = -1;
    for (int64_t step = 0; kExact || step < kMostWalkSteps; ++step) {
        const Cell& cell = cells_[at];
        if (in_conflict(cell, p))
            return at;
        const int exit = cell.is_ghost() ? -1 : exit_face<kExact>(cell, p.x, entry);
        if (exit < 0)
            return -1;
        entry = cell.behind[exit] & 3;
        at = cell.behind[exit] >> 2;
    }
    return -1;
}

int32_t DelaunayKernel::locate(const Seen& p) const
{
    int32_t cell = walk<false>(p);
    if (cell < 0)
        cell = walk<true>(p);
    if (cell < 0)
        throw Error(CLEFT_ERROR_INTERNAL, "a point of the Delaunay mesh was not found");
    return cell;
}

// Lemma: the cells in conflict are connected, and p sees all of the border from inside (Watson 1981; the perturbation
// keeps it true on spheres with more points, and in planes of the hull).
//   No branch depends on where p is but in the rare cases in doubt: a processor would guess half of them wrongly. So
// entries are written in any case, and kept by counting them.
void DelaunayKernel::find_cavity(const Seen& p, int32_t first)
{
    // Marks of cells are even where the point is outside, odd where it is inside.
    ++insertion_;
    const uint32_t outside = 2 * insertion_, inside = outside + 1;
    cells_[first].mark = inside;
    make_room(1);
    cavity_[0] = first;
    size_t in_cavity = 1, in_border = 0;
    for (size_t k = 0; k < in_cavity; ++k) {
        // Four faces add four entries to either list at most. Doubling makes calls few.
        if (in_cavity + 4 > cavity_.size() || in_border + 4 > border_.size())
            make_room(2 * (in_cavity + in_border) + 4);
        const int32_t at = cavity_[k];
        const Cell& in = cells_[at];
        int32_t* const cavity = cavity_.data();
        BorderFace* const border = border_.data();
        for (int face = 0; face < 4; ++face) {
            const int32_t behind = in.behind[face];
            Cell& next = cells_[behind >> 2];
            const uint32_t mark = next.mark;
            const double square = square_from(next, p);
            const uint32_t is_near = square < static_cast<double>(next.inner);
            const uint32_t is_far = square > static_cast<double>(next.outer);
            const uint32_t is_marked = mark >= outside;  // and the mark tells
            uint32_t is_in = (is_marked & mark) | (~is_marked & is_near);
            if (!(is_marked | is_near | is_far))
                is_in = doubtful_in_conflict(next, p) ? 1 : 0;
            next.mark = outside + is_in;
            cavity[in_cavity] = behind >> 2;
            in_cavity += is_in & static_cast<uint32_t>(mark != inside);
            border[in_border] = {4 * at + face, behind};
            in_border += is_in ^ 1;
        }
    }
    cavity_size_ = in_cavity;
    border_size_ = in_border;
}

void DelaunayKernel::make_room(size_t count)
{
    cavity_.resize(std::max(cavity_.size(), count));
    border_.resize(std::max(border_.size(), count));
    slots_.resize(border_.size());
    corners_.resize(3 * border_.size());
    seen_.resize(3 * border_.size());
    faces_.resize(border_.size());
}

void DelaunayKernel::see_corners(const Vec3& p)
{
    int32_t count = 0;
    int32_t* const seen = seen_.data();
    Vertex* const vertices = vertices_.data();
    for (size_t k = 0; k < border_size_; ++k) {
        const int32_t face = border_[k].face;
        const Cell& cell = cells_[face >> 2];
        const int* f = kFaceCorners[face & 3];
        FixedArray<int32_t, 3> corners{{cell.corners[f[0]], cell.corners[f[1]], cell.corners[f[2]]}}, slots;
        if (cell.is_ghost() && (face & 3) != 3)  // the ghost becomes the last
            std::rotate(corners.begin(), std::find(corners.begin(), corners.end(), kGhost) + 1, corners.end());
        for (int i = 0; i < 3; ++i) {
            Vertex& corner = vertices[corners[i]];
            const int32_t is_new = corner.stamp != insertion_;
            const int32_t slot = corner.slot ^ ((corner.slot ^ count) & -is_new);  // by a mask, as above
            corner.stamp = insertion_;
            corner.slot = slot;
            slots[i] = slot;
            seen[count] = corners[i];
            count += is_new;
        }
        faces_[k] = corners;
        slots_[k] = slots;
    }
    corner_count_ = to_size(count);
    for (size_t i = 0; i < corner_count_; ++i) {
        const Vec3 edge = vertices_[seen_[i]].x - p;
        corners_[i] = {edge, edge.squaredNorm()};
    }
}

// The places of the cavity's cells first, which are in the cache.
void DelaunayKernel::take_cells()
{
    made_.clear();
    const size_t reused = std::min(border_size_, cavity_size_);
    made_.insert(made_.end(), cavity_.begin(), cavity_.begin() + static_cast<int64_t>(reused));
    for (size_t k = reused; k < cavity_size_; ++k) {
        cells_[cavity_[k]].kill();
        free_.push_back(cavity_[k]);
    }
    while (made_.size() < border_size_) {
        if (free_.empty()) {
            made_.push_back(static_cast<int32_t>(cells_.size()));
            cells_.emplace_back();
        } else {
            made_.push_back(free_.back());
            free_.pop_back();
        }
    }
}

void DelaunayKernel::fill_cells(int32_t vertex)
{
    for (size_t k = 0; k < border_size_; ++k) {
        const int32_t behind = border_[k].behind;
        Cell& cell = cells_[made_[k]];
        cell.corners = {{vertex, faces_[k][0], faces_[k][1], faces_[k][2]}};
        cell.behind[0] = behind;
        cell.mark = cell.certified = 0;
        cells_[behind >> 2].behind[behind & 3] = 4 * made_[k];
        if (cell.is_real())
            last_ = made_[k];
    }
}

// Each edge of the border is met once in each direction, by the two faces whose new cells share it and the point. So
// every entry that is read was written in this insertion.
void DelaunayKernel::link_cells()
{
    uint16_t* const edges = edges_.data();
    const auto entry = [edges](int32_t from, int32_t to) -> uint16_t& { return edges[kCornersInTable * from + to]; };
    for (size_t k = 0; k < border_size_; ++k) {
        const auto [a, b, c] = slots_[k];
        const auto first = static_cast<uint16_t>(4 * k);
        entry(b, c) = static_cast<uint16_t>(first + 1);
        entry(c, a) = static_cast<uint16_t>(first + 2);
        entry(a, b) = static_cast<uint16_t>(first + 3);
    }
    const int32_t* const made = made_.data();
    for (size_t k = 0; k < border_size_; ++k) {
        const auto [a, b, c] = slots_[k];
        const auto other = [&](int32_t from, int32_t to) {
            const int e = entry(to, from);
            return 4 * made[e >> 2] + (e & 3);
        };
        FixedArray<int32_t, 4>& behind = cells_[made[k]].behind;
        behind[1] = other(b, c);
        behind[2] = other(c, a);
        behind[3] = other(a, b);
    }
}

void DelaunayKernel::link_many_cells()
{
    struct Edge {
        int32_t from, to, at;
    };
    Array<Edge> edges;
    edges.reserve(3 * border_size_);
    for (size_t k = 0; k < border_size_; ++k)
        for (int i = 0; i < 3; ++i) {
            const auto [from, to] = std::minmax(slots_[k][(i + 1) % 3], slots_[k][(i + 2) % 3]);
            edges.push_back({from, to, 4 * made_[k] + i + 1});
        }
    std::sort(edges.begin(), edges.end(),
              [](const Edge& a, const Edge& b) { return a.from != b.from ? a.from < b.from : a.to < b.to; });
    for (size_t e = 0; e + 1 < edges.size(); e += 2) {
        const int32_t one = edges[e].at, other = edges[e + 1].at;
        cells_[one >> 2].behind[one & 3] = other;
        cells_[other >> 2].behind[other & 3] = one;
    }
}

void DelaunayKernel::set_spheres(const Seen& p)
{
    for (size_t k = 0; k < border_size_; k += 2) {
        const size_t other = std::min(k + 1, border_size_ - 1);
        const auto &s = slots_[k], &t = slots_[other];
        const SeenCorner* const seen = corners_.data();
        const PairOfSpheres spheres = pair_of_spheres(p.in_frame, rounding_, {seen + s[0], seen + t[0]},
                                                      {seen + s[1], seen + t[1]}, {seen + s[2], seen + t[2]});
        set_spheres_of_pair({&cells_[made_[k]], &cells_[made_[other]]}, spheres);
    }
}

void DelaunayKernel::insert(int32_t vertex, int32_t cell)
{
    const Seen p = seen(vertex);
    find_cavity(p, cell);
    see_corners(p.x);
    take_cells();
    fill_cells(vertex);
    if (corner_count_ <= kCornersInTable)
        link_cells();
    else
        link_many_cells();
    set_spheres(p);
}

}  // namespace cleft
