// Builds the coloured link of a point and counts its defects. Euler's formula counts pieces without searching for them.
#include "cleaving/link.hpp"

#include <algorithm>
#include <limits>
#include <utility>

namespace cleft
{

void Link::Vertex::see(Material m)
{
    if (m == first || m == second)
        return;
    if (first >= 0 && second >= 0)
        has_third = true;
    else
        (first < 0 ? first : second) = m;
}

void Link::load(const LabelledMesh& mesh, int32_t point, const int32_t* first, const int32_t* last)
{
    // Places of earlier links lie below the new base, so the array need not be cleared for each point.
    base_ += static_cast<int32_t>(vertices_.size());
    if (base_ > std::numeric_limits<int32_t>::max() / 2) {
        std::fill(place_.begin(), place_.end(), -1);
        base_ = 0;
    }
    vertices_.clear();
    triangles_.clear();
    edges_.clear();
    pattern_edges_ = pinched_edges_ = extra_pieces_ = 0;
    Vertex all{point, 0};
    for (const int32_t* t = first; t != last; ++t) {
        all.see(mesh.material[*t]);
        add(mesh.tets[*t], point, mesh.material[*t]);
    }
    // Of one material: no interface, and so no defect.
    if (!all.is_mixed())
        return;
    // On a sphere the colour changes between mixed vertices only. Elsewhere all edges are needed, to find the rim.
    // A triangulated sphere has V = T / 2 + 2. See star.cpp for why the hull always has more vertices.
    const bool is_sphere = 2 * vertices_.size() == triangles_.size() + 4;
    for (const Triangle& t : triangles_)
        for (size_t side = 0; side < 3; ++side)
            if (!is_sphere ||
                (vertices_[t.corners[side]].is_mixed() && vertices_[t.corners[(side + 1) % 3]].is_mixed()))
                meet(t, side);
    find_defects(is_sphere, all.has_third);
}

void Link::find_defects(bool is_sphere, bool has_third)
{
    Vertex rim{-1, 0};
    if (!is_sphere)
        find_rim(rim);
    for (const Vertex& v : vertices_)
        pinched_edges_ += v.is_pinched();
    // The hull of a user-supplied background may have stars that are no balls, as their Euler number shows.
    const bool is_disk = vertices_.size() + triangles_.size() == edges_.size() + 1;
    // Two materials should have one piece each on the sphere.
    if (!has_third && is_sphere)
        extra_pieces_ = pieces() - 2;
    else if (!has_third && is_disk)  // one lies outside, and both materials must reach it
        extra_pieces_ = pieces() - 3 + !rim.is_mixed();
}

Array<int32_t> Link::pinched_edges() const
{
    Array<int32_t> others;
    for (const Vertex& v : vertices_)
        if (v.is_pinched())
            others.push_back(v.point);
    return others;
}

int32_t Link::number(int32_t point)
{
    int32_t& place = place_[point];
    if (place < base_) {
        const auto next = static_cast<int32_t>(vertices_.size());
        place = base_ + next;
        vertices_.push_back({point, next});
    }
    CLEFT_ASSERT(place - base_ < vertices_.count());
    return place - base_;
}

void Link::add(const Tet& tet, int32_t point, Material material)
{
    Triangle triangle{{}, material};
    size_t i = 0;
    for (const int32_t w : tet)
        if (w != point) {
            triangle.corners[i] = number(w);
            vertices_[triangle.corners[i++]].see(material);
        }
    triangles_.push_back(triangle);
}

// The side from one corner to the next. The second triangle that has it knows whether the colour changes there.
void Link::meet(const Triangle& triangle, size_t side)
{
    const auto [a, b] = std::minmax(triangle.corners[side], triangle.corners[(side + 1) % 3]);
    int32_t e = vertices_[a].edges;
    while (e >= 0 && edges_[e].high != b)
        e = edges_[e].next;
    if (e < 0) {
        edges_.push_back({a, b, triangle.material, vertices_[a].edges});
        vertices_[a].edges = static_cast<int32_t>(edges_.size()) - 1;
        return;
    }
    const Material other = std::exchange(edges_[e].material, kMet);
    if (other == triangle.material || other == kMet)
        return;
    ++vertices_[a].changes;
    ++vertices_[b].changes;
    add_to_pattern(a, b);
}

void Link::add_to_pattern(int32_t a, int32_t b)
{
    ++pattern_edges_;
    vertices_[root(b)].parent = root(a);
    vertices_[a].is_in_pattern = vertices_[b].is_in_pattern = true;
}

void Link::find_rim(Vertex& rim)
{
    for (const auto& [low, high, material, next] : edges_)
        if (material != kMet) {
            rim.see(material);
            vertices_[low].is_on_rim = vertices_[high].is_on_rim = true;
            add_to_pattern(low, high);
        }
}

// Of a sphere that the pattern is drawn on, by the formula of Euler.
int Link::pieces() const
{
    int pieces = pattern_edges_ + 1;
    for (size_t v = 0; v < vertices_.size(); ++v)
        if (vertices_[v].is_in_pattern)
            pieces += (vertices_[v].parent == static_cast<int32_t>(v)) - 1;
    return pieces;
}

int32_t Link::root(int32_t vertex)
{
    // Halving the path keeps later searches short, and needs no second pass.
    while (vertices_[vertex].parent != vertex)
        vertex = vertices_[vertex].parent = vertices_[vertices_[vertex].parent].parent;
    return vertex;
}

}  // namespace cleft
