// Collects the star of a vertex, measures it, and saves and restores what a trial changes.
#include "cleaving/star.hpp"

#include "base/counting_sort.hpp"
#include "base/shared_access.hpp"
#include "cleaving/split_tet.hpp"
#include "mesh/quality.hpp"

#include <limits>

namespace cleft
{

namespace
{

int64_t place_in(const Tet& corners, int32_t v)
{
    const auto place = std::find(corners.begin(), corners.end(), v) - corners.begin();
    CLEFT_ASSERT(place < 4);
    return place;
}

double quality_of(const Centres& c, const Tet& t)
{
    if (c.metrics.empty())
        return angle_quality(c.point(t[0]), c.point(t[1]), c.point(t[2]), c.point(t[3]));
    const Tensor map = c.metrics.map_of(t);
    return angle_quality(map * c.point(t[0]), map * c.point(t[1]), map * c.point(t[2]), map * c.point(t[3]));
}

}  // namespace

VertexTets::VertexTets(const Centres& c, const Run& run)
{
    constexpr int64_t kEdgesAtOnce = 1 << 14;  // the number changes the time alone
    // Only these vertices are ever visited. They are a small part, so the lists take little memory.
    Array<uint8_t> is_at_cut(c.points.size(), 0);
    parallel_for(run, c.edges.count(), kEdgesAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t e = begin; e < end; ++e)
            for (const int32_t v : {c.edges[e].lower, c.edges[e].upper})
                store_shared<uint8_t>(is_at_cut[v], 1);
    });
    Groups<int64_t, int32_t> tets =
        group_by_key<int64_t, int32_t>(run, c.tets.count(), c.points.count(), [&](int64_t t, const auto& give) {
            for (const int32_t v : c.tets[t])
                if (is_at_cut[v])
                    give(v, static_cast<int32_t>(t));
        });
    first_ = std::move(tets.start);
    tets_ = std::move(tets.values);
}

void CutStar::gather(int32_t v)
{
    vertex_ = v;
    parts_.clear();
    link_.clear();
    edges_.clear();
    const Vec3& x = c_.point(v);
    double shortest = std::numeric_limits<double>::infinity();
    for (const int32_t tet : tets_of_.at(v)) {
        const Tet& corners = c_.corners(tet);
        const int32_t mixed = c_.mixed_of[tet];
        parts_.push_back({tet, mixed});
        for (size_t i = 0; i < 4; ++i) {
            const int32_t w = corners[i];
            if (w == v || seen_[w] == v)
                continue;
            seen_[w] = v;
            link_.push_back(w);
            shortest = std::min(shortest, c_.metrics.square_on_edge(v, w, c_.point(w) - x));
            // All tetrahedra around an edge that was ever cut are mixed, so the first one is enough.
            if (mixed < 0)
                continue;
            const int64_t local = place_in(corners, v);
            const int32_t edge = c_.mixed[mixed].edges[kEdgeBetween[local][i]];
            if (c_.is_cut(edge))
                edges_.push_back(edge);
        }
    }
    // Another visit of the same vertex must find its link anew.
    for (const int32_t w : link_)
        seen_[w] = -1;
    shortest_edge_ = std::sqrt(shortest);
}

double CutStar::least_altitude() const
{
    double least = std::numeric_limits<double>::infinity();
    for (const Part& part : parts_) {
        const Tet& t = c_.corners(part.tet);
        const int* face = kFaceCorners[place_in(t, vertex_)];
        const Vec3 a = in_frame(t[face[0]]);
        const Vec3 normal = (in_frame(t[face[1]]) - a).cross(in_frame(t[face[2]]) - a).normalized();
        least = std::min(least, std::abs(normal.dot(in_frame(vertex_) - a)));
    }
    return least;
}

// Where an edge at the vertex meets the opposite edge, no volume is left between them. `across` is normal to both, and
// their distance is measured along it.
double CutStar::width_along(const Vec3& direction) const
{
    double least = std::numeric_limits<double>::infinity();
    const Vec3 x = in_frame(vertex_);
    for (const Part& part : parts_) {
        const Tet& t = c_.corners(part.tet);
        const int* others = kFaceCorners[place_in(t, vertex_)];
        for (int i = 0; i < 3; ++i) {
            const auto corner = [&](int k) { return in_frame(t[others[(i + k) % 3]]); };
            const Vec3 across = (corner(0) - x).cross(corner(2) - corner(1));
            const double distance = std::abs((corner(1) - x).dot(across)), along = std::abs(direction.dot(across));
            if (distance < least * along)
                least = distance / along;
        }
    }
    return least;
}

