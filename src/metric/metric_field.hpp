// A metric at each place: the symmetric positive definite tensor M by which an edge v of the wanted length has
// v^T M v = 1.
#pragma once

#include "base/array.hpp"
#include "base/grid.hpp"
#include "metric/tensor.hpp"

#include <array>

namespace cleft
{

// Logarithms at the voxel centres of the grid, in the local frame; read between them by trilinear interpolation,
// constant past the outermost. Between two tensors, this keeps the sizes in every direction between theirs (Arsigny,
// Fillard, Pennec and Ayache 2006).
struct MetricField {
    Grid grid;
    Array<std::array<float, 6>> log;  // xx xy xz yy yz zz

    bool empty() const { return log.empty(); }
    Tensor log_at(const Vec3& x) const;
};

// The metric of this logarithm at each place of a box.
MetricField constant_metric(const Tensor& log, const Vec3& extent);

// The greatest over the least size at one place, at the voxel where it is greatest.
double greatest_stretch(const MetricField& field);

// The corners of a tetrahedron where the metric is the identity, up to a factor that keeps volumes. The metric of the
// tetrahedron is the mean of those at its corners in logarithms, of which `logs` is the sum.
inline std::array<Vec3, 4> measured(const std::array<Vec3, 4>& x, const Tensor& logs)
{
    const Tensor map = unit_exp(0.125 * logs);
    return {Vec3::Zero(), map * (x[1] - x[0]), map * (x[2] - x[0]), map * (x[3] - x[0])};
}
inline std::array<Vec3, 4> measured(const std::array<Vec3, 4>& x, const MetricField& metric)
{
    return measured(x, metric.log_at(x[0]) + metric.log_at(x[1]) + metric.log_at(x[2]) + metric.log_at(x[3]));
}

// What a mesh is measured by: a field, of which the stretch may come in steps. It runs from the isotropic metric of the
// greatest size at each place (0) to the field (1), in logarithms.
struct Measure {
    const MetricField* field = nullptr;  // null: lengths and angles are those of the frame
    double stretch = 1;

    Tensor log_at(const Vec3& x) const;
};

}  // namespace cleft
