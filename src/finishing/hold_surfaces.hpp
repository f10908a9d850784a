// Keeps triangles within the error of their interface while shapes are improved.
#pragma once

#include "improving/improve.hpp"

namespace cleft
{

// Lines come onto their ties before shapes are improved, and edges of interfaces are split that are further off than
// `error`, in world units. Improving keeps points on their ties, and makes good what that costs. After it, the shapes
// let only half of the points get there. Notes surfaces.*. Does nothing, and returns false, where the sizes were made
// for something else.
bool hold_surfaces(LocalMesh& mesh, const Volume& volume, double error, const Run& run);

// Improving may have joined edges to longer ones, and points that moved may let go what a split would have cost before.
// `before`: what improving has left. Returns what is left then. Notes surfaces_again.*.
Shortfall hold_surfaces_again(LocalMesh& mesh, const Volume& volume, double error, const ImproveOptions& options,
                              const Shortfall& before, const Run& run);

}  // namespace cleft
