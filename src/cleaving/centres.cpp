#include "cleaving/centres.hpp"

namespace cleft
{

CutMask Centres::cuts(const MixedTet& m) const
{
    CutMask mask = 0;
    for (size_t e = 0; e < 6; ++e)
        mask |= static_cast<CutMask>(is_cut(m.edges[e])) << e;
    return mask;
}

Vec3 Centres::triple_point(const TripleFace& f) const
{
    const Vec3& a = point(f.corners[0]);
    return a + f.weights[0] * (point(f.corners[1]) - a) + f.weights[1] * (point(f.corners[2]) - a);
}

Vec3 Centres::quadruple_point(const QuadrupleTet& q) const
{
    const Tet& c = corners(q.tet);
    const Vec3& a = point(c[0]);
    Vec3 x = a;
    for (size_t i = 1; i < 4; ++i)
        x += q.weights[i - 1] * (point(c[i]) - a);
    return x;
}

void Centres::place_cut(CutEdge& e, Samples& scratch) const
{
    const MaterialSet &a = materials_of(e.lower), &b = materials_of(e.upper);
    const EdgeTie tie{
        point(e.lower), point(e.upper), a, b, samples.difference(e.lower, a, b), samples.difference(e.upper, a, b)};
    e.t = find_cut(volume, tie, scratch);
}

void Centres::place_triple(TripleFace& f, Samples& scratch) const
{
    SimplexTie tie;
    tie.corners = 3;
    for (size_t i = 0; i < 3; ++i) {
        tie.x[i] = point(f.corners[i]);
        tie.materials[i] = &materials_of(f.corners[i]);
    }
    // The mean of the three cuts. Corners ascend, so an edge runs from its first corner.
    const double t01 = edges[static_cast<size_t>(f.edges[0])].t, t02 = edges[static_cast<size_t>(f.edges[1])].t,
                 t12 = edges[static_cast<size_t>(f.edges[2])].t;
    f.weights = find_centre(volume, tie, {(t01 + 1 - t12) / 3, (t02 + t12) / 3, 0}, scratch);
}

void Centres::place_quadruple(QuadrupleTet& q, Samples& scratch) const
{
    const MixedTet& m = mixed[static_cast<size_t>(mixed_of[static_cast<size_t>(q.tet)])];
    const Tet& c = corners(q.tet);
    SimplexTie tie;
    tie.corners = 4;
    for (size_t i = 0; i < 4; ++i) {
        tie.x[i] = point(c[i]);
        tie.materials[i] = &materials_of(c[i]);
    }
    // The mean of the six cuts.
    std::array<double, 4> weight{};
    for (size_t e = 0; e < 6; ++e) {
        const CutEdge& edge = edges[static_cast<size_t>(m.edges[e])];
        const auto i = static_cast<size_t>(kEdgeCorners[e][0]), j = static_cast<size_t>(kEdgeCorners[e][1]);
        const double at_j = c[i] == edge.lower ? edge.t : 1 - edge.t;
        weight[j] += at_j / 6;
        weight[i] += (1 - at_j) / 6;
    }
    q.weights = find_centre(volume, tie, {weight[1], weight[2], weight[3]}, scratch);
}

}  // namespace cleft
