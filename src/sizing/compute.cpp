// The sizing field from its sources: features, sizes that are given, thin parts and values of the user. Each only
// lowers the field; the gradient limit comes last and spreads them all.
#include "sizing/compute.hpp"

#include "base/number_text.hpp"
#include "base/stage.hpp"
#include "base/touched_array.hpp"
#include "sizing/feature_size.hpp"
#include "sizing/gradient_limit.hpp"
#include "sizing/number_limit.hpp"
#include "sizing/one_voxel.hpp"
#include "volume/limits.hpp"

#include <cmath>
#include <limits>
#include <string>

namespace cleft
{
namespace
{

void check_options(const SizingOptions& options)
{
    check_size("size", options.size);
    check_size("size_min", options.size_min);
    check_size("size_max", options.size_max);
    check_size("interface_size", options.interface_size);
    check_size("surface_error", options.surface_error);
    if (!(options.max_tets >= 0) || !std::isfinite(options.max_tets))
        throw Error(CLEFT_ERROR_OPTION, "max_tets must be 0 or a positive, finite number");
    check_size_range(options);
    if (!(options.feature_scale > 0) || !std::isfinite(options.feature_scale))
        throw Error(CLEFT_ERROR_OPTION, "feature_scale must be positive and finite");
    if (!(options.gradation > 0) || !std::isfinite(options.gradation))
        throw Error(CLEFT_ERROR_OPTION, "gradation must be positive and finite");
    for (const double size : options.material_sizes)
        check_size("the size of a material", size);
}

// The values that a field may have, from the options and the box.
struct Limits {
    double greatest;       // where nothing asks for less
    double least_feature;  // no feature asks for less
    double least;          // nothing asks for less
    double thin;           // of parts that are one voxel thick, if they are to be kept

