// Sorts vertices by the distance of their nearest cut into a few classes, without sorting within a class.
#include "cleaving/snap_order.hpp"

#include "base/collect.hpp"
#include "base/shared_access.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

// More classes follow the distances more closely. Fewer keep more neighbours together, and visits near one another find
// the stars in fast memory.
constexpr int kClasses = 8;

// Vertices or edges that a thread looks at. The number changes the time alone.
constexpr int64_t kCutsAtOnce = 1 << 12;
constexpr auto kNoCut = std::numeric_limits<float>::infinity();

// The square of the length of the shortest edge at a vertex.
double shortest_edge(const SnapState& state, int32_t v)
{
    double shortest = std::numeric_limits<double>::infinity();
    for (const int32_t t : state.tets_of.at(v))
        for (const int32_t w : state.c.tets[t])
            if (w != v)
                shortest =
                    std::min(shortest, state.c.metrics.square_on_edge(v, w, state.c.point(v) - state.c.point(w)));
    return shortest;
}

// The square of the distance of the nearest cut of each vertex. Single precision is enough to choose a class.
Array<float> nearest_cuts(const Centres& c, const Run& run)
{
    Array<float> nearest(c.points.size(), kNoCut);
    parallel_for(run, c.edges.count(), kCutsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const CutEdge& e = c.edges[i];
            if (!e.is_cut)
                continue;
            const double length = c.metrics.square_on_edge(e.lower, e.upper, c.point(e.upper) - c.point(e.lower));
            lower_shared(nearest[e.lower], static_cast<float>(e.t * e.t * length));
            lower_shared(nearest[e.upper], static_cast<float>((1 - e.t) * (1 - e.t) * length));
        }
    });
    return nearest;
}

struct Ranked {
    int32_t vertex;
    int step;
};

}  // namespace

Array<int32_t> vertices_to_visit(const SnapState& state, double reach, const Run& run)
{
    const Array<float> nearest = nearest_cuts(state.c, run);
    const auto ranked = collect<Ranked>(run, nearest.count(), kCutsAtOnce, [&](int64_t begin, int64_t end, auto& list) {
        for (auto v = static_cast<int32_t>(begin); v < end; ++v) {
            if (!state.touched[v] || !(nearest[v] < kNoCut) ||
                std::binary_search(state.held.begin(), state.held.end(), v))
                continue;
            const double ratio = std::sqrt(static_cast<double>(nearest[v]) / shortest_edge(state, v)) / reach;
            if (ratio <= 1)
                list.push_back({v, std::min(static_cast<int>(ratio * kClasses), kClasses - 1)});
        }
    });
    Array<int32_t> order;
    order.reserve(ranked.size());
    for (int step = 0; step < kClasses; ++step)
        for (const Ranked& one : ranked)
            if (one.step == step)
                order.push_back(one.vertex);
    return order;
}

}  // namespace cleft
