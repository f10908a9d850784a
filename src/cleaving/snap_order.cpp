// Sorts vertices by the distance of their nearest cut into a few classes, without sorting within a class.
#include "cleaving/snap_order.hpp"

#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

// More classes follow the distances more closely. Fewer keep more neighbours together, and visits near one another find
// the stars in fast memory.
constexpr int kClasses = 8;

// The square of the length of the shortest edge at each vertex that is touched.
// Single precision is enough to choose a class, and halves the memory.
Array<float> shortest_edges(const Centres& c, const Array<uint8_t>& touched, const Run& run)
{
    Array<float> shortest(c.points.size(), std::numeric_limits<float>::infinity());
    for (size_t k = 0; k < c.tets.size(); ++k) {
        run.check_at(k);
        const Tet& t = c.tets[k];
        const auto is_touched = [&](int32_t v) { return touched[v] != 0; };
        if (std::none_of(t.begin(), t.end(), is_touched))
            continue;
        for (const auto& e : kEdgeCorners) {
            const int32_t v = t[e[0]], w = t[e[1]];
            const auto length = static_cast<float>((c.point(v) - c.point(w)).squaredNorm());
            for (const int32_t end : {v, w})
                shortest[end] = std::min(shortest[end], length);
        }
    }
    return shortest;
}

// The square of the distance of the nearest cut of each vertex.
Array<float> nearest_cuts(const Centres& c)
{
    Array<float> nearest(c.points.size(), std::numeric_limits<float>::infinity());
    for (const CutEdge& e : c.edges) {
        if (!e.is_cut)
            continue;
        const double length = (c.point(e.upper) - c.point(e.lower)).squaredNorm();
        float &low = nearest[e.lower], &high = nearest[e.upper];
        low = std::min(low, static_cast<float>(e.t * e.t * length));
        high = std::min(high, static_cast<float>((1 - e.t) * (1 - e.t) * length));
    }
    return nearest;
}

}  // namespace

Array<int32_t> vertices_to_visit(const Centres& c, double reach, const Array<uint8_t>& touched, const Run& run)
{
    const Array<float> nearest = nearest_cuts(c), shortest = shortest_edges(c, touched, run);
    Array<int32_t> steps[kClasses];
    for (size_t v = 0; v < nearest.size(); ++v) {
        if (!touched[v] || !(nearest[v] < std::numeric_limits<float>::infinity()))
            continue;
        const double ratio = std::sqrt(static_cast<double>(nearest[v]) / static_cast<double>(shortest[v])) / reach;
        if (ratio <= 1)
            steps[std::min(static_cast<int>(ratio * kClasses), kClasses - 1)].push_back(static_cast<int32_t>(v));
    }
    Array<int32_t> order;
    for (const auto& step : steps)
        order.insert(order.end(), step.begin(), step.end());
    return order;
}

}  // namespace cleft
