// The kernel: a walk to the point, the cavity of all cells whose spheres have it inside, and a star of new cells in it.
#include "delaunay/kernel.hpp"

#include "base/error.hpp"
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
// After so many steps a walk by rounded signs may be in a circle.
constexpr int kMostWalkSteps = 1 << 12;

void prefetch(const void* address) { __builtin_prefetch(address); }

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
    Tet tet = vertices;
    if (orient_sign(place(tet[0]), place(tet[1]), place(tet[2]), place(tet[3])) < 0)
        std::swap(tet[2], tet[3]);
    // The tetrahedron and its ghosts are what a cavity of no cells leaves: four border faces around its first corner.
    cells_.push_back(Cell{tet, {}, {}, -1, 0, 0, 0});
    for (int face = 0; face < 4; ++face) {
        const auto& f = kFaceCorners[face];
        cells_.push_back(Cell{{{tet[f[0]], tet[f[1]], tet[f[2]], kGhost}}, {}, {}, -1, 0, 0, 0});
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
    FixedArray<SeenCorner, 3> seen_from_first;
    for (int i = 0; i < 3; ++i) {
        const Vec3 edge = place(tet[i + 1]) - p;
        seen_from_first[i] = {edge, edge.squaredNorm()};
    }
    set_sphere(cells_[0], p - origin_, rounding_, seen_from_first[0], seen_from_first[1], seen_from_first[2]);
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

void DelaunayKernel::add_border(const Cell& cell, int face)
{
    const auto& f = kFaceCorners[face];
    // The ghost becomes the last.
    const int turn = cell.corners[f[0]] == kGhost ? 1 : cell.corners[f[1]] == kGhost ? 2 : 0;
    const auto corner = [&](int i) { return cell.corners[f[(turn + i) % 3]]; };
    border_.push_back({{{corner(0), corner(1), corner(2)}}, cell.behind[face]});
}

// Lemma: the cells in conflict are connected, and p sees all of the border from inside (Watson 1981; the perturbation
// keeps it true on spheres with more points, and in planes of the hull).
void DelaunayKernel::find_cavity(const Seen& p, int32_t cell)
{
    // Marks of cells are even where the point is outside, odd where it is inside.
    ++insertion_;
    const uint32_t outside = 2 * insertion_, inside = outside + 1;
    cavity_.clear();
    border_.clear();
    cells_[cell].mark = inside;
    cavity_.push_back(cell);
    for (size_t k = 0; k < cavity_.size(); ++k) {
        const Cell& in = cells_[cavity_[k]];
        for (int face = 0; face < 4; ++face) {
            const int32_t next = in.behind[face] >> 2;
            Cell& neighbour = cells_[next];
            if (neighbour.mark == inside)
                continue;
            if (neighbour.mark != outside) {
                if (in_conflict(neighbour, p)) {
                    neighbour.mark = inside;
                    cavity_.push_back(next);
                    for (const int32_t behind : neighbour.behind)
                        prefetch(&cells_[behind >> 2]);
                    continue;
                }
                neighbour.mark = outside;
            }
            add_border(in, face);
        }
    }
}

void DelaunayKernel::see_corners(const Vec3& p)
{
    corners_.clear();
    slots_.clear();
    for (const BorderFace& face : border_) {
        FixedArray<int32_t, 3> slots;
        for (int i = 0; i < 3; ++i) {
            Vertex& corner = vertices_[face.corners[i]];
            if (corner.stamp != insertion_) {
                corner.stamp = insertion_;
                corner.slot = static_cast<int32_t>(corners_.size());
                const Vec3 edge = corner.x - p;
                corners_.push_back({edge, edge.squaredNorm()});
            }
            slots[i] = corner.slot;
        }
        slots_.push_back(slots);
    }
}

// The places of the cavity's cells first, which are in the cache.
void DelaunayKernel::take_cells()
{
    made_.clear();
    const size_t reused = std::min(border_.size(), cavity_.size());
    made_.insert(made_.end(), cavity_.begin(), cavity_.begin() + static_cast<int64_t>(reused));
    for (size_t k = reused; k < cavity_.size(); ++k) {
        cells_[cavity_[k]].kill();
        free_.push_back(cavity_[k]);
    }
    while (made_.size() < border_.size()) {
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
    for (size_t k = 0; k < border_.size(); ++k) {
        const BorderFace& face = border_[k];
        Cell& cell = cells_[made_[k]];
        cell.corners = {{vertex, face.corners[0], face.corners[1], face.corners[2]}};
        cell.behind[0] = face.behind;
        cell.mark = cell.certified = 0;
        cells_[face.behind >> 2].behind[face.behind & 3] = 4 * made_[k];
        if (cell.is_real())
            last_ = made_[k];
    }
}

// Each edge of the border is met once in each direction, by the two faces whose new cells share it and the point. So
// every entry that is read was written in this insertion.
void DelaunayKernel::link_cells()
{
    const auto entry = [&](int32_t from, int32_t to) -> uint16_t& { return edges_[kCornersInTable * from + to]; };
    for (size_t k = 0; k < border_.size(); ++k) {
        const auto& s = slots_[k];
        for (int i = 0; i < 3; ++i)
            entry(s[(i + 1) % 3], s[(i + 2) % 3]) = static_cast<uint16_t>(4 * k + to_size(i) + 1);
    }
    for (size_t k = 0; k < border_.size(); ++k) {
        const auto& s = slots_[k];
        for (int i = 0; i < 3; ++i) {
            const int32_t other = entry(s[(i + 2) % 3], s[(i + 1) % 3]);
            cells_[made_[k]].behind[i + 1] = 4 * made_[other >> 2] + (other & 3);
        }
    }
}

void DelaunayKernel::link_many_cells()
{
    struct Edge {
        int32_t from, to, at;
    };
    Array<Edge> edges;
    edges.reserve(3 * border_.size());
    for (size_t k = 0; k < border_.size(); ++k)
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
    for (size_t k = 0; k < border_.size(); ++k) {
        const auto& s = slots_[k];
        Cell& cell = cells_[made_[k]];
        if (cell.is_real())
            set_sphere(cell, p.in_frame, rounding_, corners_[s[0]], corners_[s[1]], corners_[s[2]]);
    }
}

void DelaunayKernel::insert(int32_t vertex, int32_t cell)
{
    const Seen p = seen(vertex);
    find_cavity(p, cell);
    see_corners(p.x);
    take_cells();
    fill_cells(vertex);
    if (corners_.size() <= kCornersInTable)
        link_cells();
    else
        link_many_cells();
    set_spheres(p);
}

}  // namespace cleft
