// Interpolates metrics between voxel centres.
#include "metric/metric_field.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

Tensor MetricField::log_at(const Vec3& x) const
{
    CLEFT_ASSERT(log.count() == grid.size());
    double t[3];
    int64_t step[3];
    int64_t corner = 0;
    const auto strides = grid.strides();
    for (int a = 0; a < 3; ++a) {
        const int32_t n = grid.dims[a];
        // The order of the arguments makes a NaN 0 instead of an index.
        const double u = std::min(std::max(0.0, x[a] / grid.spacing[a] - 0.5), static_cast<double>(n - 1));
        const int32_t low = std::min(static_cast<int32_t>(u), std::max(n - 2, 0));
        t[a] = u - low;
        step[a] = n > 1 ? strides[a] : 0;
        corner += low * strides[a];
    }
    double sum[6] = {};
    for (int k = 0; k < 8; ++k) {
        int64_t at = corner;
        double weight = 1;
        for (int a = 0; a < 3; ++a) {
            const bool high = k >> a & 1;
            at += high ? step[a] : 0;
            weight *= high ? t[a] : 1 - t[a];
        }
        if (weight > 0)
            for (size_t c = 0; c < 6; ++c)
                sum[c] += weight * static_cast<double>(log[at][c]);
    }
    return {sum[0], sum[1], sum[2], sum[3], sum[4], sum[5]};
}

MetricField constant_metric(const Tensor& log, const Vec3& extent)
{
    const auto number = [](double value) { return static_cast<float>(value); };
    return {{{1, 1, 1}, extent},
            {{number(log.xx), number(log.xy), number(log.xz), number(log.yy), number(log.yz), number(log.zz)}}};
}

double greatest_stretch(const MetricField& field)
{
    double greatest = 0;
    for (const auto& l : field.log) {
        const Vec3 logs = eigenvalues({l[0], l[1], l[2], l[3], l[4], l[5]});
        greatest = std::max(greatest, logs[2] - logs[0]);
    }
    return std::exp(0.5 * greatest);
}

Tensor Measure::log_at(const Vec3& x) const
{
    Tensor log = field->log_at(x);
    if (stretch >= 1)
        return log;
    // The greatest size is that of the least eigenvalue.
    const double rest = (1 - stretch) * eigenvalues(log)[0];
    log = stretch * log;
    log.xx += rest;
    log.yy += rest;
    log.zz += rest;
    return log;
}

}  // namespace cleft
