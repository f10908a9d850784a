// The sizing field h(x): the wanted edge length of tetrahedra, in world units, gradation-Lipschitz.
#pragma once

#include "base/array.hpp"
#include "base/error.hpp"
#include "base/mix.hpp"
#include "base/run.hpp"
#include "metric/metric_field.hpp"
#include "volume/kept_materials.hpp"
#include "volume/volume.hpp"

#include <algorithm>
#include <memory>

namespace cleft
{

// Values at the voxel centres of the grid; read between them by trilinear interpolation, constant past the outermost.
struct SizeRange {
    double least, greatest;

    bool is_one_size() const { return least == greatest; }
};

struct SizingField {
    Grid grid;
    Array<float> h;
    double gradation = 0.3;
    // Wanted lengths by direction, on the same grid; null: they are the same in all. With a metric, h is the size of
    // regular tetrahedra that are as large. Shared, since meshes go on being measured by it.
    std::shared_ptr<const MetricField> metric = nullptr;
    // The voxel that `h` begins with. A part of a large field holds whole planes across the last axis.
    int64_t first = 0;

    // Of a point in the local frame; past the outermost centres as at the nearest of them.
    double at(const Vec3& x) const;
    // Of the values at the voxels; interpolation stays between them.
    SizeRange range() const;
};

// In the header because particles ask for it a hundred times each.
inline double SizingField::at(const Vec3& x) const
{
    int64_t corner = -first;
    double t[3];
    int64_t step[3];
    int64_t stride = 1;
    for (int a = 0; a < 3; ++a) {
        const int32_t n = grid.dims[a];
        // The order of the arguments makes a NaN 0 instead of an index.
        const double u = std::min(std::max(0.0, x[a] / grid.spacing[a] - 0.5), static_cast<double>(n - 1));
        const int32_t low = std::min(static_cast<int32_t>(u), std::max(n - 2, 0));
        t[a] = u - low;
        step[a] = n > 1 ? stride : 0;
        corner += low * stride;
        stride *= n;
    }
    CLEFT_ASSERT(corner >= 0 && corner + step[0] + step[1] + step[2] < h.count());
    const float* const low = h.data() + corner;
    const auto along_x = [&](const float* p) { return mix(double{p[0]}, double{p[step[0]]}, t[0]); };
    const auto in_plane = [&](const float* p) { return mix(along_x(p), along_x(p + step[1]), t[1]); };
    return mix(in_plane(low), in_plane(low + step[2]), t[2]);
}

// Throws for a size that is no size (is_size() in volume/limits.hpp).
SizingField constant_sizing(const Grid& grid, double size);
// User-supplied values (positive, finite; an Error names the first that is not), taken as they are.
template <class Value>  // float or double
SizingField sizing_from_values(const Grid& grid, const Value* values);

// What to throw for a value that is not positive and finite.
Error bad_sizing_value(double value, int64_t voxel, const Grid& grid);

// Tetrahedra that the particle background would have.
double expected_particle_tets(const SizingField& field);
// Those of them in the voxels of the kept materials.
double expected_particle_tets(const SizingField& field, const Volume& volume, const KeptMaterials& kept);
// Every value times `factor`, and then as much less as the gradation asks for: sizes at the interfaces scale, their
// growth away from them does not. A metric is scaled as it is.
void scale_sizing(SizingField& field, double factor, const Run& run);

}  // namespace cleft
