// First places for the particles, in proportion to the charge: a lattice where h is constant, error diffusion along a
// Hilbert curve elsewhere.
#pragma once

#include "background/charge.hpp"
#include "background/particle_set.hpp"
#include "base/run.hpp"

#include <cstdint>

namespace cleft
{

struct Seeds {
    ParticleSet particles;  // the 8 corners first
    bool at_rest = false;   // all of it is one perfect lattice
};

// `variation` shifts the curve and the phase of the diffusion.
Seeds seed_particles(const SizingField& field, const SizeSampler& size, uint64_t variation, const Run& run);

}  // namespace cleft
