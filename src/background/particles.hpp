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

// Relaxed particles of the box [0, grid.extent()]: the 8 corners first, then edges, faces, inside. A particle of a box
// face has that coordinate exactly equal to 0 or the extent.
// Notes background.particles, background.step.N.movement (rms, in h), background.step.N.density_error, ...
Array<Vec3> relaxed_particles(const SizingField& field, const ParticleOptions& options, const Run& run);

// relaxed_particles, delaunay, repair.
TetMesh particle_background(const SizingField& field, const ParticleOptions& options, const Run& run);

}  // namespace cleft
