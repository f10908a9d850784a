// Triangles come from the interfaces of the mesh, and edges of lines from the triangles: those of three materials.
#include "checking/tie_elements.hpp"

#include "mesh/interfaces.hpp"
#include "volume/material_set.hpp"

#include <algorithm>
#include <tuple>

namespace cleft
{

namespace
{

struct EdgeOfPair {
    int32_t lower, upper;
    std::array<Material, 2> pair;
    bool is_along(const EdgeOfPair& o) const { return lower == o.lower && upper == o.upper; }
    bool operator<(const EdgeOfPair& o) const
    {
        return std::tie(lower, upper, pair) < std::tie(o.lower, o.upper, o.pair);
    }
};

// Edges inside of an interface are left out: its triangles are next to each other there, two and no more.
Array<EdgeOfPair> edges_of(const Interfaces& interfaces)
{
    Array<EdgeOfPair> edges;
    edges.reserve(3 * interfaces.triangles.size());
    for (size_t t = 0; t < interfaces.triangles.size(); ++t)
        for (size_t i = 0; i < 3; ++i) {
            const auto [lower, upper] = std::minmax(interfaces.triangles[t][i], interfaces.triangles[t][(i + 1) % 3]);
            edges.push_back({lower, upper, interfaces.pairs[t]});
        }
    std::sort(edges.begin(), edges.end());
    edges.erase(std::unique(edges.begin(), edges.end(),
                            [](const EdgeOfPair& a, const EdgeOfPair& b) { return a.is_along(b) && a.pair == b.pair; }),
                edges.end());
    return edges;
}

void add_lines(const EdgeOfPair& edge, const MaterialSet& set, Array<TieElement>& elements)
{
    for (int i = 0; i < set.size(); ++i)
        for (int j = i + 1; j < set.size(); ++j)
            for (int k = j + 1; k < set.size(); ++k)
                elements.push_back({{{set[i], set[j], set[k]}}, {edge.lower, edge.upper, edge.upper}});
}

void add_lines(const Array<EdgeOfPair>& edges, Array<TieElement>& elements)
{
    for (auto first = edges.begin(); first != edges.end();) {
        const auto last = std::find_if(first, edges.end(), [&](const EdgeOfPair& e) { return !e.is_along(*first); });
        MaterialSet set;
        bool has_room = true;
        for (auto edge = first; edge != last; ++edge)
            for (const Material m : edge->pair)
                has_room = set.unite(MaterialSet(m)) && has_room;
        // More materials than a set holds meet in noise alone, which has no lines.
        if (has_room && last - first > 1)
            add_lines(*first, set, elements);
        first = last;
    }
}

}  // namespace

Array<TieElement> tie_elements(const LabelledMesh& mesh, const Run& run)
{
    // The sides of the hull do not matter here, so any box will do.
    const Interfaces interfaces = extract_interfaces(mesh, Vec3::Zero(), Vec3::Zero(), run);
    Array<TieElement> elements;
    elements.reserve(interfaces.triangles.size());
    for (size_t t = 0; t < interfaces.triangles.size(); ++t) {
        const Triangle& corners = interfaces.triangles[t];
        elements.push_back(
            {{{interfaces.pairs[t][0], interfaces.pairs[t][1], kNoThird}}, {corners[0], corners[1], corners[2]}});
    }
    const size_t triangles = elements.size();
    add_lines(edges_of(interfaces), elements);
    std::stable_sort(elements.begin() + static_cast<std::ptrdiff_t>(triangles), elements.end(),
                     [](const TieElement& a, const TieElement& b) { return a.of < b.of; });
    return elements;
}

// By the regions of the corners, the edges and the inside, in this order: Ericson, Real-Time Collision
// Detection, 5.1.5.
double square_distance(const Vec3& x, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 ab = b - a, ac = c - a, ax = x - a, bx = x - b, cx = x - c;
    const double ab_a = ab.dot(ax), ac_a = ac.dot(ax), ab_b = ab.dot(bx), ac_b = ac.dot(bx), ab_c = ab.dot(cx),
                 ac_c = ac.dot(cx);
    if (ab_a <= 0 && ac_a <= 0)
        return ax.squaredNorm();
    if (ab_b >= 0 && ac_b <= ab_b)
        return bx.squaredNorm();
    const double beside_ab = ab_a * ac_b - ab_b * ac_a;
    if (beside_ab <= 0 && ab_a >= 0 && ab_b <= 0)
        return (ax - ab_a / (ab_a - ab_b) * ab).squaredNorm();
    if (ac_c >= 0 && ab_c <= ac_c)
        return cx.squaredNorm();
    const double beside_ac = ab_c * ac_a - ab_a * ac_c;
    if (beside_ac <= 0 && ac_a >= 0 && ac_c <= 0)
        return (ax - ac_a / (ac_a - ac_c) * ac).squaredNorm();
    const double beside_bc = ab_b * ac_c - ab_c * ac_b;
    if (beside_bc <= 0 && ac_b - ab_b >= 0 && ab_c - ac_c >= 0)
        return (bx - (ac_b - ab_b) / ((ac_b - ab_b) + (ab_c - ac_c)) * (c - b)).squaredNorm();
    const Vec3 normal = ab.cross(ac);
    const double off = normal.dot(ax);
    return off * off / normal.squaredNorm();
}

}  // namespace cleft
