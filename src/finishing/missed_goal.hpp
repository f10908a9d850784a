// Reports the shapes that improving could not bring to its goal.
#pragma once

#include "base/run.hpp"
#include "finishing/pipeline_options.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Whether anybody is told. Who leaves out improving knows that angles will be bad, and without a caller for warnings
// or figures there is nobody to tell. Of several ranks, others may have one.
bool tells_of_missed_goal(const PipelineOptions& options, int32_t ranks, const Run& run);

// Tetrahedra beyond the goal, and the worst of them.
struct Missed {
    int64_t tets = 0;
    double least_quality = 1;
    Vec3 worst = Vec3::Zero();  // the centroid of the first tetrahedron of that quality

    void join(const Missed& next);
};

struct MissedGoal {
    Missed angles, ratios;  // the second where the angles are met
    double least = 180, greatest = 0;

    void join(const MissedGoal& next);
};

// Of the tetrahedra that are kept.
MissedGoal missed_goal(const LabelledMesh& mesh, const PipelineOptions& options, const Run& run);

// Warns in one sentence if there are tetrahedra with an angle beyond the goal, and in another one if there are some of
// which only the radius ratio is.
void warn_of_missed_goal(const MissedGoal& missed, const Grid& grid, const PipelineOptions& options, const Run& run);

}  // namespace cleft
