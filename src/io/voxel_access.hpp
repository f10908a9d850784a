// Voxels of whatever type, one by one.
#pragma once

#include "io/image.hpp"

#include <cstring>

namespace cleft::io
{

// By memcpy, as the bytes of a file are aligned for no type. Compilers make one instruction of it.
// `index` counts numbers, not bytes.
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
        // Left to the end of the function, so that the compiler sees an answer on each way.
        case Component::float64:
            break;
    }
    return body(double{});
}

// Calls body(voxel, value as double) for all voxels of one field. 64-bit numbers beyond 2^53 lose their last digits.
template <class Body>
void for_each_value(const Image& image, int64_t field, const Body& body)
{
    with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        const int64_t count = image.field_size();
        const std::byte* first = image.voxels.get() + static_cast<size_t>(field * count) * sizeof(T);
        for (int64_t v = 0; v < count; ++v)
            body(v, static_cast<double>(load<T>(first, v)));
    });
}

}  // namespace cleft::io
