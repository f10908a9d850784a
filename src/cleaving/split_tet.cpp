#include "cleaving/split_tet.hpp"

#include "mesh/quality.hpp"

#include <limits>

namespace cleft
{

namespace
{

// The most central cut is the greatest: the diagonals that leave from it are the least askew. Ties go by number.
CutRanks rank_cuts(const Centres& c, const MixedTet& m, CutMask cuts)
{
    std::array<double, 6> centrality{};
    for (size_t e = 0; e < 6; ++e)
        if (cuts >> e & 1u) {
            const double t = c.edges[static_cast<size_t>(m.edges[e])].t;
            centrality[e] = t * (1 - t);
        }
    CutRanks ranks{};
    for (size_t e = 0; e < 6; ++e)
        for (size_t f = 0; f < e; ++f) {
            const bool e_greater =
                centrality[e] > centrality[f] || (centrality[e] == centrality[f] && m.edges[e] > m.edges[f]);
            ++ranks[e_greater ? e : f];
        }
    return ranks;
}

template <class Visit>
void for_each_tet(const SplitTet& split, int apex, const Visit& visit)
{
    std::array<StencilTet, 24> tets;
    const int count = fan(split.surface, apex, tets);
    for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
        const StencilTet& t = tets[i];
        visit(split.x[t[0]], split.x[t[1]], split.x[t[2]], split.x[t[3]]);
    }
}

}  // namespace

SplitTet split_tet(const Centres& c, const MixedTet& mixed)
{
    SplitTet split;
    split.cuts = c.cuts(mixed);
    const Tet& corners = c.corners(mixed.tet);
    for (size_t i = 0; i < 4; ++i)
        split.x[i] = c.point(corners[i]);
    for (size_t e = 0; e < 6; ++e)
        if (split.cuts >> e & 1u)
            split.x[kCutPoint + e] = c.cut_point(c.edges[static_cast<size_t>(mixed.edges[e])]);
    for (size_t i = 0; i < 4; ++i)
        if ((split.cuts & kFaceCuts[i]) == kFaceCuts[i])
            split.x[kTriplePoint + i] = c.triple_point(c.faces[static_cast<size_t>(mixed.faces[i])]);
    if (split.cuts == kAllCuts)
        split.x[kQuadruplePoint] = c.quadruple_point(mixed);
    split.surface = split_surface(split.cuts, rank_cuts(c, mixed, split.cuts));
    return split;
}

double shape_cost(double least_sine)
{
    constexpr double kSoftening = 0.02;
    if (!(least_sine > 0))
        return std::numeric_limits<double>::infinity();
    return 1 / ((least_sine + kSoftening) * (least_sine + kSoftening));
}

BestFan best_fan(const SplitTet& split)
{
    const Apexes candidates = apexes(split.cuts, split.surface);
    BestFan best;
    for (size_t i = 0; i < static_cast<size_t>(candidates.count); ++i) {
        BestFan fan{candidates.point[i], 1, 0};
        for_each_tet(split, fan.apex, [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
            const double sine = least_sine(a, b, c, d);
            fan.least_sine = std::min(fan.least_sine, sine);
            fan.cost += shape_cost(sine);
        });
        if (i == 0 || fan.least_sine > best.least_sine)
            best = fan;
    }
    return best;
}

double least_volume(const SplitTet& split, int apex)
{
    double least = std::numeric_limits<double>::infinity();
    for_each_tet(split, apex, [&](const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
        least = std::min(least, orient(a, b, c, d));
    });
    return least;
}

}  // namespace cleft
