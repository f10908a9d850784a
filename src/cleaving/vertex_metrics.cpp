// Reads the metric at the vertices of a background.
#include "cleaving/vertex_metrics.hpp"

#include "base/parallel.hpp"

namespace cleft
{

VertexMetrics metrics_at(const Array<Vec3>& points, const MetricField* field, const Run& run)
{
    constexpr int64_t kPointsRead = 1 << 12;  // at once; the number changes the time alone
    VertexMetrics metrics;
    if (!field)
        return metrics;
    metrics.log.resize(points.size());
    parallel_for(run, points.count(), kPointsRead, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v)
            metrics.log[v] = field->log_at(points[v]);
    });
    return metrics;
}

}  // namespace cleft
