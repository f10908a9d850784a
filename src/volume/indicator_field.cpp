// Interpolates indicator functions, with the one that is the rest of the others evaluated from them.
#include "volume/indicator_field.hpp"

#include "base/stage.hpp"
#include "volume/indicator_blocks.hpp"
#include "volume/indicator_claims.hpp"
#include "volume/indicator_values.hpp"
#include "volume/position.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

namespace cleft
{

namespace
{

// Weights of the voxels first .. first + count - 1 along one axis, and their derivatives by the position in voxels.
struct CubicWeights {
    int32_t first = 0;
    int count = 0;
    double w[4] = {};
    double dw[4] = {};

    void add(int32_t voxel, double weight, double slope)
    {
        CLEFT_ASSERT(voxel >= first && voxel < first + count);
        w[voxel - first] += weight;
        dw[voxel - first] += slope;
    }
};

// Cubic convolution (Keys 1981, a = -1/2). Values outside the grid are those of the line through the outermost two,
// so their weights go to these two.
CubicWeights cubic_weights(double u, int32_t n)
{
    CubicWeights out;
    // One plane of voxels: the function is constant across it.
    if (n == 1) {
        out.count = 1;
        out.w[0] = 1;
        return out;
    }
    const double low = std::floor(u);
    const double t = u - low, t2 = t * t, t3 = t2 * t;
    const double w[4] = {(-t + 2 * t2 - t3) / 2, (2 - 5 * t2 + 3 * t3) / 2, (t + 4 * t2 - 3 * t3) / 2, (t3 - t2) / 2};
    const double dw[4] = {(-1 + 4 * t - 3 * t2) / 2, (-10 * t + 9 * t2) / 2, (1 + 8 * t - 9 * t2) / 2,
                          (3 * t2 - 2 * t) / 2};
    const int32_t base = static_cast<int32_t>(low) - 1;
    out.count = std::min(n, 4);
    out.first = std::clamp(base, 0, n - out.count);
    for (int i = 0; i < 4; ++i) {
        const int32_t voxel = base + i;
        const int32_t end = std::clamp(voxel, 0, n - 1);
        const int32_t past = std::abs(voxel - end);
        out.add(end, (1 + past) * w[i], (1 + past) * dw[i]);
        if (past > 0)
            out.add(end == 0 ? 1 : n - 2, -past * w[i], -past * dw[i]);
    }
    return out;
}

struct Stencil {
    CubicWeights axis[3];
    int64_t row, slice, start;

    Stencil(const Grid& grid, const Vec3& x) : row(grid.dims[0]), slice(int64_t{grid.dims[0]} * grid.dims[1])
    {
        const auto u = voxel_position(grid, x);
        for (int a = 0; a < 3; ++a)
            axis[a] = cubic_weights(u[a], grid.dims[a]);
        start = grid.index(axis[0].first, axis[1].first, axis[2].first);
    }

    double value(const float* field) const
    {
        double f = 0;
        for (int k = 0; k < axis[2].count; ++k) {
            double plane = 0;
            for (int j = 0; j < axis[1].count; ++j) {
                const float* p = field + start + j * row + k * slice;
                double sum = 0;
                for (int i = 0; i < axis[0].count; ++i)
                    sum += axis[0].w[i] * double{p[i]};
                plane += axis[1].w[j] * sum;
            }
            f += axis[2].w[k] * plane;
        }
        return f;
    }

