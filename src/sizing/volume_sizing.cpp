// Lets the stage read the materials of a Volume, which it knows only as a Labelling.
#include "sizing/volume_sizing.hpp"

#include "base/stage.hpp"
#include "sizing/surface_sizes.hpp"

namespace cleft
{

SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run)
{
    check_size("surface_error", options.surface_error);
    const double error = error_of_sizes(options);
    // Of the curvature too: it replaces the figures of the stage within.
    const StageTimer timer(run, "sizing");
    Steps steps(run, {{error > 0 ? "sizing: curvature" : nullptr, error > 0 ? 1.0 : 0}, {nullptr, 1}});
    const Run of_curvature = steps.next();
    return compute_sizing(volume, options,
                          error > 0 ? sizes_for_error(volume, error, of_curvature) : Array<SizeLimit>(), steps.next());
}

SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Array<SizeLimit>& limits,
                           const Run& run)
{
    const auto read = [&volume](int64_t first, int64_t count, Material* out) {
        volume.voxel_materials(first, count, out);
    };
    return compute_sizing(Labelling{volume.grid(), read}, options, run, limits);
}

double error_of_sizes(const SizingOptions& options) { return options.size <= 0 ? options.surface_error : 0; }

}  // namespace cleft
