#include "cleaving/star.hpp"

#include "cleaving/split_tet.hpp"
#include "mesh/quality.hpp"

#include <limits>

namespace cleft
{

namespace
{

void add_once(std::vector<int32_t>& list, int32_t item)
{
    if (std::find(list.begin(), list.end(), item) == list.end())
        list.push_back(item);
}

}  // namespace

VertexTets::VertexTets(const Centres& c) : first_(c.points.size() + 1, 0)
{
    std::vector<uint8_t> is_at_cut(c.points.size(), 0);
    for (const CutEdge& e : c.edges)
        is_at_cut[static_cast<size_t>(e.lower)] = is_at_cut[static_cast<size_t>(e.upper)] = 1;
    for (size_t v = 0; v < is_at_cut.size(); ++v)
        if (is_at_cut[v])
            vertices_.push_back(static_cast<int32_t>(v));
    for (const Tet& t : c.tets)
        for (const int32_t v : t)
            first_[static_cast<size_t>(v) + 1] += is_at_cut[static_cast<size_t>(v)];
    for (size_t v = 0; v + 1 < first_.size(); ++v)
        first_[v + 1] += first_[v];
    tets_.resize(static_cast<size_t>(first_.back()));
    std::vector<int64_t> next(first_.begin(), first_.end() - 1);
    for (size_t t = 0; t < c.tets.size(); ++t)
        for (const int32_t v : c.tets[t])
            if (is_at_cut[static_cast<size_t>(v)])
                tets_[static_cast<size_t>(next[static_cast<size_t>(v)]++)] = static_cast<int32_t>(t);
}

void Star::gather(const Centres& c, const VertexTets& tets_of, int32_t v)
{
    vertex = v;
    tets.assign(tets_of.begin(v), tets_of.end(v));
    edges.clear();
    double shortest = std::numeric_limits<double>::infinity();
    for (const int32_t tet : tets) {
        const Tet& corners = c.corners(tet);
        const auto local = static_cast<size_t>(std::find(corners.begin(), corners.end(), v) - corners.begin());
        for (size_t i = 0; i < 4; ++i)
            if (i != local)
                shortest = std::min(shortest, (c.point(corners[i]) - c.point(v)).squaredNorm());
        if (c.mixed_of[static_cast<size_t>(tet)] < 0)
            continue;
        const MixedTet& m = c.mixed[static_cast<size_t>(c.mixed_of[static_cast<size_t>(tet)])];
        for (size_t i = 0; i < 4; ++i) {
            if (i == local)
                continue;
            const int32_t edge = m.edges[static_cast<size_t>(kEdgeBetween[local][i])];
            if (c.is_cut(edge))
                add_once(edges, edge);
        }
    }
    shortest_edge = std::sqrt(shortest);
}

void StarState::save(const Centres& c, const Star& star)
{
    x = c.point(star.vertex);
    materials = c.materials_of(star.vertex);
    samples = c.samples.of(star.vertex);
    edges.clear();
    for (const int32_t e : star.edges)
        edges.push_back(c.edges[static_cast<size_t>(e)]);
}

void StarState::restore(Centres& c, const Star& star) const
{
    c.points[static_cast<size_t>(star.vertex)] = x;
    c.materials[static_cast<size_t>(star.vertex)] = materials;
    c.samples.set(star.vertex, samples);
    for (size_t i = 0; i < edges.size(); ++i)
        c.edges[static_cast<size_t>(star.edges[i])] = edges[i];
}

void change_vertex(Centres& c, const Star& star, const Vec3& x, const MaterialSet& materials,
                   const SampleStore::Span& samples, Samples& scratch)
{
    c.points[static_cast<size_t>(star.vertex)] = x;
    c.materials[static_cast<size_t>(star.vertex)] = materials;
    c.samples.set(star.vertex, samples);
    for (const int32_t e : star.edges) {
        CutEdge& edge = c.edges[static_cast<size_t>(e)];
        edge.is_cut = disjoint(c.materials_of(edge.lower), c.materials_of(edge.upper));
        if (edge.is_cut)
            c.place_cut(edge, scratch);
    }
}

StarShape measure_star(const Centres& c, const Star& star, double limit)
{
    StarShape shape;
    for (const int32_t tet : star.tets) {
        const Tet& t = c.corners(tet);
        const double sine = least_sine(c.point(t[0]), c.point(t[1]), c.point(t[2]), c.point(t[3]));
        shape.least_background = std::min(shape.least_background, sine);
        const int32_t m = c.mixed_of[static_cast<size_t>(tet)];
        if (!(sine > 0) || m < 0 || !c.cuts(c.mixed[static_cast<size_t>(m)]))
            shape.cost += shape_cost(sine);
        else
            shape.cost += best_fan(split_tet(c, c.mixed[static_cast<size_t>(m)])).cost;
        if (shape.cost > limit)
            break;
    }
    return shape;
}

}  // namespace cleft
