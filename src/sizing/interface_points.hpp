// Where the material interfaces pass, to less than a voxel: a point and a normal for each voxel at an interface.
#pragma once

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/vec.hpp"
#include "sizing/labelling.hpp"
#include "sizing/voxel_rows.hpp"

#include <cstdint>

namespace cleft
{

// An interface point relative to the centre of its voxel, in world units.
struct InterfacePoint {
    FixedArray<float, 3> offset{0, 0, 0};
    FixedArray<float, 3> normal{0, 0, 0};  // of unit length, out of the voxel's material
};

// An interface voxel has a neighbour of another material across a face. What is known of its point is a few small
// integers (see interface_points.cpp), so two bytes a voxel hold it and a table turns them into lengths.
class InterfacePoints
{
public:
    InterfacePoints(const Labelling& labelling, const Run& run);

    bool contains(int64_t voxel) const { return codes_[voxel] != 0; }
    // Of a voxel at an interface.
    const InterfacePoint& operator[](int64_t voxel) const
    {
        CLEFT_ASSERT(contains(voxel));
        return table_[codes_[voxel]];
    }
    // Bit 2a: the neighbour before along axis a is of another material; bit 2a + 1: the one after.
    int sides(int64_t voxel) const { return sides_[voxel]; }
    void forget_sides() { Array<uint8_t>().swap(sides_); }
    int64_t count() const { return count_; }

private:
    Array<uint16_t> codes_;  // 0: not at an interface
    Array<uint8_t> sides_;
    Array<InterfacePoint> table_;
    int64_t count_ = 0;
};

}  // namespace cleft