// The faces of the star opposite the vertex make a surface of T triangles, E edges and V vertices. Inside the mesh it
// is a sphere: 2 E = 3 T and V - E + T = 2, so V = T / 2 + 2. On the hull it has h > 0 holes in some pieces, each piece
// a sphere with holes, and at each hole at least three edges of one triangle only: V is greater.
bool CutStar::is_inside() const { return 2 * link_.size() == parts_.size() + 4; }

unsigned CutStar::frozen_axes() const
{
    if (is_inside())
        return 0;
    // The faces at the vertex, by their two other points; those of one tetrahedron are on the hull.
    Array<std::array<int32_t, 2>> faces;
    for (const Part& part : parts_) {
        const Tet& t = c_.corners(part.tet);
        const int* others = kFaceCorners[place_in(t, vertex_)];
        for (int i = 0; i < 3; ++i) {
            const int32_t a = t[others[i]], b = t[others[(i + 1) % 3]];
            faces.push_back({std::min(a, b), std::max(a, b)});
        }
    }
    // No table of face neighbours exists for the background: only a few vertices of the hull ever ask.
    std::sort(faces.begin(), faces.end());
    unsigned frozen = 0;
    for (auto f = faces.begin(); f != faces.end();) {
        const auto end = std::upper_bound(f, faces.end(), *f);
        if (end - f == 1)
            frozen |= hull_axes(c_.point(vertex_), c_.point((*f)[0]), c_.point((*f)[1]));
        f = end;
    }
    return frozen;
}

void StarState::save(const Centres& c, const CutStar& star)
{
    x = c.point(star.vertex());
    materials = c.materials_of(star.vertex());
    samples = c.samples.of(star.vertex());
    edges.clear();
    for (const int32_t e : star.edges())
        edges.push_back(c.edges[e]);
}

// The order of edges is that of the star, which is the same as when it was saved.
void StarState::restore(Centres& c, const CutStar& star) const
{
    change_vertex(c, star, x, materials);
    c.samples.set(star.vertex(), samples);
    for (size_t i = 0; i < edges.size(); ++i)
        c.edges[star.edges()[i]] = edges[i];
}

void change_vertex(Centres& c, const CutStar& star, const Vec3& x, const MaterialSet& materials)
{
    c.points[star.vertex()] = x;
    c.materials[star.vertex()] = materials;
}

void place_cuts(Centres& c, const CutStar& star, Samples& scratch)
{
    for (const int32_t e : star.edges())
        c.renew_cut(c.edges[e], scratch);
}

void measure_star(const Centres& c, const CutStar& star, StarShape& shape)
{
    measure_background(c, star, shape);
    for (size_t i = 0; i < star.parts().size(); ++i)
        if (star.parts()[i].mixed >= 0) {
            shape.fans[i] = c.fans[star.parts()[i].mixed];
            shape.cost += shape.fans[i].cost;
        }
}

void measure_background(const Centres& c, const CutStar& star, StarShape& shape)
{
    shape.cost = 0;
    shape.least_background = 1;
    shape.fans.resize(star.parts().size());
    for (const CutStar::Part& part : star.parts()) {
        const Tet& t = c.corners(part.tet);
        const double quality = quality_of(c, t);
        shape.least_background = std::min(shape.least_background, quality);
        // A mixed tetrahedron counts by its pieces, but none may be inverted itself.
        if (!(quality > 0) || part.mixed < 0)
            shape.cost += shape_cost(quality);
    }
}

void measure_fans(const Centres& c, const CutStar& star, double limit, StarShape& shape)
{
    // Costs are positive, so a sum above the limit stays above it.
    for (size_t i = 0; i < star.parts().size() && shape.cost <= limit; ++i) {
        const int32_t mixed = star.parts()[i].mixed;
        if (mixed < 0)
            continue;
        shape.fans[i] = best_fan(c, c.mixed[mixed]);
        shape.cost += shape.fans[i].cost;
    }
}

}  // namespace cleft
