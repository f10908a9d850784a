// Measures the room around each vertex that has cuts.
#include "cleaving/safe_reach.hpp"

#include "base/parallel.hpp"

namespace cleft
{

SafeReach find_safe_reach(const Centres& c, const VertexTets& tets_of, const Run& run)
{
    constexpr int64_t kMeasuredAtOnce = 1 << 14;  // each chunk has a table of all vertices
    SafeReach reach(c.edges.size());
    parallel_for(run, c.points.count(), kMeasuredAtOnce, [&](int64_t begin, int64_t end) {
        CutStar star(c, tets_of);
        for (auto v = static_cast<int32_t>(begin); v < end; ++v) {
            run.check_at(v, 1024);
            star.gather(v);
            if (star.edges().empty())
                continue;
            const double alpha = std::min(star.shortest_edge(), star.least_altitude());
            for (const int32_t e : star.edges()) {
                const CutEdge& edge = c.edges[e];
                const Vec3 direction = (star.in_frame(edge.upper) - star.in_frame(edge.lower)).normalized();
                reach[e][edge.upper == v] = kSnapReach * std::min(alpha, star.width_along(direction));
            }
        }
    });
    return reach;
}

}  // namespace cleft
