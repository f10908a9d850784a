#include "cleaving/split_tet.hpp"

#include "base/parallel.hpp"
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

Fan best_fan(const SplitTet& split)
{
    const Apexes candidates = apexes(split.cuts, split.surface);
    Fan best;
    double best_sine = -std::numeric_limits<double>::infinity();
    for (size_t i = 0; i < static_cast<size_t>(candidates.count); ++i) {
        Fan candidate{0, candidates.point[i]};
        std::array<StencilTet, 24> tets;
        const int count = fan(split.surface, candidate.apex, tets);
        double worst = 1;
        for (int k = 0; k < count && worst > best_sine; ++k) {
            const StencilTet& t = tets[static_cast<size_t>(k)];
            const double sine = least_sine(split.x[t[0]], split.x[t[1]], split.x[t[2]], split.x[t[3]]);
            worst = std::min(worst, sine);
            candidate.cost += shape_cost(sine);
        }
        if (worst > best_sine) {
            best_sine = worst;
            best = candidate;
        }
    }
    return best;
}

void choose_fans(Centres& c, const Run& run)
{
    parallel_for(run, static_cast<int64_t>(c.mixed.size()), 512, [&](int64_t begin, int64_t end) {
        for (auto m = static_cast<size_t>(begin); m < static_cast<size_t>(end); ++m)
            c.fans[m] = best_fan(split_tet(c, c.mixed[m]));
    });
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
