// Decides by the link of a vertex whether each of its two materials is in one piece, before anything is assembled.
#include "cleaving/pinch.hpp"

#include <numeric>

namespace cleft
{

PinchCheck::Finding PinchCheck::look(const CutStar& star, const MaterialSet& before)
{
    if (!load(star, before))
        return Finding::unknown;
    join_sides();
    return are_one_piece_each() && reach_the_rim() ? Finding::sound : Finding::pinched;
}

// False if the star is not one of two materials.
bool PinchCheck::load(const CutStar& star, const MaterialSet& before)
{
    const MaterialSet& both = c_.materials_of(star.vertex());
    // The lemma of pinch.hpp speaks of a vertex that had one material and takes over a second one.
    if (both.size() != 2 || before.size() != 1)
        return false;
    const MaterialSet second(both[0] == before[0] ? both[1] : both[0]);
    side_.clear();
    for (const int32_t w : star.link()) {
        const MaterialSet& materials = c_.materials_of(w);
        // A third material near by: the lemma says nothing.
        if (!(materials == before) && !(materials == second) && !(materials == both))
            return false;
        place_[w] = static_cast<int32_t>(side_.size());
        side_.push_back(materials == before ? Side::first : materials == second ? Side::second : Side::interface);
    }
    triangles_.clear();
    for (const CutStar::Part& part : star.parts()) {
        Triangle triangle{};
        size_t i = 0;
        for (const int32_t w : c_.corners(part.tet))
            if (w != star.vertex())
                triangle[i++] = place_[w];
        CLEFT_ASSERT(i == 3);
        triangles_.push_back(triangle);
    }
    return true;
}

void PinchCheck::join_sides()
{
    side_.resize(side_.size() + triangles_.size(), Side::interface);
    parent_.resize(side_.size());
    std::iota(parent_.begin(), parent_.end(), 0);
    along_.clear();
    for (size_t k = 0; k < triangles_.size(); ++k)
        join_triangle(k);
    join_along_interface();
}

void PinchCheck::join_triangle(size_t triangle)
{
    const Triangle& t = triangles_[triangle];
    const auto side = [&](size_t i) { return side_[t[i]]; };
    const auto node = static_cast<int32_t>(side_.size() - triangles_.size() + triangle);
    const bool is_flat = side(0) == Side::interface && side(1) == side(0) && side(2) == side(0);
    if (is_flat)  // the tetrahedron keeps the material that its vertex had
        side_[node] = Side::first;
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        if (side(i) != side(j))
            continue;
        if (side(i) == Side::interface)
            along_.push_back({std::min(t[i], t[j]), std::max(t[i], t[j]), is_flat ? node : t[k]});
        else
            join(t[i], t[j]);
    }
}

// Two triangles of one side at an edge whose ends are at the interface.
void PinchCheck::join_along_interface()
{
    std::sort(along_.begin(), along_.end(), [](const InterfaceEdge& a, const InterfaceEdge& b) {
        return a.low != b.low ? a.low < b.low : a.high < b.high;
    });
    for (size_t i = 1; i < along_.size(); ++i) {
        const InterfaceEdge &a = along_[i - 1], &b = along_[i];
        if (a.low == b.low && a.high == b.high && side_[a.node] == side_[b.node])
            join(a.node, b.node);
    }
}

bool PinchCheck::are_one_piece_each()
{
    int first = 0, second = 0;
    for (size_t n = 0; n < side_.size(); ++n)
        if (side_[n] != Side::interface && parent_[n] == static_cast<int32_t>(n))
            ++(side_[n] == Side::first ? first : second);
    return first == 1 && second == 1;
}

bool PinchCheck::reach_the_rim()
{
    find_rim();
    if (rim_.empty())
        return true;
    bool first = false, second = false;
    const auto see = [&](int32_t node) {
        first = first || side_[node] == Side::first;
        second = second || side_[node] == Side::second;
    };
    for (const auto& edge : rim_) {
        see(edge[0]);
        see(edge[1]);
        for (const InterfaceEdge& e : along_)
            if (e.low == edge[0] && e.high == edge[1])
                see(e.node);
    }
    return first && second;
}

// The edges that only one triangle has. Inside the mesh the surface is a sphere, see CutStar.
void PinchCheck::find_rim()
{
    rim_.clear();
    const size_t link = side_.size() - triangles_.size();
    if (2 * link == triangles_.size() + 4)
        return;
    for (const Triangle& t : triangles_)
        for (size_t i = 0; i < 3; ++i)
            rim_.push_back({std::min(t[i], t[(i + 1) % 3]), std::max(t[i], t[(i + 1) % 3])});
    std::sort(rim_.begin(), rim_.end());
    size_t kept = 0;
    for (size_t i = 0; i < rim_.size();) {
        const bool twice = i + 1 < rim_.size() && rim_[i] == rim_[i + 1];
        if (!twice)
            rim_[kept++] = rim_[i];
        i += twice ? 2 : 1;
    }
    rim_.resize(kept);
}

int32_t PinchCheck::root(int32_t node)
{
    while (parent_[node] != node)
        node = parent_[node] = parent_[parent_[node]];
    return node;
}

void PinchCheck::join(int32_t a, int32_t b)
{
    a = root(a);
    b = root(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

}  // namespace cleft
