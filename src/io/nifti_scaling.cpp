// Scales values in double precision: whole results stay whole numbers.
#include "io/nifti_scaling.hpp"

#include "base/error.hpp"
#include "io/voxels.hpp"

#include <cmath>
#include <cstdio>
#include <cstring>
#include <utility>

namespace cleft::io
{

namespace
{

template <class T>
T load(const std::byte* voxels, int64_t index)
{
    T value;
    std::memcpy(&value, voxels + static_cast<size_t>(index) * sizeof(T), sizeof(T));
    return value;
}

template <class To, class From>
void convert(Component component, double slope, double intercept, Image& image)
{
    const std::unique_ptr<std::byte[]> from = std::move(image.voxels);
    image.component = component;
    allocate_voxels(image);
    const int64_t count = image.field_size() * image.fields;
    for (int64_t i = 0; i < count; ++i) {
        const auto value = static_cast<To>(slope * static_cast<double>(load<From>(from.get(), i)) + intercept);
        std::memcpy(image.voxels.get() + static_cast<size_t>(i) * sizeof(To), &value, sizeof(To));
    }
}

template <class From>
void scale(double slope, double intercept, Image& image)
{
    bool whole = true;
    const int64_t count = image.field_size() * image.fields;
    for (int64_t i = 0; whole && i < count; ++i) {
        const double value = slope * static_cast<double>(load<From>(image.voxels.get(), i)) + intercept;
        whole = value == std::floor(value) && value >= -0x1p31 && value < 0x1p31;
    }
    if (whole)
        convert<int32_t, From>(Component::int32, slope, intercept, image);
    else
        convert<double, From>(Component::float64, slope, intercept, image);
}

void scale_by_type(double slope, double intercept, Image& image)
{
    switch (image.component) {
        case Component::uint8:
            return scale<uint8_t>(slope, intercept, image);
        case Component::int8:
            return scale<int8_t>(slope, intercept, image);
        case Component::uint16:
            return scale<uint16_t>(slope, intercept, image);
        case Component::int16:
            return scale<int16_t>(slope, intercept, image);
        case Component::uint32:
            return scale<uint32_t>(slope, intercept, image);
        case Component::int32:
            return scale<int32_t>(slope, intercept, image);
        case Component::uint64:
            return scale<uint64_t>(slope, intercept, image);
        case Component::int64:
            return scale<int64_t>(slope, intercept, image);
        case Component::float32:
            return scale<float>(slope, intercept, image);
        case Component::float64:
            return scale<double>(slope, intercept, image);
    }
}

}  // namespace

void scale_values(double slope, double intercept, Image& image)
{
    if (slope == 0 || std::isnan(slope) || (slope == 1 && intercept == 0))
        return;
    if (!std::isfinite(slope) || !std::isfinite(intercept))
        throw Error(CLEFT_ERROR_FORMAT, "the scale of its values (scl_slope, scl_inter) is not finite");
    scale_by_type(slope, intercept, image);
    char text[120];
    std::snprintf(text, sizeof text,
                  "its values are scaled: %g times the number in the file plus %g (scl_slope, scl_inter)", slope,
                  intercept);
    image.notes.emplace_back(text);
}

}  // namespace cleft::io
