#include "cleaving/snap_order.hpp"

#include <cmath>
#include <limits>

namespace cleft
{

namespace
{

constexpr size_t kClasses = 8;

// The square of the length of the shortest edge at each vertex that is touched.
std::vector<float> shortest_edges(const Centres& c, const std::vector<uint8_t>& touched, const Run& run)
{
    std::vector<float> shortest(c.points.size(), std::numeric_limits<float>::infinity());
    for (size_t k = 0; k < c.tets.size(); ++k) {
        run.check_at(k);
        const Tet& t = c.tets[k];
        const auto is_touched = [&](int32_t v) { return touched[static_cast<size_t>(v)] != 0; };
        if (std::none_of(t.begin(), t.end(), is_touched))
            continue;
        for (const auto& e : kEdgeCorners) {
            const int32_t v = t[static_cast<size_t>(e[0])], w = t[static_cast<size_t>(e[1])];
            const auto length = static_cast<float>((c.point(v) - c.point(w)).squaredNorm());
            for (const int32_t end : {v, w})
                shortest[static_cast<size_t>(end)] = std::min(shortest[static_cast<size_t>(end)], length);
        }
    }
    return shortest;
}

// The square of the distance of the nearest cut of each vertex.
std::vector<float> nearest_cuts(const Centres& c)
{
    std::vector<float> nearest(c.points.size(), std::numeric_limits<float>::infinity());
    for (const CutEdge& e : c.edges) {
        if (!e.is_cut)
            continue;
        const double length = (c.point(e.upper) - c.point(e.lower)).squaredNorm();
        float &low = nearest[static_cast<size_t>(e.lower)], &high = nearest[static_cast<size_t>(e.upper)];
        low = std::min(low, static_cast<float>(e.t * e.t * length));
        high = std::min(high, static_cast<float>((1 - e.t) * (1 - e.t) * length));
    }
    return nearest;
}

}  // namespace

std::vector<int32_t> vertices_to_visit(const Centres& c, double reach, const std::vector<uint8_t>& touched,
                                       const Run& run)
{
    const std::vector<float> nearest = nearest_cuts(c), shortest = shortest_edges(c, touched, run);
    std::vector<int32_t> steps[kClasses];
    for (size_t v = 0; v < nearest.size(); ++v) {
        if (!touched[v] || !(nearest[v] < std::numeric_limits<float>::infinity()))
            continue;
        const double ratio = std::sqrt(static_cast<double>(nearest[v]) / static_cast<double>(shortest[v])) / reach;
        if (ratio <= 1)
            steps[std::min(static_cast<size_t>(ratio * kClasses), kClasses - 1)].push_back(static_cast<int32_t>(v));
    }
    std::vector<int32_t> order;
    for (const auto& step : steps)
        order.insert(order.end(), step.begin(), step.end());
    return order;
}

}  // namespace cleft
