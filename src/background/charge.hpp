// How many particles the sizing field asks for, and h read fast at any point.
//
// Particles in a volume have density 1.75 / h^3: with it the Delaunay edges of a relaxed arrangement have length h on
// average. Each box wall carries its own layer of particles, which stands for the charge of a slab behind it: a
// particle on a wall belongs to the box by one half (on an edge of the box by a quarter, in a corner by an eighth).
#pragma once

#include "base/fixed_array.hpp"
#include "base/mix.hpp"
#include "sizing/sizing_field.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

namespace cleft
{

// Particles per h^D on a part of the box of dimension D: a corner, an edge, a face, the inside.
// The inside has what relaxed particles need for a mean edge of h. On a face, a triangular lattice of edge h would have
// 1.15.
constexpr std::array<double, 4> kParticleDensity{1.0, 1.0, 1.2, 1.75};

// The divergence of the field of the background, times h^3: a charge of density q has one of 4 pi q (Gauss).
constexpr double kBackgroundDivergence = 4 * 3.14159265358979323846 * kParticleDensity[3];

// Thickness, in h, of the layer of a part of dimension D that the particles on its border stand for.
constexpr double border_layer(size_t dimension)
{
    return 0.5 * kParticleDensity[dimension - 1] / kParticleDensity[dimension];
}

// SizingField::at in single precision, for the inner loops: h is read some hundred times a particle.
class SizeSampler
{
public:
    struct Table {
        const float* h;
        FixedArray<float, 3> walls{};     // the far ones, in voxels
        FixedArray<int32_t, 3> last{};    // the greatest lower corner
        FixedArray<int32_t, 3> stride{};  // 0 where there is one voxel only
    };

    explicit SizeSampler(const SizingField& field)
        : extent_(field.grid.extent()), inverse_spacing_(field.grid.spacing.cwiseInverse()), table_{field.h.data()}
    {
        int32_t stride = 1;  // a sizing field has less than 2^31 voxels
        for (int a = 0; a < 3; ++a) {
            const int32_t cells = field.grid.dims[a];
            table_.walls[a] = static_cast<float>(cells) - 0.5F;
            table_.last[a] = std::max(0, cells - 2);
            table_.stride[a] = cells > 1 ? stride : 0;
            stride *= cells;
        }
    }

    const Vec3& extent() const { return extent_; }
    const Table& table() const { return table_; }

    // h at x; a point outside the box is read at the nearest voxel centre.
    float operator()(const Vec3& x) const { return at_voxel(to_voxels(x)); }

    // Positions in voxels, 0 at the centre of the first.
    Eigen::Array3f to_voxels(const Vec3& x) const
    {
        return (x.cwiseProduct(inverse_spacing_).array() - 0.5).cast<float>();
    }
    Eigen::Array3f length_to_voxels(float length) const
    {
        return (static_cast<double>(length) * inverse_spacing_).cast<float>();
    }
    // Past the outermost centres as at the nearest of them.
    float at_voxel(const Eigen::Array3f& u) const
    {
        FixedArray<float, 3> t;
        const float* corner = table_.h;
        for (int a = 0; a < 3; ++a) {
            const float v = std::max(0.0F, std::min(u[a], table_.walls[a]));
            const int32_t voxel = std::min(static_cast<int32_t>(v), table_.last[a]);
            t[a] = std::min(v - static_cast<float>(voxel), 1.0F);
            corner += voxel * table_.stride[a];
        }
        const auto row = [&](const float* p) { return mix(p[0], p[table_.stride[0]], t[0]); };
        const auto plane = [&](const float* p) { return mix(row(p), row(p + table_.stride[1]), t[1]); };
        return mix(plane(corner), plane(corner + table_.stride[2]), t[2]);
    }

private:
    Vec3 extent_, inverse_spacing_;
    Table table_;
};

}  // namespace cleft
