// Improving and fitting, in turn where there is little room.
#include "finishing/improve_and_fit.hpp"

#include "base/number_text.hpp"
#include "base/stage.hpp"
#include "finishing/best_of_tries.hpp"
#include "fitting/fit_volumes.hpp"

namespace cleft
{

namespace
{

// Where a part is hardly thicker than its tetrahedra, shapes at the target leave the interface no room to move. So it
// moves first, with worse shapes, and these are improved again.
void fit_with_more_room(LocalMesh& mesh, const Volume& volume, const ImproveOptions& options, double surface_error,
                        const Array<double>* volumes, const Run& run)
{
    // Shells one voxel thick came from 5 % to 3 % of their volume at 25 degrees. A second turn brought no more.
    constexpr double kRoom = 0.8;
    Steps steps(run, {{nullptr, 1}, {nullptr, 2}, {nullptr, 1}});
    const double target = target_angle(options);
    fit_volumes(mesh, volume, kRoom * target, steps.next(), surface_error, volumes);
    // The figures of improving are to be those of the first time, which had the work.
    Run again = steps.next();
    again.metrics = nullptr;
    improve(mesh, volume, options, again);
    fit_volumes(mesh, volume, target, steps.next(), surface_error, volumes);
}

void warn_of_unused_error(const PipelineOptions& options, const Run& run)
{
    if (options.asks_surface_error)
        run.warn(
            "surface_error " + number_text(options.sizing.surface_error) +
            " has no effect on the triangles: too many of them are further off, so the sizes are for something else");
}

}  // namespace

LabelledMesh improve_and_fit(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options,
                             const Run& run)
{
    if (options.improve.effort == Effort::off)
        return cleaved(run);
    // Fitting comes second: it keeps the angles that improving has reached, whereas improving would undo volumes.
    Steps steps(run, {{nullptr, 74}, {nullptr, 26}, {nullptr, 0}});
    auto [mesh, holds_surfaces] = best_of_tries(volume, cleaved, options, steps.next());
    if (!holds_surfaces)
        warn_of_unused_error(options, run);
    const double surface_error = holds_surfaces ? options.sizing.surface_error : 0;
    const Array<double>* const volumes = options.region ? &options.region->volumes : nullptr;
    const bool is_met = fit_volumes(mesh, volume, target_angle(options.improve), steps.next(), surface_error, volumes);
    if (!is_met)
        fit_with_more_room(mesh, volume, options.improve, surface_error, volumes, steps.next());
    return mesh.take(run);
}

PipelineOptions measured_by(const MetricField* metric, const PipelineOptions& options)
{
    PipelineOptions measured = options;
    if (metric) {
        measured.cleave.metric = metric;
        measured.wants_lengths = true;
        measured.of_world = nullptr;  // a metric of sizes is one of the world
    }
    return measured;
}

}  // namespace cleft
