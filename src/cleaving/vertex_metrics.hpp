// What a metric says of lengths and shapes around the vertices of a background; without one, those of the frame.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "metric/metric_field.hpp"

#include <cmath>

namespace cleft
{

// The metric at a vertex is that of the place which it had at the start. Snapping moves it by less than an edge, along
// which the metric hardly changes.
struct VertexMetrics {
    Array<Tensor> log;  // by vertex; empty: without a metric

    bool empty() const { return log.empty(); }
    // The square of the length of a part of the edge between two vertices.
    double square_on_edge(int32_t a, int32_t b, const Vec3& part) const
    {
        return empty() ? part.squaredNorm() : square(exp(0.5 * (log[a] + log[b])), part);
    }
    // In the frame in which the metric at the vertex is the identity.
    Vec3 in_frame(int32_t v, const Vec3& x) const { return empty() ? x : exp(0.5 * log[v]) * x; }
    // The greatest distance of points that the metric at the vertex has so far from each other.
    double greatest_distance(int32_t v, double length) const
    {
        return empty() ? length : length * std::exp(-0.5 * eigenvalues(log[v])[0]);
    }
    // Maps a tetrahedron to one whose angles are those in the metric. Not without a metric.
    Tensor map_of(const Tet& corners) const
    {
        return unit_exp(0.125 * (log[corners[0]] + log[corners[1]] + log[corners[2]] + log[corners[3]]));
    }
};

// At the points, of a field or of none.
VertexMetrics metrics_at(const Array<Vec3>& points, const MetricField* field, const Run& run);

}  // namespace cleft