    // The same for features that may ask for so many times less.
    Limits raised(double factor) const
    {
        // A least size above the greatest would be cut off again.
        return {std::max(greatest, factor * least_feature), factor * least_feature, least, factor * thin};
    }
};

// A plate whose elements are longer than this share of its thickness has flat ones, and nothing can make them better.
// Without this bound 5 % of random thin volumes missed 20 degrees, with it 6 of 1,920 runs (docs/quality.md, Thin
// volumes).
constexpr double kMostOfThickness = 1.5;
// Beyond kUsualStretch a plate may need very many elements of its thickness; it gets them if they are no more than so
// many squares of that side.
// A plate of 20 x 20 voxels of 50 x 50 x 1 would have millions of tetrahedra for nothing that its labels need.
// These many have some 140,000 background tetrahedra by the estimate of sizing_field.cpp.
constexpr double kMostSquares = 20000;

}  // namespace

double default_size_max(const Grid& grid)
{
    const Vec3 box = grid.extent();
    const double longest_voxel = grid.spacing.maxCoeff();
    // A quarter of the box shows its shape. An element longer than the shortest side does not fit in; below the
    // greatest spacing it would resolve more than the voxels do.
    const double whole = std::max(longest_voxel, std::min(0.25 * box.maxCoeff(), box.minCoeff()));
    const double thin = kMostOfThickness * box.minCoeff();
    // The share covers the rounding of spacings that come from an affine.
    const bool is_usual = longest_voxel <= kUsualStretch * grid.spacing.minCoeff() * (1 + 1e-9);
    const double squares = box.prod() / (box.minCoeff() * thin * thin);
    return is_usual || squares <= kMostSquares ? std::min(whole, thin) : whole;
}

namespace
{

Limits limits_of(const Grid& grid, const SizingOptions& options)
{
    const double thin = std::max(options.size_min, 0.5 * grid.spacing.minCoeff());
    if (options.size > 0)
        return {options.size, options.size, std::min(options.size, options.size_min), thin};
    double greatest = options.size_max > 0 ? options.size_max : default_size_max(grid);
    if (options.size_max <= 0)
        greatest = std::max(greatest, options.size_min);
    const double least = options.size_min > 0 ? options.size_min : std::min(grid.spacing.minCoeff(), greatest);
    return {greatest, least, options.size_min, thin};
}

// The greatest size in each material: the limit, or its own.
Array<float> greatest_sizes(const SizingOptions& options, const Limits& limits)
{
    Array<float> sizes(options.material_sizes.size(), static_cast<float>(limits.greatest));
    for (size_t m = 0; m < sizes.size(); ++m)
        if (const double size = options.material_sizes[m]; size > 0)
            sizes[m] = std::min(sizes[m], static_cast<float>(std::max(size, limits.least)));
    return sizes;
}

void lower_to_material_sizes(const Labelling& labelling, const Array<float>& sizes, Array<float>& h, const Run& run)
{
    const int32_t n = labelling.grid.dims[0];
    parallel_with_progress(run, row_count(labelling.grid), rows_per_chunk(labelling.grid),
                           [&](int64_t, int64_t begin, int64_t end) {
                               Array<Material> materials(n);
                               for (int64_t row = begin; row < end; ++row) {
                                   labelling.read(row * n, n, materials.data());
                                   float* const values = h.data() + row * n;
                                   for (int32_t i = 0; i < n; ++i)
                                       values[i] = std::min(values[i], sizes[materials[i]]);
                               }
                           });
}

void lower_to_features(const FeatureSizes& features, const SizingOptions& options, const Limits& limits,
                       Array<float>& h)
{
    // A size that was asked for may be below the least spacing, unlike a feature: only size_min bounds it.
    const double interface_size = options.interface_size > 0 ? std::max(options.interface_size, limits.least)
                                                             : std::numeric_limits<double>::infinity();
    for (size_t n = 0; n < features.voxel.size(); ++n) {
        const double feature = std::max(limits.least_feature, options.feature_scale * features.size[n]);
        float& value = h[features.voxel[n]];
        value = std::min(value, static_cast<float>(std::min(feature, interface_size)));
    }
}

void lower_to_limits(const Array<SizeLimit>& sizes, const Limits& limits, Array<float>& h)
{
    for (const SizeLimit& limit : sizes)
        h[limit.voxel] = std::min(h[limit.voxel], std::max(limit.size, static_cast<float>(limits.least_feature)));
}

void lower_to_one_voxel_parts(const Labelling& labelling, const Limits& limits, Array<float>& h, const Run& run)
{
    // Half a voxel puts two edges across a part, so that snapping need not pull both of its sides onto one point.
    const Array<uint8_t> near = near_one_voxel_parts(labelling, run);
    for (size_t v = 0; v < h.size(); ++v)
        if (near[v])
            h[v] = std::min(h[v], static_cast<float>(limits.thin));
}

void lower_to_user(const float* user, const Grid& grid, const Limits& limits, Array<float>& h)
{
    for (int64_t v = 0; v < h.count(); ++v) {
        if (!(user[v] > 0) || !std::isfinite(user[v]))
            throw bad_sizing_value(user[v], v, grid);
        h[v] = std::min(h[v], std::max(user[v], static_cast<float>(limits.least)));
    }
}

void note_features(const FeatureSizes& features, const Run& run)
{
    run.note("sizing.interface_voxels", static_cast<double>(features.voxel.size()));
    run.note("sizing.medial_voxels", static_cast<double>(features.medial_voxels));
}

void note_field(const SizingField& field, const Run& run)
{
    const SizeRange sizes = field.range();
    run.note("sizing.least", sizes.least);
    run.note("sizing.greatest", sizes.greatest);
}

// Everything that the sizes are computed from.
struct Sources {
    const Labelling& labelling;
    const SizingOptions& options;
    const Array<SizeLimit>& limits;
    FeatureSizes features;
};

SizingField field_of(const Sources& from, const Limits& limits, const Run& run)
{
    const Grid& grid = from.labelling.grid;
    SizingField field{grid, large_array(run, grid.size(), static_cast<float>(limits.greatest)), from.options.gradation};
    Steps steps(run, {{"sizing: sizes of labels", from.options.material_sizes.empty() ? 0.0 : 10},
                      {"sizing: thin parts", from.options.keep_thin ? 20.0 : 0},
                      {"sizing: gradation", 90}});
    const Run of_labels = steps.next(), of_thin = steps.next(), of_gradation = steps.next();
    lower_to_features(from.features, from.options, limits, field.h);
    lower_to_limits(from.limits, limits, field.h);
    if (!from.options.material_sizes.empty())
        lower_to_material_sizes(from.labelling, greatest_sizes(from.options, limits), field.h, of_labels);
    if (from.options.keep_thin)
        lower_to_one_voxel_parts(from.labelling, limits, field.h, of_thin);
    if (from.options.user)
        lower_to_user(from.options.user, grid, limits, field.h);
    // Last, since it keeps every value below and makes the whole Lipschitz; a limit applied after it would leave jumps.
    limit_gradient(grid, from.options.gradation, field.h, of_gradation);
    return field;
}

void keep_to_max_tets(const Sources& from, Limits limits, SizingField& field, const Run& run)
{
    const SizingOptions& options = from.options;
    if (!limits_number(options))
        return;
    const auto expected = [&](double raised) {
        if (raised > 1) {
            // Frees the old values before the new ones are made: a field can be the largest array of the stage.
            field = SizingField();
            field = field_of(from, limits.raised(raised), run);
        }
        return options.expected_tets ? options.expected_tets(field, options.max_tets, run)
                                     : expected_particle_tets(field);
    };
    const auto at_wanted_size = [&] { return expected_particle_tets(field); };
    keep_to_number({options.max_tets, limits.least_feature, from.labelling.grid.extent().minCoeff()}, expected,
                   at_wanted_size, run);
}

}  // namespace

void check_size(const std::string& name, double value)
{
    if (value != 0 && !(value >= kLeastSize && value <= kGreatestSize))
        throw Error(CLEFT_ERROR_OPTION, name + " is " + number_text(value) + "; it must be 0, or within " +
                                            number_text(kLeastSize) + " to " + number_text(kGreatestSize));
}

void check_size_range(const SizingOptions& options)
{
    if (options.size_max > 0 && options.size_max < options.size_min)
        throw Error(CLEFT_ERROR_OPTION, "size_max is " + number_text(options.size_max) + ", less than size_min, " +
                                            number_text(options.size_min));
}

SizingField compute_sizing(const Labelling& labelling, const SizingOptions& options, const Run& run,
                           const Array<SizeLimit>& given_limits)
{
    Stage stage(run, "sizing", {{"sizing: features", 60}, {"sizing: field", 40}, {"sizing: number of tetrahedra", 0}});
    check_options(options);
    const Limits limits = limits_of(labelling.grid, options).raised(options.raised);

    Sources from{labelling, options, given_limits, {}};
    const Run of_features = stage.next();
    if (options.size <= 0 || options.interface_size > 0)
        // No feature asks for more than the greatest size.
        from.features = local_feature_sizes(labelling, limits.greatest / options.feature_scale, of_features);
    note_features(from.features, run);
    if (options.size > 0)  // only the places are wanted
        std::fill(from.features.size.begin(), from.features.size.end(), std::numeric_limits<float>::infinity());
    SizingField field = field_of(from, limits, stage.next());
    keep_to_max_tets(from, limits, field, stage.next());
    note_field(field, run);
    return field;
}

}  // namespace cleft
