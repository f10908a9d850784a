#include "io/voxels.hpp"

#include "base/error.hpp"

#include <cmath>
#include <cstring>
#include <limits>
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

template <class T>
void store(std::byte* voxels, int64_t index, T value)
{
    std::memcpy(voxels + static_cast<size_t>(index) * sizeof(T), &value, sizeof(T));
}

// Calls body(value of the component's type).
template <class Body>
auto with_type(Component component, const Body& body)
{
    switch (component) {
        case Component::uint8:
            return body(uint8_t{});
        case Component::int8:
            return body(int8_t{});
        case Component::uint16:
            return body(uint16_t{});
        case Component::int16:
            return body(int16_t{});
        case Component::uint32:
            return body(uint32_t{});
        case Component::int32:
            return body(int32_t{});
        case Component::uint64:
            return body(uint64_t{});
        case Component::int64:
            return body(int64_t{});
        case Component::float32:
            return body(float{});
        case Component::float64:
            break;
    }
    return body(double{});
}

template <class To, class From>
To label_from(From value)
{
    if constexpr (std::is_floating_point_v<From>) {
        if (!(std::floor(value) == value))
            throw Error(CLEFT_ERROR_FORMAT, "labels are whole numbers, but a voxel is " + std::to_string(value));
        if (value < static_cast<From>(std::numeric_limits<int32_t>::min()) || value >= static_cast<From>(0x1p31))
            throw Error(CLEFT_ERROR_FORMAT, "label " + std::to_string(value) + " does not fit into 32 bits");
    } else if constexpr (sizeof(From) > sizeof(int32_t)) {
        if (value > static_cast<From>(std::numeric_limits<int32_t>::max()) ||
            (std::is_signed_v<From> && value < static_cast<From>(std::numeric_limits<int32_t>::min())))
            throw Error(CLEFT_ERROR_FORMAT, "label " + std::to_string(value) + " does not fit into 32 bits");
    }
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
    if (spacing == 0 || !std::isfinite(spacing))
        throw Error(CLEFT_ERROR_FORMAT, "its spacing along axis " + std::to_string(axis) + " is " +
                                            std::to_string(spacing) + ": give the spacing yourself");
    return spacing;
}

void check_directions(const Image& image)
{
    constexpr double least_volume = 1e-6;
    bool finite = true;
    for (size_t row = 0; row < 3; ++row)
        finite = finite && std::isfinite(image.origin[row]);
    // A volume that is NaN fails the comparison.
    const double volume = dot(cross(image.directions[0], image.directions[1]), image.directions[2]);
    if (!finite || !(std::abs(volume) > least_volume))
        throw Error(CLEFT_ERROR_FORMAT, "the directions of its axes lie in a plane, or its origin is not finite");
}

// Between LPS and RAS, either way; x + 0.0 makes no negative zeros.
void flip_world(std::array<double, 12>& affine)
{
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
        affine[4 * row + 3] = reading.scale * image.origin[row];
    if (reading.world == CLEFT_IO_WORLD_RAS)
        flip_world(affine);
    return affine;
}

void set_geometry(std::array<double, 12> affine, cleft_io_world world, Image& image)
{
    if (world == CLEFT_IO_WORLD_RAS)
        flip_world(affine);
    for (size_t axis = 0; axis < 3; ++axis) {
        const Vector3 step{affine[axis], affine[4 + axis], affine[8 + axis]};
        image.spacing[axis] = length(step);
        image.directions[axis] = times(1 / length(step), step);
        image.origin[axis] = affine[4 * axis + 3];
    }
}

bool looks_like_labels(const Image& image)
{
    return with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        if constexpr (std::is_floating_point_v<T>) {
            const int64_t count = image.field_size() * image.fields;
            for (int64_t i = 0; i < count; ++i) {
                const T value = load<T>(image.voxels.get(), i);
                if (!(value >= 0 && value < static_cast<T>(0x1p31) && std::floor(value) == value))
                    return false;
            }
        }
        return true;
    });
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
    throw Error(CLEFT_ERROR_INTERNAL, "voxels were not converted");
}

void make_labels(Image& image)
{
    with_type(image.component, [&](auto zero) {
        using From = decltype(zero);
        if constexpr (std::is_same_v<From, int8_t>)
            convert_voxels<int16_t, From>(image, Component::int16, [](From v) { return int16_t{v}; });
        else if constexpr (std::is_floating_point_v<From> || sizeof(From) > sizeof(int32_t))
            convert_voxels<int32_t, From>(image, Component::int32, label_from<int32_t, From>);
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
