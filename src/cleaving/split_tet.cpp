// Splits one tetrahedron in place, without writing it: the order of its cuts, its points, and the best fan.
#include "cleaving/split_tet.hpp"

#include "base/parallel.hpp"
#include "mesh/quality.hpp"

#include <limits>

namespace cleft
{

namespace
{

// The cut whose two pieces of edge have the greatest product is the greatest: long edges come before short ones and
// central cuts before those near an end, so that the diagonals that leave from it are the least askew. Ties go by
// number.
// Both tetrahedra at a face must agree. They do, because products are computed from the edge alone, in its own
// direction.
CutRanks rank_cuts(const Centres& c, const MixedTet& m, CutMask cuts)
{
    FixedArray<double, 6> pieces{};
    for (size_t e = 0; e < 6; ++e)
        if (cuts >> e & 1u) {
            const CutEdge& edge = c.edges[m.edges[e]];
            pieces[e] = edge.t * (1 - edge.t) *
                        c.metrics.square_on_edge(edge.lower, edge.upper, c.point(edge.upper) - c.point(edge.lower));
        }
    CutRanks ranks{};
    for (size_t e = 0; e < 6; ++e)
        for (size_t f = 0; f < e; ++f) {
            const bool e_greater = pieces[e] > pieces[f] || (pieces[e] == pieces[f] && m.edges[e] > m.edges[f]);
            ++ranks[e_greater ? e : f];
        }
    return ranks;
}

}  // namespace

SplitTet split_tet(const Centres& c, const MixedTet& mixed)
{
    SplitTet split;
    split.cuts = c.cuts(mixed);
    const Tet& corners = c.corners(mixed.tet);
    auto& x = split.x;
    for (size_t i = 0; i < 4; ++i)
        x[i] = c.point(corners[i]);
    for (size_t e = 0; e < 6; ++e)
        if (split.cuts >> e & 1u)
            x[kCutPoint + e] = c.cut_point(c.edges[mixed.edges[e]]);
    for (size_t i = 0; i < 4; ++i)
        if ((split.cuts & kFaceCuts[i]) == kFaceCuts[i]) {
            const auto cut = [&](int a, int b) {
                const int e = kEdgeBetween[kFaceCorners[i][a]][kFaceCorners[i][b]];
                return x[kCutPoint + e];
            };
            x[kTriplePoint + i] = (cut(0, 1) + cut(1, 2) + cut(2, 0)) / 3;
        }
    if (split.cuts == kAllCuts)
        x[kQuadruplePoint] = c.quadruple_point(mixed);
    split.stencils = c.stencils.stencils(split.cuts, diagonals(split.cuts, rank_cuts(c, mixed, split.cuts)));
    CLEFT_ASSERT(split.stencils.begin < split.stencils.end);  // lemma 2 of stencil.hpp
    return split;
}

double shape_cost(double least_sine)
{
    // Without it, one nearly flat tetrahedron would outweigh all others, and a snap would be judged by that one alone.
    constexpr double kSoftening = 0.02;
    if (!(least_sine > 0))
        return std::numeric_limits<double>::infinity();
    return 1 / ((least_sine + kSoftening) * (least_sine + kSoftening));
}

Fan best_fan(const Centres& c, const MixedTet& mixed)
{
    SplitTet split = split_tet(c, mixed);
    if (!c.metrics.empty()) {
        const Tensor map = c.metrics.map_of(c.corners(mixed.tet));
        for (Vec3& x : split.x)
            x = map * x;
    }
    Fan best;
    double best_sine = -std::numeric_limits<double>::infinity();
    for (uint16_t s = split.stencils.begin; s < split.stencils.end; ++s) {
        Fan candidate{0, s};
        double worst = 1;
        for (const StencilTet& t : c.stencils.tets(s)) {
            const double sine = least_sine(split.x[t[0]], split.x[t[1]], split.x[t[2]], split.x[t[3]]);
            worst = std::min(worst, sine);
            if (!(worst > best_sine))
                break;
            candidate.cost += shape_cost(sine);
        }
        // Of equal fans the first stays: its number follows from the table alone.
        if (worst > best_sine) {
            best_sine = worst;
            best = candidate;
        }
    }
    return best;
}

void choose_fans(Centres& c, const Run& run)
{
    // Each fan depends on its own tetrahedron, so the size of chunks changes the time alone.
    parallel_for(run, c.mixed.count(), 512, [&](int64_t begin, int64_t end) {
        for (int64_t m = begin; m < end; ++m)
            c.fans[m] = best_fan(c, c.mixed[m]);
    });
}

double least_volume(const StencilTable::Tets& tets, const SplitTet& split)
{
    double least = std::numeric_limits<double>::infinity();
    for (const StencilTet& t : tets)
        least = std::min(least, orient(split.x[t[0]], split.x[t[1]], split.x[t[2]], split.x[t[3]]));
    return least;
}

}  // namespace cleft
