// Volumes from the arrays of a caller: all that is uncertain about them is refused here, before a stage sees it.
#include "capi/firewall.hpp"
#include "capi/kept_labels.hpp"
#include "capi/made_volume.hpp"
#include "capi/options.hpp"
#include "capi/voxel_type.hpp"

using namespace cleft::capi;
using cleft::Error;
using cleft::Run;

namespace
{

// The elements are not copied here: bounded_values() reads each field in the type that it has.
template <class T>
cleft::Volume indicators(const void* const* fields, int64_t count, const cleft::Grid& grid, const int32_t* labels,
                         const Run& run)
{
    cleft::Array<const T*> typed;
    for (int64_t k = 0; k < count; ++k)
        typed.push_back(static_cast<const T*>(required(fields[k], "a field")));
    // A signed function has an outside too.
    const int64_t names = count == 1 ? 2 : count;
    return cleft::Volume::from_indicators(typed, grid,
                                          labels ? user_labels(labels, names) : cleft::Array<cleft::UserLabel>(), run);
}

}  // namespace

namespace cleft::capi
{

// Lists for the caller are made once, for the functions that lend them may be called from many threads.
cleft_volume made_volume(const Frame& frame, Volume&& volume)
{
    Array<Material> listed = volume.listed();
    Array<int32_t> labels;
    for (const Material m : listed)
        labels.push_back(number_of(volume.labels()[m]));
    return {{}, frame, std::move(volume), std::move(listed), std::move(labels), {}};
}

}  // namespace cleft::capi

cleft_status cleft_volume_create_labels(cleft_context* context, cleft_type type, const void* voxels,
                                        const int64_t dims[3], const double affine[12], const cleft_options* options,
                                        cleft_volume** out) noexcept
{
    return guarded_create(context, out, "volume", [&](const Run& run) {
        required(voxels, "voxels");
        if (options)
            checked(options, "options");
        const cleft::Frame frame = cleft::make_frame(required(dims, "dims"), affine);
        // Kept with the volume, since all stages must see the same interfaces.
        const int kernel = static_cast<int>(option_value(options, CLEFT_OPTION_SMOOTH));
        return made_volume(frame, cleft::Volume::from_labels(voxel_type(type), voxels, frame.grid, kernel, run));
    });
}

cleft_status cleft_volume_create_indicators(cleft_context* context, cleft_type type, const void* const* fields,
                                            int64_t count, const int64_t dims[3], const double affine[12],
                                            const int32_t* labels, cleft_volume** out) noexcept
{
    return guarded_create(context, out, "volume", [&](const Run& run) {
        required(fields, "fields");
        // Before any field is read: a wrong count would have the loop read pointers past the array.
        if (count < 1 || count > 65535)
            throw Error(CLEFT_ERROR_ARGUMENT, "count is " + std::to_string(count) + "; it must be 1 .. 65535");
        const cleft::Frame frame = cleft::make_frame(required(dims, "dims"), affine);
        if (type == CLEFT_TYPE_FLOAT32)
            return made_volume(frame, indicators<float>(fields, count, frame.grid, labels, run));
        if (type == CLEFT_TYPE_FLOAT64)
            return made_volume(frame, indicators<double>(fields, count, frame.grid, labels, run));
        throw Error(CLEFT_ERROR_ARGUMENT, "indicator functions must be FLOAT32 or FLOAT64");
    });
}

void cleft_volume_destroy(cleft_volume* volume) noexcept { destroy(volume); }

cleft_status cleft_volume_dims(const cleft_volume* volume, int64_t dims[3]) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(volume, "volume").frame.grid.dims;
        std::copy(from.begin(), from.end(), required(dims, "dims"));
    });
}

cleft_status cleft_volume_affine(const cleft_volume* volume, double affine[12]) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(volume, "volume").frame.affine;
        std::copy(from.begin(), from.end(), required(affine, "affine"));
    });
}

int64_t cleft_volume_label_count(const cleft_volume* volume) noexcept
{
    return is_sound(volume) ? static_cast<int64_t>(volume->labels.size()) : 0;
}

const int32_t* cleft_volume_labels(const cleft_volume* volume) noexcept
{
    return is_sound(volume) ? volume->labels.data() : nullptr;
}

int64_t cleft_volume_indicator_count(const cleft_volume* volume) noexcept
{
    return is_sound(volume) ? volume->volume.indicator_count() : 0;
}

cleft_status cleft_volume_set_label_name(cleft_volume* volume, int32_t label, const char* name) noexcept
{
    return guarded(nullptr, [&] {
        cleft_volume& v = checked(volume, "volume");
        set_label_name(v.names, v.labels, label, name, "the volume");
    });
}

const char* cleft_volume_label_name(const cleft_volume* volume, int32_t label) noexcept
{
    return is_sound(volume) ? label_name(volume->names, label) : "";
}

cleft_status cleft_volume_copy_voxel_counts(const cleft_volume* volume, int64_t* counts, int64_t capacity) noexcept
{
    return guarded(nullptr, [&] {
        required(counts, "counts");
        // Counted when asked for, since most programs never do.
        const cleft::Array<int64_t> all = checked(volume, "volume").volume.voxel_counts();
        if (capacity < static_cast<int64_t>(all.size()))
            throw Error(CLEFT_ERROR_BUFFER, "the buffer is too small");
        // In the order of cleft_volume_labels(), which is not that of the materials.
        std::transform(volume->listed.begin(), volume->listed.end(), counts, [&](cleft::Material m) { return all[m]; });
    });
}

cleft_status cleft_volume_sample(const cleft_volume* volume, const double* points, int64_t count,
                                 int32_t* labels) noexcept
{
    return guarded(nullptr, [&] {
        checked(volume, "volume");
        if (count < 0)
            throw Error(CLEFT_ERROR_ARGUMENT, "count is negative");
        // No points, no arrays: languages hand over NULL for an empty one.
        if (count == 0)
            return;
        required(points, "points");
        required(labels, "labels");
        for (int64_t i = 0; i < count; ++i) {
            const cleft::Vec3 world(points[3 * i], points[3 * i + 1], points[3 * i + 2]);
            if (!world.allFinite())
                throw Error(CLEFT_ERROR_NOT_FINITE, "a point is NaN or infinite");
            // Points outside the box get the label at the nearest wall, as sampling does everywhere.
            const cleft::Material m = volume->volume.material_at(volume->frame.to_local(world));
            labels[i] = number_of(volume->volume.labels()[m]);
        }
    });
}
