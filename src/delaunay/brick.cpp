// A brick: which points it gets, in which order they go in, and which cells are its own.
#include "delaunay/brick.hpp"

#include "delaunay/canonical.hpp"
#include "delaunay/insertion_order.hpp"
#include "delaunay/intruder.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Points nearer than this to the box of the brick go in at once, in mean distances of points there. With less, more
// points have to be searched for, each by itself; with more, more go in that were not needed.
constexpr double kNearMargin = 1.5;
// Memory is taken for so many of them: well spaced points have 6.3 to 6.8.
constexpr int64_t kTetsOfPoint = 7;
// Between two looks for a cancel are so many insertions, of some 3 microseconds each.
constexpr int64_t kInsertionsAtATime = 256;

class Brick
{
public:
    Brick(const PointTree& tree, int64_t brick, BrickWork& work)
        : tree_(tree), brick_(brick), own_(tree.range(tree.brick_node(brick))), work_(work), kernel_(work.kernel)
    {
    }

    void add_points(const FixedArray<int64_t, 4>& first_tet);
    void insert_all(const Run& run);
    void certify(const Run& run);
    Array<Tet> tets() const;

private:
    int32_t add(int64_t position)
    {
        return vertex_count_ = kernel_.add_vertex(tree_.points()[position].x, tree_.points()[position].number);
    }
    bool is_own(int64_t position) const { return position >= own_.begin && position < own_.end; }
    bool has_own_corner(const Cell& cell) const
    {
        const auto count = static_cast<uint32_t>(own_.count());
        // A ghost becomes the greatest number.
        const auto index = [&](int i) { return static_cast<uint32_t>(cell.corners[i]) - 1; };
        return std::min({index(0), index(1), index(2), index(3)}) < count;
    }
    bool is_first(int64_t position) const
    {
        return std::find(first_tet_.begin(), first_tet_.end(), position) != first_tet_.end();
    }
    void add_near_points();
    void add_near_points(int64_t leaf);
    bool knows_all_inside(const Cell& cell) const;

    const PointTree& tree_;
    const int64_t brick_;
    const PointTree::Range own_;
    BrickWork& work_;
    DelaunayKernel& kernel_;
    // Its positions in the tree, and its vertices.
    FixedArray<int64_t, 4> first_tet_{};
    FixedArray<int32_t, 4> first_vertices_{};
    int32_t vertex_count_ = 0;
};

void Brick::add_points(const FixedArray<int64_t, 4>& first_tet)
{
    constexpr double kReach = 4;  // coordinates are less than 2
    const BoundingBox& box = tree_.box(tree_.brick_node(brick_));
    work_.room.clear(box);
    kernel_.clear(0.5 * (box.lo + box.hi), kReach);
    first_tet_ = first_tet;
    for (int64_t position = own_.begin; position < own_.end; ++position)
        add(position);
    for (int i = 0; i < 4; ++i)
        first_vertices_[i] =
            is_own(first_tet[i]) ? static_cast<int32_t>(first_tet[i] - own_.begin + 1) : add(first_tet[i]);
    add_near_points();
    kernel_.begin(first_vertices_);
}

void Brick::add_near_points()
{
    const BoundingBox& own = tree_.box(tree_.brick_node(brick_));
    Array<int64_t> waiting{1};
    while (!waiting.empty()) {
        const int64_t node = waiting.back();
        waiting.pop_back();
        if (node == tree_.brick_node(brick_))
            continue;
        const BoundingBox& box = tree_.box(node);
        if (box.distance(own) > kNearMargin * box.longest()) {  // leaves below are no longer
            work_.room.leave_out(box);
        } else if (tree_.is_leaf(node)) {
            add_near_points(node);
        } else {
            waiting.push_back(2 * node + 1);
            waiting.push_back(2 * node);
        }
    }
}

void Brick::add_near_points(int64_t leaf)
{
    const PointTree::Range range = tree_.range(leaf);
    const double reach = kNearMargin * tree_.box(leaf).longest() / std::cbrt(static_cast<double>(range.count()));
    for (int64_t i = range.begin; i < range.end; ++i) {
        const Vec3& x = tree_.points()[i].x;
        if (tree_.box(tree_.brick_node(brick_)).distance(x) > reach)
            work_.room.leave_out({x, x});
        else if (!is_first(i))
            add(i);
    }
}

void Brick::insert_all(const Run& run)
{
    Array<int32_t>& order = work_.order;
    FixedArray<int32_t, kInsertionRounds + 1> begin{};
    const auto round = [](int32_t vertex) { return kInsertionRounds - 1 - insertion_round(to_size(vertex)); };
    for (int32_t v = 1; v <= vertex_count_; ++v)
        ++begin[round(v) + 1];
    for (int r = 0; r < kInsertionRounds; ++r)
        begin[r + 1] += begin[r];
    order.resize(vertex_count_);
    for (int32_t v = 1; v <= vertex_count_; ++v)
        order[begin[round(v)]++] = v;
    for (int64_t k = 0; k < order.count(); ++k) {
        run.check_at(k, kInsertionsAtATime);
        if (std::find(first_vertices_.begin(), first_vertices_.end(), order[k]) == first_vertices_.end())
            kernel_.insert(order[k]);
    }
}

bool Brick::knows_all_inside(const Cell& cell) const
{
    const double radius = std::sqrt(static_cast<double>(cell.outer)) * (1 + 1e-9) + 2 * kernel_.rounding();
    Vec3 centre = kernel_.origin();
    for (int i = 0; i < 3; ++i)
        centre[i] += static_cast<double>(cell.centre[i]);
    return work_.room.holds_ball(centre, radius);
}

void Brick::certify(const Run& run)
{
    if (tree_.brick_count() == 1)
        return;
    Array<int32_t>& waiting = work_.waiting;
    waiting.clear();
    for (int32_t c = 0; c < kernel_.cells().count(); ++c)
        waiting.push_back(c);
    for (int64_t looked = 0; !waiting.empty(); ++looked) {
        run.check_at(looked, kInsertionsAtATime);
        const int32_t at = waiting.back();
        waiting.pop_back();
        const Cell& cell = kernel_.cells()[at];
        if (cell.is_dead() || cell.certified || !has_own_corner(cell))
            continue;
        const bool is_clear = cell.is_real() && knows_all_inside(cell);
        const int64_t intruder = is_clear ? -1 : find_intruder(tree_, brick_, kernel_, cell);
        if (intruder < 0) {
            kernel_.certify(at);
        } else {
            kernel_.insert(add(intruder), at);
            waiting.insert(waiting.end(), kernel_.made().begin(), kernel_.made().end());
        }
    }
}

Array<Tet> Brick::tets() const
{
    Array<Tet> tets;
    tets.reserve(kTetsOfPoint * own_.count());
    for (const Cell& cell : kernel_.cells()) {
        if (!cell.is_real())
            continue;
        Tet tet;
        int least = 0;
        for (int i = 0; i < 4; ++i) {
            tet[i] = kernel_.number(cell.corners[i]);
            least = tet[i] < tet[least] ? i : least;
        }
        if (cell.corners[least] <= own_.count())
            tets.push_back(canonical(tet));
    }
    return tets;
}

}  // namespace

Array<Tet> brick_tets(const PointTree& tree, int64_t brick, const FixedArray<int64_t, 4>& first_tet, BrickWork& work,
                      const Run& run)
{
    Brick it(tree, brick, work);
    it.add_points(first_tet);
    it.insert_all(run);
    it.certify(run);
    return it.tets();
}

}  // namespace cleft
