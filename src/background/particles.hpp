// The paper's background mesh: electrostatic particles relaxed to the sizing field, then Delaunay, then repair.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "delaunay/delaunay.hpp"
#include "mesh/tet_mesh.hpp"
#include "sizing/sizing_field.hpp"

#include <cstdint>

namespace cleft
{

struct ParticleOptions {
    int steps = 8;      // relaxation steps
    uint64_t seed = 0;  // varies the arrangement; the same seed gives the same bytes
    DelaunayEngine delaunay = DelaunayEngine::cleft;
};

// Particles on the two walls across the last axis, corners and edges included, where another box has them already.
struct GivenWalls {
    const Array<Vec3>* low = nullptr;  // null: as the sizes ask for
    const Array<Vec3>* high = nullptr;

    bool any() const { return low || high; }
};

// Relaxed particles of the box [0, grid.extent()]: the 8 corners first, then edges, faces, inside. A particle of a box
// face has that coordinate exactly equal to 0 or the extent.
// Notes background.particles, background.step.N.movement (rms, in h), background.step.N.density_error, ...
Array<Vec3> relaxed_particles(const SizingField& field, const ParticleOptions& options, const GivenWalls& given,
                              const Run& run);

// delaunay, repair. Particles of the numbers `held`, which are on a wall, stay where they are, and so do the triangles
// between them.
TetMesh mesh_of_particles(Array<Vec3> particles, const Array<int32_t>& held, const ParticleOptions& options,
                          const Run& run);

// Both.
TetMesh particle_background(const SizingField& field, const ParticleOptions& options, const Run& run);

}  // namespace cleft
