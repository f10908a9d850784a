// An image file as a plain value, in ITK's world (LPS).
#pragma once

#include "io/vector3.hpp"

#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cleft::io
{

// The types of numbers that files may have. The core takes seven of them; voxels.hpp converts the
// others.
enum class Component { uint8, int8, uint16, int16, uint32, int32, uint64, int64, float32, float64 };

// In bytes.
size_t size_of(Component component);
bool is_floating(Component component);

// Voxels are stored with x fastest, then y, z and the field. Voxel (i, j, k) lies at the origin plus
// i, j and k steps of the spacing along the directions.
struct Image {
    std::array<int64_t, 3> dims{1, 1, 1};
    int64_t fields = 1;  // how many volumes of these dimensions, one after the other
    Component component = Component::uint8;
    std::unique_ptr<std::byte[]> voxels;
    // The way along each axis of the voxels, of length 1.
    std::array<Vector3, 3> directions{Vector3{1, 0, 0}, Vector3{0, 1, 0}, Vector3{0, 0, 1}};
    Vector3 spacing{1, 1, 1};
    Vector3 origin{0, 0, 0};  // centre of the first voxel
    bool placed = false;      // of one slice: does its format put it at a place of its own in space?
    // What the reader has to tell about the file: sentences that do not name it.
    std::vector<std::string> notes;
    // The names that the file gives to labels.
    std::vector<std::pair<int32_t, std::string>> names;

    int64_t field_size() const { return dims[0] * dims[1] * dims[2]; }
    size_t bytes() const { return static_cast<size_t>(field_size() * fields) * size_of(component); }
};

// The bytes of all voxels. Throws Error: FORMAT where there are none, TOO_LARGE where 63 bits do not count them.
size_t checked_bytes(const Image& image);
// Memory for the voxels, not filled. Throws Error(CLEFT_ERROR_TOO_LARGE) or std::bad_alloc.
void allocate_voxels(Image& image);

}  // namespace cleft::io
