// Memory from the expected number of tetrahedra, for the sizes that the search for a wanted number ends at.
#include "pipeline/estimate.hpp"

#include "pipeline/number_search.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Users choose a machine by this, so each figure is rounded up: too little would end a run, a little too much costs
// nothing. They are what volumes of docs/quality.md, noise, checkers and plates took on all backgrounds.

// For reading and sizing. A file of indicator functions may hold doubles, which are read before the volume keeps
// floats.
double voxel_bytes(const Volume& volume)
{
    constexpr double kLabels = 15, kDoubleAndFloat = 12, kFloat = 4, kSizing = 12;
    const auto functions = static_cast<double>(volume.indicator_count());
    return volume.is_label_map() ? kLabels : std::max(kDoubleAndFloat * functions, kFloat * functions + kSizing);
}

// For the background, and for the tetrahedra that cutting adds, with all that is known of the points at interfaces.
double tet_bytes(const ExpectedMesh& mesh, BackgroundKind kind)
{
    constexpr double kCut = 450;
    return row_of(kind).bytes_a_tet * mesh.background_tets +
           kCut * std::max(0.0, mesh.whole_tets - mesh.background_tets);
}

double peak_bytes(const Volume& volume, const ExpectedMesh& mesh, BackgroundKind kind)
{
    constexpr double kProgram = 3e7;
    return kProgram + voxel_bytes(volume) * static_cast<double>(volume.grid().size()) + tet_bytes(mesh, kind);
}

Estimate estimate_of(const Volume& volume, const ExpectedMesh& mesh, BackgroundKind kind)
{
    return {mesh, peak_bytes(volume, mesh, kind)};
}

ExpectedMesh times(const ExpectedMesh& mesh, double factor)
{
    return {factor * mesh.background_tets, factor * mesh.whole_tets, factor * mesh.kept_tets, mesh.is_bound};
}

}  // namespace

Estimate estimate_from_volume(const Volume& volume, const PipelineOptions& options, const Run& run)
{
    return estimate_from_sizing(volume, {sizes_of(volume, options, run)}, options, run);
}

Estimate estimate_from_sizing(const Volume& volume, ScaledSizing sizing, const PipelineOptions& options, const Run& run)
{
    scale_by_estimate(sizing, volume, options, run);
    const ExpectedMesh expected = expected_mesh(volume, sizing.field, options, run);
    // The search goes on by meshing, to the number itself.
    // So the estimate is of the wanted number, and not of what the fitted sizes are expected to give.
    const bool is_searched = options.tets > 0 && expected.kept_tets > 0;
    return estimate_of(volume,
                       is_searched ? times(expected, static_cast<double>(options.tets) / expected.kept_tets) : expected,
                       options.background.kind);
}

Estimate estimate_from_background(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                  const Run& run)
{
    // A background of the user is repaired as one of particles is.
    return estimate_of(volume, expected_mesh(volume, background, options.kept, run), BackgroundKind::particles);
}

}  // namespace cleft
