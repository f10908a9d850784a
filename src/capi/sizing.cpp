// Sizing fields: computed from a volume, of one size, or from values of the caller.
#include "base/number_text.hpp"
#include "capi/firewall.hpp"
#include "capi/kept_labels.hpp"
#include "capi/options.hpp"
#include "pipeline/pipeline.hpp"
#include "sizing/metric_sizing.hpp"

#include <cmath>

using namespace cleft::capi;
using cleft::Error;
using cleft::Run;
using cleft::ScaledSizing;
using cleft::SizingField;

namespace
{

// No copy in between: a field can be the largest array of all.
SizingField field_of(cleft_type type, const void* values, const cleft::Grid& grid)
{
    if (type == CLEFT_TYPE_FLOAT32)
        return cleft::sizing_from_values(grid, static_cast<const float*>(values));
    if (type == CLEFT_TYPE_FLOAT64)
        return cleft::sizing_from_values(grid, static_cast<const double*>(values));
    throw Error(CLEFT_ERROR_ARGUMENT, "the values of a sizing field must be FLOAT32 or FLOAT64");
}

SizingField metric_of(cleft_type type, const void* tensors, const cleft::Frame& frame, const Run& run)
{
    if (type == CLEFT_TYPE_FLOAT32)
        return cleft::sizing_from_metric(frame.grid, frame, static_cast<const float*>(tensors), run);
    if (type == CLEFT_TYPE_FLOAT64)
        return cleft::sizing_from_metric(frame.grid, frame, static_cast<const double*>(tensors), run);
    throw Error(CLEFT_ERROR_ARGUMENT, "the tensors of a metric must be FLOAT32 or FLOAT64");
}

// The handle of a field.
// The expected number is found once, since cleft_sizing_expected_tets() has no context that could be cancelled.
cleft_sizing finished(const cleft_volume& v, ScaledSizing sizing, const cleft::PipelineOptions& p, const Run& run)
{
    const cleft::ExpectedBackground expected =
        cleft::expected_background(sizing.field, p.background, v.volume, p.kept, run);
    run.note("sizing.expected_background_tets", expected.all);
    return {{}, v.frame, std::move(sizing), expected.kept};
}

// Of a field of the caller's own, as it is or combined with the computed one. make(volume, options of sizes) makes it.
template <class Make>
cleft_sizing sizing_of_given(const cleft_volume* volume, bool combines, const cleft_options* options, const Run& run,
                             const Make& make)
{
    const auto v = held(volume, "volume");
    const auto held_options = held_if_any(options, "options");
    const cleft::PipelineOptions p = pipeline_options(options, *v);
    if (combines)
        warn_of_unknown_sizes(v->volume.labels(), options, run);
    warn_of_unused_smooth(v->volume, options, run);
    return finished(*v, cleft::make_sizing(v->volume, make(*v, p.sizing), combines, p, run), p, run);
}

}  // namespace

cleft_status cleft_sizing_create(cleft_context* context, const cleft_volume* volume, const cleft_options* options,
                                 cleft_sizing** out) noexcept
{
    return guarded_create(context, out, "sizing", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const auto held_options = held_if_any(options, "options");
        const cleft::PipelineOptions p = pipeline_options(options, *v);
        warn_of_unknown_labels(v->volume.labels(), options, "volume", run);
        warn_of_unknown_sizes(v->volume.labels(), options, run);
        warn_of_unused_smooth(v->volume, options, run);
        return finished(*v, cleft::make_sizing(v->volume, p, run), p, run);
    });
}

cleft_status cleft_sizing_create_constant(cleft_context* context, const cleft_volume* volume, double size,
                                          cleft_sizing** out) noexcept
{
    return guarded_create(context, out, "sizing", [&](const Run& run) {
        const auto v = held(volume, "volume");
        if (!std::isfinite(size))
            throw Error(CLEFT_ERROR_NOT_FINITE, "the size is NaN or infinite");
        // On the grid of the volume, so that all stages read it like any other field.
        SizingField field = cleft::constant_sizing(v->frame.grid, size);
        return finished(*v, {std::move(field)}, pipeline_options(nullptr), run);
    });
}

cleft_status cleft_sizing_create_values(cleft_context* context, const cleft_volume* volume, cleft_type type,
                                        const void* values, int32_t combine, const cleft_options* options,
                                        cleft_sizing** out) noexcept
{
    return guarded_create(context, out, "sizing", [&](const Run& run) {
        checked(volume, "volume");  // before the array, so that the sentence is about the first fault
        required(values, "values");
        return sizing_of_given(volume, combine != 0, options, run, [&](const cleft_volume& v, const auto&) {
            return field_of(type, values, v.frame.grid);
        });
    });
}

