// Converts between an image and what the core takes: affine maps between worlds, and voxels of its
// types.
#include "io/voxels.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace cleft::io
{

namespace
{

template <class Number>
// std::to_string() writes six digits behind the point of a floating-point number, which say nothing
// of a label.
std::string whole_text(Number value)
{
    const std::string text = std::to_string(value);
    return text.substr(0, text.find('.'));
}

// Floating-point voxels are rounded to the nearest: what they mean was judged before.
template <class To, class From>
To label_from(From value)
{
    bool fits = true;
    if constexpr (std::is_floating_point_v<From>) {
        value = std::round(value);
        // 2^31 itself is compared: the greatest int32 has no float, and would round up to it.
        fits = value >= static_cast<From>(std::numeric_limits<int32_t>::min()) && value < static_cast<From>(0x1p31);
    } else {
        fits = value <= static_cast<From>(std::numeric_limits<int32_t>::max()) &&
               (!std::is_signed_v<From> || value >= static_cast<From>(std::numeric_limits<int32_t>::min()));
    }
    if (!fits)
        throw Error(CLEFT_ERROR_FORMAT, "label " + whole_text(value) +
                                            " does not fit into 32 bits: renumber the labels from 0, in Python by "
                                            "numpy.unique(voxels, return_inverse=True)");
    return static_cast<To>(value);
}

// Replaces every voxel by convert(voxel). Where the new type is not wider, the old memory takes it: a voxel is written
// where it or one before it was read.
template <class To, class From, class Convert>
void convert_voxels(Image& image, Component to, const Convert& convert)
{
    const int64_t count = image.field_size() * image.fields;
    std::unique_ptr<std::byte[]> wider;
    const std::byte* from = image.voxels.get();
    image.component = to;
    // Otherwise number i is written at or before the place where it was read, and never over one
    // that is still to be read.
    if (sizeof(To) > sizeof(From)) {
        wider = std::move(image.voxels);
        allocate_voxels(image);
    }
    for (int64_t i = 0; i < count; ++i)
        store<To>(image.voxels.get(), i, convert(load<From>(from, i)));
}

double spacing_along(size_t axis, const Image& image, const cleft_io_reading& reading)
{
    const double wanted = reading.spacing[axis];
    if (!std::isfinite(wanted) || wanted < 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "the spacing that replaces the file's must be positive");
    const double spacing = wanted > 0 ? wanted : reading.scale * image.spacing[axis];
    // Readers leave 0 where a file does not tell. Only the user knows the size then.
    if (spacing == 0 || !std::isfinite(spacing))
        throw Error(CLEFT_ERROR_FORMAT, "its spacing along the " + ordinal(static_cast<int64_t>(axis)) + " axis is " +
                                            number_text(spacing) + ": give the spacing yourself");
    return spacing;
}

void check_directions(const Image& image)
{
    // Of directions of length 1. Less is rounding of axes that lie in one plane.
    constexpr double kLeastVolume = 1e-6;
    for (size_t row = 0; row < 3; ++row)
        if (!std::isfinite(image.origin[row]))
            throw Error(CLEFT_ERROR_FORMAT, "its origin is not finite");
    // A volume that is NaN fails the comparison.
    const double volume = dot(cross(image.directions[0], image.directions[1]), image.directions[2]);
    if (!(std::abs(volume) > kLeastVolume))
        throw Error(CLEFT_ERROR_FORMAT, "the directions of its axes lie in a plane");
}

// Between LPS and RAS, either way; x + 0.0 makes no negative zeros.
void flip_world(std::array<double, 12>& affine)
{
    // The rows of x and y. LPS and RAS differ in both signs, so one function serves both ways.
    for (size_t i = 0; i < 8; ++i)
        affine[i] = -affine[i] + 0.0;
}

}  // namespace

std::array<double, 12> affine_of(const Image& image, const cleft_io_reading& reading)
{
    check_directions(image);
    std::array<double, 12> affine{};
    for (size_t axis = 0; axis < 3; ++axis) {
        const double spacing = spacing_along(axis, image, reading);
        for (size_t row = 0; row < 3; ++row)
            affine[4 * row + axis] = spacing * image.directions[axis][row] + 0.0;  // no -0
    }
    for (size_t row = 0; row < 3; ++row)
        // A spacing of the caller's replaces the file's and is not scaled, but the origin is still
        // the file's.
        affine[4 * row + 3] = reading.scale * image.origin[row];
    if (reading.world == CLEFT_IO_WORLD_RAS)
        flip_world(affine);
    return affine;
}

std::vector<std::string> notes_on_spacing(const Image& image, const cleft_io_reading& reading)
{
    // Units differ by factors of ten and more. A spacing that differs by less is a correction.
    constexpr double kAnotherUnit = 9;
    double greatest = 1;  // factor between the spacing wanted and the file's, either way
    for (size_t axis = 0; axis < 3; ++axis)
        if (reading.spacing[axis] > 0 && image.spacing[axis] > 0) {
            const double factor = reading.spacing[axis] / (reading.scale * image.spacing[axis]);
            greatest = std::max({greatest, factor, 1 / factor});
        }
    if (reading.scale != 1 && greatest > kAnotherUnit)
        return {"the spacing asked for is taken as it is, and not multiplied by the scale " +
                number_text(reading.scale) + ": it differs from the file's by a factor of " + number_text(greatest)};
    // An origin of 0 stays right in any unit.
    if (reading.scale != 1 || greatest < 1.001 || length(image.origin) == 0)
        return {};
    return {"the spacing asked for replaces the file's, but the origin (" + number_text(image.origin[0]) + ", " +
            number_text(image.origin[1]) + ", " + number_text(image.origin[2]) +
            ") stays in the file's unit: a scale (--scale) takes both"};
}

void set_geometry(std::array<double, 12> affine, cleft_io_world world, Image& image)
{
    if (world == CLEFT_IO_WORLD_RAS)
        flip_world(affine);
    for (size_t axis = 0; axis < 3; ++axis) {
        // The affine comes from the core, which has checked that no step is of length 0.
        const Vector3 step{affine[axis], affine[4 + axis], affine[8 + axis]};
        image.spacing[axis] = length(step);
        image.directions[axis] = times(1 / length(step), step);
        image.origin[axis] = affine[4 * axis + 3];
    }
}

cleft_type type_of(Component component)
{
    switch (component) {
        case Component::uint8:
            return CLEFT_TYPE_UINT8;
        case Component::uint16:
            return CLEFT_TYPE_UINT16;
        case Component::int16:
            return CLEFT_TYPE_INT16;
        case Component::uint32:
            return CLEFT_TYPE_UINT32;
        case Component::int32:
            return CLEFT_TYPE_INT32;
        case Component::float32:
            return CLEFT_TYPE_FLOAT32;
        case Component::float64:
            return CLEFT_TYPE_FLOAT64;
        case Component::int8:
        case Component::uint64:
        case Component::int64:
            break;
    }
    // make_labels() and make_floating() leave none of these three.
    throw Error(CLEFT_ERROR_INTERNAL, "voxels were not converted");
}

Component label_component(Component component)
{
    return with_type(component, [&](auto zero) {
        using From = decltype(zero);
        // The core has no type of signed bytes. int16 holds them all.
        if (std::is_same_v<From, int8_t>)
            return Component::int16;
        const bool is_narrow = sizeof(From) < sizeof(int32_t) || std::is_same_v<From, int32_t>;
        return is_narrow ? component : Component::int32;
    });
}

void make_labels(Image& image)
{
    const Component to = label_component(image.component);
    if (to == image.component)
        return;
    with_type(image.component, [&](auto zero) {
        using From = decltype(zero);
        if constexpr (std::is_same_v<From, int8_t>)
            convert_voxels<int16_t, From>(image, to, [](From v) { return int16_t{v}; });
        else
            convert_voxels<int32_t, From>(image, to, label_from<int32_t, From>);
    });
}

void make_floating(Image& image)
{
    with_type(image.component, [&](auto zero) {
        using From = decltype(zero);
        if constexpr (!std::is_floating_point_v<From>)
            convert_voxels<float, From>(image, Component::float32, [](From v) { return static_cast<float>(v); });
    });
}

void widen(Image& image)
{
    if (image.component == Component::float32)
        convert_voxels<double, float>(image, Component::float64, [](float v) { return double{v}; });
}

void scale_values(double factor, Image& image)
{
    if (factor == 1)
        return;
    if (image.component == Component::float32)
        convert_voxels<float, float>(image, image.component, [&](float v) { return static_cast<float>(factor * v); });
    else
        convert_voxels<double, double>(image, image.component, [&](double v) { return factor * v; });
}

}  // namespace cleft::io
