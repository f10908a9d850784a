// Lets the stage read the materials of a Volume, which it knows only as a Labelling.
#include "sizing/volume_sizing.hpp"

#include "base/stage.hpp"
#include "sizing/compute.hpp"
#include "sizing/surface_sizes.hpp"

namespace cleft
{

SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run)
{
    const auto read = [&volume](int64_t first, int64_t count, Material* out) {
        volume.voxel_materials(first, count, out);
    };
    const bool is_limited = options.surface_error > 0 && options.size <= 0;
    Steps steps(run, {{is_limited ? "sizing: curvature" : nullptr, is_limited ? 1.0 : 0}, {nullptr, 1}});
    const Run of_curvature = steps.next();
    check_size("surface_error", options.surface_error);
    const Array<SizeLimit> limits =
        is_limited ? sizes_for_error(volume, options.surface_error, of_curvature) : Array<SizeLimit>();
    return compute_sizing(Labelling{volume.grid(), read}, options, steps.next(), limits);
}

}  // namespace cleft