cleft_status cleft_sizing_create_metric(cleft_context* context, const cleft_volume* volume, cleft_type type,
                                        const void* tensors, int32_t combine, const cleft_options* options,
                                        cleft_sizing** out) noexcept
{
    return guarded_create(context, out, "sizing", [&](const Run& run) {
        checked(volume, "volume");
        required(tensors, "tensors");
        const auto bounded_metric = [&](const cleft_volume& v, const cleft::SizingOptions& sizes) {
            SizingField field = metric_of(type, tensors, v.frame, run);
            if (sizes.size_min > 0 || sizes.size_max > 0)
                cleft::bound_metric(field, sizes.size_min, sizes.size_max, run);
            return field;
        };
        return sizing_of_given(volume, combine != 0, options, run, bounded_metric);
    });
}

cleft_status cleft_sizing_create_constant_metric(cleft_context* context, const cleft_volume* volume,
                                                 const double tensor[6], cleft_sizing** out) noexcept
{
    return guarded_create(context, out, "sizing", [&](const Run& run) {
        const auto v = held(volume, "volume");
        required(tensor, "tensor");
        SizingField field = cleft::constant_metric(v->frame.grid, v->frame,
                                                   {tensor[0], tensor[1], tensor[2], tensor[3], tensor[4], tensor[5]});
        return finished(*v, {std::move(field)}, pipeline_options(nullptr), run);
    });
}

int32_t cleft_sizing_has_metric(const cleft_sizing* sizing) noexcept
{
    return is_sound(sizing) && sizing->sizing.field.metric ? 1 : 0;
}

cleft_status cleft_sizing_copy_metric(const cleft_sizing* sizing, float* tensors, int64_t capacity) noexcept
{
    return guarded(nullptr, [&] {
        const cleft_sizing& s = checked(sizing, "sizing");
        const SizingField& field = s.sizing.field;
        if (!field.metric)
            throw Error(CLEFT_ERROR_ARGUMENT, "the sizing field has no metric");
        required(tensors, "tensors");
        if (capacity < 6 * field.grid.size())
            throw Error(CLEFT_ERROR_BUFFER, "the metric has " + std::to_string(6 * field.grid.size()) +
                                                " numbers, and the buffer " + std::to_string(capacity));
        for (int64_t voxel = 0; voxel < field.grid.size(); ++voxel) {
            const cleft::Tensor m = cleft::world_metric(field, s.frame, voxel);
            for (const double value : {m.xx, m.xy, m.xz, m.yy, m.yz, m.zz})
                *tensors++ = static_cast<float>(value);
        }
    });
}

void cleft_sizing_destroy(cleft_sizing* sizing) noexcept { destroy(sizing); }

cleft_status cleft_sizing_dims(const cleft_sizing* sizing, int64_t dims[3]) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(sizing, "sizing").frame.grid.dims;
        std::copy(from.begin(), from.end(), required(dims, "dims"));
    });
}

cleft_status cleft_sizing_affine(const cleft_sizing* sizing, double affine[12]) noexcept
{
    return guarded(nullptr, [&] {
        const auto& from = checked(sizing, "sizing").frame.affine;
        std::copy(from.begin(), from.end(), required(affine, "affine"));
    });
}

// Lent, not copied: a field has one value per voxel, and a caller may only want to look at a few.
const float* cleft_sizing_values(const cleft_sizing* sizing) noexcept
{
    return is_sound(sizing) ? sizing->sizing.field.h.data() : nullptr;
}

cleft_status cleft_sizing_at(const cleft_sizing* sizing, const double point[3], double* size) noexcept
{
    return guarded(nullptr, [&] {
        const cleft_sizing& s = checked(sizing, "sizing");
        required(point, "point");
        const cleft::Vec3 world(point[0], point[1], point[2]);
        if (!world.allFinite())
            throw Error(CLEFT_ERROR_NOT_FINITE, "the point is NaN or infinite");
        *required(size, "size") = s.sizing.field.at(s.frame.to_local(world));
    });
}

double cleft_sizing_expected_tets(const cleft_sizing* sizing) noexcept
{
    return is_sound(sizing) ? sizing->expected_tets : 0;
}
