// Memory from the expected number of tetrahedra, for the sizes that the search for a wanted number ends at.
#include "pipeline/estimate.hpp"

#include "pipeline/number_search.hpp"

namespace cleft
{

namespace
{

// What real volumes took, rounded up: for the program, a voxel and a tetrahedron. Where labels are many, tables for
// each label add to it.
double peak_bytes(const Volume& volume, const ExpectedMesh& mesh)
{
    // Users choose a machine by this, so each is rounded up: too little would end a run, a little too much costs
    // nothing.
    constexpr double kProgram = 3e7, kVoxel = 12, kTet = 200, kTetOfManyLabels = 420;
    return kProgram + kVoxel * static_cast<double>(volume.grid().size()) +
           (mesh.is_bound ? kTetOfManyLabels : kTet) * mesh.whole_tets;
}

Estimate estimate_of(const Volume& volume, const ExpectedMesh& mesh) { return {mesh, peak_bytes(volume, mesh)}; }

ExpectedMesh times(const ExpectedMesh& mesh, double factor)
{
    return {factor * mesh.background_tets, factor * mesh.whole_tets, factor * mesh.kept_tets, mesh.is_bound};
}

}  // namespace

Estimate estimate_from_sizing(const Volume& volume, ScaledSizing sizing, const PipelineOptions& options, const Run& run)
{
    scale_by_estimate(sizing, volume, options, run);
    const ExpectedMesh expected = expected_mesh(volume, sizing.field, options, run);
    // The search goes on by meshing, to the number itself.
    // So the estimate is of the wanted number, and not of what the fitted sizes are expected to give.
    const bool is_searched = options.tets > 0 && expected.kept_tets > 0;
    return estimate_of(
        volume, is_searched ? times(expected, static_cast<double>(options.tets) / expected.kept_tets) : expected);
}

Estimate estimate_from_background(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                  const Run& run)
{
    return estimate_of(volume, expected_mesh(volume, background, options.kept, run));
}

}  // namespace cleft
