// Better shapes for a mesh of one material: flips and moves of points, where no boundary of materials is in the way.
#pragma once

#include "base/run.hpp"
#include "remeshing/worst_first.hpp"

namespace cleft
{

// The sweep mends most of what is better than this, and may leave a tetrahedron as bad as this.
inline constexpr double kSweepAngle = 22;  // degrees

class ShapeRepair
{
public:
    explicit ShapeRepair(LocalMesh& mesh) : mesh_(mesh) {}

    // Passes over the tetrahedra with a worse angle (degrees), until none is left or nothing helps.
    void improve_bad(double angle, int passes, bool with_moves, const Run& run);
    // One Gauss-Seidel sweep of points of poor tetrahedra towards the centroids of their stars. In a mesh of the wanted
    // sizes every tetrahedron weighs the same: a volume over the wanted volume is about one.
    void smooth_poor(const Run& run);

private:
    LocalMesh& mesh_;
    WorstFirst bad_;
};

}  // namespace cleft
