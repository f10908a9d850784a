// Particles move under their electrostatic forces until they are evenly spread in the charge.
#pragma once

#include "background/charge.hpp"
#include "background/particle_set.hpp"
#include "base/run.hpp"

namespace cleft
{

// `steps` steps of damped motion of those that are not fixed. The order of the particles becomes that of ParticleTree.
// Notes, for N = 1 .. steps, background.step.N.movement (root of the mean square, in h) and
// background.step.N.density_error (before the step, see solve_poisson).
void relax(ParticleSet& particles, const SizingField& field, const SizeSampler& size, int steps, const Run& run);

}  // namespace cleft
