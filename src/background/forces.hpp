// The near electrostatic forces on particles, unit charges, in units of 1 / h^2 of the particle that they act on.
//
// The field of a charge at a particle is split in two: within the particle's reach R = 1.7 h, the field of the point
// charge less that of a cloud of the same charge, radius R and density 1 / (2 pi R^2 r), which is (1 - r^2/R^2) / r^2
// and vanishes at R with no jump; and the field of the cloud, which is smooth and left to the waves of long_waves.hpp.
// The charge of the background, c / h^3, is split in the same way; its near field is a sum over directions.
// The walls are mirrors: every charge has its images behind them.
#pragma once

namespace cleft
{

// The reach R of a particle in units of its h.
// A sphere of this radius holds some 36 particles. A greater reach costs with its cube, and a smaller one needs a finer
// grid for the waves.
constexpr float kReach = 1.7F;

}  // namespace cleft
