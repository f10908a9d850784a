// Where h is constant the best arrangement is known: the body-centred cubic lattice, whose tetrahedra all have angles
// of 60 and 90 degrees. Patches of one lattice, aligned with the walls, fill the places where h has its greatest value.
#pragma once

#include "background/charge.hpp"
#include "background/particle_set.hpp"
#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/run.hpp"

namespace cleft
{

struct BccPatches {
    FixedArray<int32_t, 3> cells{0, 0, 0};  // of the whole lattice; zero: there is no lattice
    Vec3 cell{1, 1, 1};
    Vec3 extent{0, 0, 0};
    Array<uint8_t> corner_used, centre_used;

    bool empty() const { return cells[0] == 0; }
    bool fill_the_box() const;  // every point is used
    // True where the nearest lattice point is used, so that other particles must keep out. A point on walls looks at
    // the lattice points of these walls alone.
    bool owns(const Vec3& x, Walls walls) const;
    // All but the corners of the box, which seeding puts first.
    void add_particles(ParticleSet& out) const;
};

// The number of cells of the lattice that fills a box in which h has this one value; 0 where none is used.
double cells_of_constant_size(const Grid& grid, double size);

// None where the lattice would have to be stretched by more than a tenth to fit between the walls.
BccPatches constant_size_patches(const SizingField& field, const SizeSampler& size, const Run& run);

}  // namespace cleft
