// Scales values in double precision: whole results stay whole numbers.
#include "io/nifti_scaling.hpp"

#include "base/error.hpp"
#include "io/voxel_access.hpp"

#include <cmath>
#include <cstdio>
#include <utility>

namespace cleft::io
{

namespace
{

template <class To, class From>
void convert(Component component, double slope, double intercept, Image& image)
{
    const std::unique_ptr<std::byte[]> from = std::move(image.voxels);
    image.component = component;
    allocate_voxels(image);
    const int64_t count = image.field_size() * image.fields;
    for (int64_t i = 0; i < count; ++i) {
        const auto value = static_cast<To>(slope * static_cast<double>(load<From>(from.get(), i)) + intercept);
        store<To>(image.voxels.get(), i, value);
    }
}

template <class From>
void scale(double slope, double intercept, Image& image)
{
    bool whole = true;
    const int64_t count = image.field_size() * image.fields;
    for (int64_t i = 0; whole && i < count; ++i) {
        const double value = slope * static_cast<double>(load<From>(image.voxels.get(), i)) + intercept;
        // Labels that were stored with a slope, such as 0, 1/2 and 1 in bytes, must come out whole.
        // Double precision is exact for them.
        whole = value == std::floor(value) && value >= -0x1p31 && value < 0x1p31;
    }
    if (whole)
        convert<int32_t, From>(Component::int32, slope, intercept, image);
    else
        convert<double, From>(Component::float64, slope, intercept, image);
}

}  // namespace

bool is_scaled(double slope, double intercept)
{
    // nifti1.h scales values only where scl_slope is not 0. Some writers put NaN there for "none".
    return slope != 0 && !std::isnan(slope) && (slope != 1 || intercept != 0);
}

void scale_values(double slope, double intercept, Image& image)
{
    if (!is_scaled(slope, intercept))
        return;
    if (!std::isfinite(slope) || !std::isfinite(intercept))
        throw Error(CLEFT_ERROR_FORMAT, "the scale of its values (scl_slope, scl_inter) is not finite");
    with_type(image.component, [&](auto zero) { scale<decltype(zero)>(slope, intercept, image); });
    // Always reported, as a label is then another number than the one in the file.
    char text[120];
    std::snprintf(text, sizeof text,
                  "its values are scaled: %g times the number in the file plus %g (scl_slope, scl_inter)", slope,
                  intercept);
    image.notes.emplace_back(text);
}

}  // namespace cleft::io
