// The smooth part of the electric field, from the Poisson equation  laplacian(u) = -4 pi (particles - background)  on
// a grid. The boundary condition is Neumann's, no field across the walls (they are mirrors), so that cosines are the
// waves of the box.
//
// What forces.hpp leaves over is the field of clouds as large as the reach of the particle that feels it: a wave of
// wave number k is multiplied by (sin(k R / 2) / (k R / 2))^2. So there is a potential for each of a few reaches, each
// twice the one before and on a grid half as fine, and a particle reads the two around its own.
// Where a grid as fine as the least reach would have too many cells, the shortest waves are left out: small particles
// then do without the forces from between their reach and the spacing.
#pragma once

#include "background/charge.hpp"
#include "background/particle_set.hpp"
#include "base/array.hpp"
#include "base/fixed_array.hpp"

namespace cleft
{

struct LongWaves {
    using Matrix = Eigen::Matrix<float, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;
    using Cells = FixedArray<int32_t, 3>;
    struct Level {
        double reach = 0;
        Cells cells{1, 1, 1};
        FixedArray<Matrix, 3> from_waves;  // by axis, to the coefficients of quadratic splines
        Array<float> potential;            // these coefficients
    };
    Vec3 extent{0, 0, 0};
    Array<Level> levels;             // least reach first; none: the box is too small for waves
    FixedArray<Matrix, 3> to_waves;  // from charges put on the finest grid by quadratic splines
    Array<float> background;         // the charge in the cells of the finest grid
    Array<float> background_waves;
};

// `particles`: the ones to come, or others of the same total charge.
LongWaves make_long_waves(const SizeSampler& size, double least_size, double greatest_size,
                          const ParticleSet& particles, const Run& run);

// The potentials for the particles. Returns the density error: in bricks of 4 x 4 x 4 cells with n particles and the
// charge q, the root of sum (n - q)^2 / sum q^2.
double solve_poisson(LongWaves& waves, const ParticleSet& particles, const Run& run);

// - grad u at x, for a unit charge that repels by itself what is within reach.
Vec3 field_at(const LongWaves& waves, const Vec3& x, double reach);

}  // namespace cleft
