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
// Improving adds some that hardly have such points. Where nothing snaps, more of them are there at once.
double tet_bytes(const ExpectedMesh& mesh, const PipelineOptions& options)
{
    constexpr double kCut = 550, kCutOfNone = 700, kGrown = 400;
    const double cut = options.cleave.snap == Snap::none ? kCutOfNone : kCut;
    return row_of(options.background.kind).bytes_a_tet * mesh.background_tets +
           cut * std::max(0.0, mesh.cleaved_tets - mesh.background_tets) +
           kGrown * std::max(0.0, mesh.whole_tets - mesh.cleaved_tets);
}

// For the tries of improving, which hold the best mesh beside the one they work at. Larger meshes have none.
double try_bytes(const ExpectedMesh& mesh, const PipelineOptions& options)
{
    constexpr double kMostTets = 200000, kTry = 60, kTryOfBest = 150;
    return (options.improve.effort == Effort::best ? kTryOfBest : kTry) * std::min(kMostTets, mesh.whole_tets);
}

// The largest mesh that may be made. A search makes some, of up to so many times the wanted number.
double most_times(const ExpectedMesh& mesh, const PipelineOptions& options)
{
    constexpr double kSearched = 1.15, kRough = 1.45;
    return mesh.is_rough ? kRough : options.tets > 0 ? kSearched : 1;
}

double peak_bytes(const Volume& volume, const ExpectedMesh& mesh, const PipelineOptions& options)
{
    constexpr double kProgram = 3e7;
    return kProgram + voxel_bytes(volume) * static_cast<double>(volume.grid().size()) +
           most_times(mesh, options) * (tet_bytes(mesh, options) + try_bytes(mesh, options));
}

Estimate estimate_of(const Volume& volume, const ExpectedMesh& mesh, const PipelineOptions& options)
{
    return {mesh, peak_bytes(volume, mesh, options)};
}

ExpectedMesh times(const ExpectedMesh& mesh, double factor)
{
    return {factor * mesh.background_tets, factor * mesh.cleaved_tets, factor * mesh.whole_tets,
            factor * mesh.kept_tets, mesh.is_rough};
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
    return estimate_of(volume, times(expected, factor_of_search(expected, options)), options);
}

Estimate estimate_from_background(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                  const Run& run)
{
    // A background of the user is repaired as one of particles is.
    PipelineOptions of_particles = options;
    of_particles.background.kind = BackgroundKind::particles;
    of_particles.tets = 0;  // a background decides alone
    return estimate_of(volume, expected_mesh(volume, background, of_particles, run), of_particles);
}

}  // namespace cleft
