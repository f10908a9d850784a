// A cube of voxels of a label map, taken apart by material.
#pragma once

#include "volume/label_map.hpp"
#include "volume/lanes.hpp"

#include <cstring>

namespace cleft
{

// The cube around a voxel that the widest kernel, of 6 voxels, reaches: three voxels to each side.
constexpr int kGreatestWidth = 7;
constexpr int kGreatestVolume = kGreatestWidth * kGreatestWidth * kGreatestWidth;
// Room for the voxels of a cube, one after the other, and a chunk more; whole chunks, so that rows of it stay aligned.
constexpr int kBlockRoom = (kGreatestVolume / kChunk + 2) * kChunk;

// The product of three rows of weights for every voxel of a cube, zero up to the next whole chunk. Rows are written
// eight lanes at a time, of which the next row overwrites the surplus.
inline void multiply_weights(const float* x, const float* y, const float* z, int width, float* out)
{
    const FloatRow row = FloatRow::load(x);
    for (int k = 0; k < width; ++k)
        for (int j = 0; j < width; ++j, out += width)
            (row * (y[j] * z[k])).store(out);
    std::memset(out, 0, kChunk * sizeof(float));
}

// The voxels first .. first + width - 1 along each axis.
template <class Label>
class LabelBlock
{
public:
    // A block may reach out of the grid, where it holds the mirror image.
    LabelBlock(const LabelMap<Label>& map, const FixedArray<int32_t, 3>& first, int width)
        : width_(width), size_(width * width * width)
    {
        CLEFT_ASSERT(width <= kGreatestWidth);
        const auto& dims = map.grid.dims;
        bool inside = true;
        for (int a = 0; a < 3; ++a)
            inside = inside && first[a] >= 0 && first[a] <= dims[a] - width;
        if (inside)
            copy_rows(map, first);
        else
            copy_mirrored(map, first);
        std::memset(weight_ + size_, 0, kChunk);
        for (int i = 0; i < size_; i += kChunk)
            std::memset(left_ + i, 0xff, kChunk);
        std::memset(left_ + size_, 0, kChunk);
    }
    LabelBlock(const LabelBlock&) = delete;
    LabelBlock& operator=(const LabelBlock&) = delete;

    Label centre() const { return material_[size_ / 2]; }

    // Goes to a material that was not visited yet, calling visit(i, weights) with the weights A of the voxels i .. i +
    // 15 of the cube for every chunk, zero where another material is. Returns the material, or -1 if there is none
    // left.
    // Materials come in the order of their first voxels in the cube, which depends on the data alone. One pass per
    // material is cheap: around most points there are two or three.
    template <class Visit>
    int next(const Visit& visit)
    {
        unsigned mask = 0;
        for (; next_ < size_ && !mask; next_ += kChunk)
            mask = ByteChunk::load(left_ + next_).mask();
        if (!mask)
            return -1;
        next_ -= kChunk;
        const Label material = material_[next_ + lowest_bit(mask)];
        for (int i = 0; i < size_; i += kChunk) {
            const ByteChunk mine = ByteChunk::equal(material_ + i, material);
            ByteChunk::load(left_ + i).without(mine).store(left_ + i);
            visit(i, mine & ByteChunk::load(weight_ + i));
        }
        return material;
    }

private:
    // Most cubes are inside the grid. A dense copy makes all further passes contiguous.
    void copy_rows(const LabelMap<Label>& map, const FixedArray<int32_t, 3>& first)
    {
        const int64_t row = map.grid.dims[0], slice = row * map.grid.dims[1];
        const int64_t start = map.index(first[0], first[1], first[2]);
        const Label* material = map.material.data() + start;
        const uint8_t* weight = map.weight.data() + start;
        int at = 0;
        for (int z = 0; z < width_; ++z)
            for (int y = 0; y < width_; ++y, at += width_) {
                // Whole lanes, of which the next row overwrites the surplus.
                std::memcpy(material_ + at, material + y * row + z * slice, kLanes * sizeof(Label));
                std::memcpy(weight_ + at, weight + y * row + z * slice, kLanes);
            }
    }
    // At the walls, the map continues as its mirror image (label_map.hpp).
    void copy_mirrored(const LabelMap<Label>& map, const FixedArray<int32_t, 3>& first)
    {
        int32_t index[3][kGreatestWidth];
        for (int a = 0; a < 3; ++a)
            for (int i = 0; i < width_; ++i)
                index[a][i] = mirrored(first[a] + i, map.grid.dims[a]);
        int at = 0;
        for (int z = 0; z < width_; ++z)
            for (int y = 0; y < width_; ++y) {
                const int64_t start = map.index(0, index[1][y], index[2][z]);
                for (int x = 0; x < width_; ++x, ++at) {
                    material_[at] = map.material[start + index[0][x]];
                    weight_[at] = map.weight[start + index[0][x]];
                }
            }
    }

    int width_, size_;
    int next_ = 0;
    alignas(16) Label material_[kBlockRoom];
    alignas(16) uint8_t weight_[kBlockRoom];
    alignas(16) uint8_t left_[kBlockRoom];  // 0xff where no material was visited that the voxel has
};

}  // namespace cleft
