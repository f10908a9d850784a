// Improving: raises the least dihedral angles of a cleaved mesh; interfaces, triple lines and the box stay.
#pragma once

#include "base/run.hpp"
#include "remeshing/local_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

/* <choice> Made by tools/generate.py from src/capi/options.toml. */
enum class Effort { off, fast, best };
inline constexpr size_t kEffortCount = 3;
/* </choice> */

struct ImproveOptions {
    Effort effort = Effort::fast;
    double min_angle = 0;  // degrees; 0: as much as the effort can reach
    double margin = 0;     // degrees; aims so much higher, which leads to another mesh
};

// Degrees. Decision 13 says what the numbers rest on.
inline double target_angle(const ImproveOptions& options)
{
    constexpr double kUsual = 25, kBest = 32;
    if (options.min_angle > 0)
        return options.min_angle;
    return options.effort == Effort::best ? kBest : kUsual;
}

// In degrees above the target. A search that aims a little higher takes other ways, few of which end at the same bad
// tetrahedra.
// They are tried in turn until no tetrahedron is short of the target. A higher aim counts more tetrahedra as bad, and
// takes longer.
inline constexpr double kHigherAims[] = {1, 2, 0.5, 3};

// The tetrahedra that are short of the target, and the work that it took.
struct Shortfall {
    int64_t tets = 0;
    double least = 1;    // the least quality of all, see shape_quality
    int64_t places = 0;  // see SearchCounts
};

// Never inverts a tetrahedron, never changes which materials touch. Notes improving.*.
// The points must be in the frame of `volume`, where lengths are world units.
Shortfall improve(LocalMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run);
void improve(LabelledMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run);

}  // namespace cleft