    // The gradient is by voxel index.
    double value(const float* field, Vec3& gradient) const
    {
        double f = 0;
        gradient.setZero();
        for (int k = 0; k < axis[2].count; ++k)
            for (int j = 0; j < axis[1].count; ++j) {
                const float* p = field + start + j * row + k * slice;
                double sum = 0, slope = 0;
                for (int i = 0; i < axis[0].count; ++i) {
                    sum += axis[0].w[i] * double{p[i]};
                    slope += axis[0].dw[i] * double{p[i]};
                }
                const double wy = axis[1].w[j], wz = axis[2].w[k];
                f += wy * wz * sum;
                gradient += Vec3(wy * wz * slope, axis[1].dw[j] * wz * sum, wy * axis[2].dw[k] * sum);
            }
        return f;
    }
};

void name_materials(const IndicatorField& field, Samples& out)
{
    out.material.resize(field.material_count());
    out.value.resize(field.material_count());
    std::iota(out.material.begin(), out.material.end(), 0);
}

// Which of value(0) .. value(count - 1) wins.
template <class Value>
Material greatest(int64_t count, const Value& value)
{
    CLEFT_ASSERT(count > 0);
    Material best = 0;
    auto most = value(0);
    for (Material i = 1; i < count; ++i) {
        const auto f = value(i);
        if (wins(f, i, most, best)) {
            most = f;
            best = i;
        }
    }
    return best;
}

// See IndicatorField::rest.
// Equality is exact on purpose. Who makes such a function by negating a maximum loses no bit, and a near miss is
// another function.
int32_t find_rest(const Array<Array<float>>& field, const Run& run)
{
    // Some milliseconds per function. The loop ends early for functions that have no such field, since the candidates
    // run out.
    constexpr size_t kVoxelsACheck = size_t{1} << 20;
    Array<Material> candidates(field.size());
    std::iota(candidates.begin(), candidates.end(), 0);
    for (size_t v = 0; v < field[0].size() && !candidates.empty(); ++v) {
        if (v % kVoxelsACheck == 0)
            run.check();
        const auto value = [&](Material k) { return field[k][v]; };
        const Material first = greatest(field.count(), value);
        float second = -std::numeric_limits<float>::infinity();
        for (Material k = 0; k < field.count(); ++k)
            if (k != first)
                second = std::max(second, value(k));
        const auto is_other = [&](Material k) { return value(k) != -(k == first ? second : value(first)); };
        candidates.erase(std::remove_if(candidates.begin(), candidates.end(), is_other), candidates.end());
    }
    return candidates.empty() ? -1 : candidates[0];
}

// The entry of the greatest of all but the field `rest`.
Material greatest_but(const Samples& samples, Material rest)
{
    return greatest(samples.value.count(), [&](Material k) {
        return k == rest ? -std::numeric_limits<double>::infinity() : samples.value[k];
    });
}

}  // namespace

template <class Value>
IndicatorField make_indicators(const Array<const Value*>& fields, const Grid& grid, const Run& run)
{
    IndicatorField out;
    Steps steps(run, {{nullptr, 1}, {nullptr, 1}});
    out.grid = grid;
    out.field = bounded_values(fields, grid, steps.next());
    check_claims(out.field, grid, run);
    if (!out.is_signed())
        out.rest = find_rest(out.field, run);
    find_single_blocks(out, steps.next());
    return out;
}

template IndicatorField make_indicators(const Array<const float*>&, const Grid&, const Run&);
template IndicatorField make_indicators(const Array<const double*>&, const Grid&, const Run&);

Material voxel_material(const IndicatorField& field, int64_t voxel)
{
    if (field.is_signed())
        return field.field[0][voxel] > 0 ? 1 : 0;
    return greatest(field.field.count(), [&](Material k) { return field.field[k][voxel]; });
}

Material material_at(const IndicatorField& field, const Vec3& x)
{
    const Stencil stencil(field.grid, x);
    const auto value = [&](Material k) { return stencil.value(field.field[k].data()); };
    if (field.is_signed())
        return value(0) > 0 ? 1 : 0;
    const Material best = greatest(field.field.count(), [&](Material k) {
        return k == field.rest ? -std::numeric_limits<double>::infinity() : value(k);
    });
    if (field.rest < 0)
        return best;
    const double lead = value(best);
    return lead > 0 || (lead == 0 && best < field.rest) ? best : field.rest;
}

void sample(const IndicatorField& field, const Vec3& x, Samples& out)
{
    const Stencil stencil(field.grid, x);
    name_materials(field, out);
    for (Material k = 0; k < field.field.count(); ++k)
        if (k != field.rest)
            out.value[k] = stencil.value(field.field[k].data());
    if (field.is_signed()) {
        out.value[1] = out.value[0];
        out.value[0] = -out.value[1];
    } else if (field.rest >= 0) {
        out.value[field.rest] = -out.value[greatest_but(out, field.rest)];
    }
}

void sample_gradient(const IndicatorField& field, const Vec3& x, Samples& out)
{
    const Stencil stencil(field.grid, x);
    name_materials(field, out);
    out.gradient.resize(out.size());
    for (Material k = 0; k < field.field.count(); ++k) {
        if (k == field.rest)
            continue;
        out.value[k] = stencil.value(field.field[k].data(), out.gradient[k]);
        out.gradient[k] = out.gradient[k].cwiseQuotient(field.grid.spacing).eval();
    }
    if (field.is_signed()) {
        out.value[1] = out.value[0];
        out.value[0] = -out.value[1];
        out.gradient[1] = out.gradient[0];
        out.gradient[0] = -out.gradient[1];
    } else if (field.rest >= 0) {
        const Material other = greatest_but(out, field.rest);
        out.value[field.rest] = -out.value[other];
        out.gradient[field.rest] = -out.gradient[other];
    }
}

}  // namespace cleft
