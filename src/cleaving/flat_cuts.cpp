// Slivers of the background must not split into pieces of no volume.
#include "cleaving/flat_cuts.hpp"

#include "base/parallel.hpp"
#include "cleaving/split_tet.hpp"
#include "mesh/quality.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Fixed, because the mean edge is summed chunk by chunk, and a threshold depends on it.
constexpr int64_t kTetsLookedAt = 2048;

double mean_edge(const Centres& c, const Run& run)
{
    const auto n = c.tets.count();
    Array<double> sums(chunk_count(n, kTetsLookedAt), 0.0);
    parallel_chunks(run, n, kTetsLookedAt, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            for (const auto& e : kEdgeCorners)
                sums[chunk] += (c.point(c.tets[t][e[0]]) - c.point(c.tets[t][e[1]])).norm();
    });
    double sum = 0;
    for (const double s : sums)
        sum += s;
    return sum / static_cast<double>(std::max<int64_t>(1, 6 * n));
}

// Mixed tetrahedra with a piece whose sixfold volume is not above the threshold.
Array<int32_t> find_flat(const Centres& c, double threshold, const Run& run)
{
    // A piece is a product of few shares of edges, and cuts keep away from the ends of their edges: the least is a
    // corner of a triple point seen from a quadruple point, 0.02 * 0.04 / 3 * 0.06 / 6.
    constexpr double kLeastShare = 1e-6;
    const auto n = c.mixed.count();
    Array<Array<int32_t>> found(chunk_count(n, kTetsLookedAt));
    parallel_chunks(run, n, kTetsLookedAt, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t m = begin; m < end; ++m) {
            const Tet& t = c.corners(c.mixed[m].tet);
            // Spares nearly all tetrahedra the work of splitting: even their least piece is large enough.
            if (orient(c.point(t[0]), c.point(t[1]), c.point(t[2]), c.point(t[3])) * kLeastShare > threshold)
                continue;
            const SplitTet split = split_tet(c, c.mixed[m]);
            if (split.cuts && !(least_volume(c.stencils.tets(c.fans[m].stencil), split) > threshold))
                found[chunk].push_back(static_cast<int32_t>(m));
        }
    });
    Array<int32_t> all;
    for (const auto& f : found)
        all.insert(all.end(), f.begin(), f.end());
    return all;
}

// False if the tetrahedron has no cut left.
// The pieces next to the least central cut are the thinnest, so they are lost first.
bool drop_least_central_cut(Centres& c, const MixedTet& m, const Array<int32_t>& held)
{
    const auto is_held = [&](int32_t v) { return std::binary_search(held.begin(), held.end(), v); };
    CutEdge* least = nullptr;
    for (const int32_t e : m.edges)
        if (c.is_cut(e)) {
            CutEdge& edge = c.edges[e];
            if (is_held(edge.lower) && is_held(edge.upper))
                continue;
            if (!least || edge.t * (1 - edge.t) < least->t * (1 - least->t))
                least = &edge;
        }
    if (least)
        least->is_cut = false;
    return least != nullptr;
}

}  // namespace

int64_t give_up_flat_cuts(Centres& c, const Array<int32_t>& held, const Run& run)
{
    // Twice what validation calls flat, which goes by the mean edge of the output, shorter than the background's.
    const double edge = mean_edge(c, run);
    const double threshold = 2 * 6e-12 * edge * edge * edge;
    int64_t dropped = 0;
    for (Array<int32_t> flat; !(flat = find_flat(c, threshold, run)).empty();) {
        // Each round gives up at least one cut, and cuts do not come back, so the loop ends.
        const int64_t before = dropped;
        for (const int32_t m : flat)
            dropped += drop_least_central_cut(c, c.mixed[m], held);
        if (dropped == before)
            break;
        choose_fans(c, run);  // an edge has many tetrahedra; slivers are few
    }
    return dropped;
}

}  // namespace cleft
