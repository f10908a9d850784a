// A cube of voxels of a label map, taken apart by material.
#pragma once

#include "volume/label_map.hpp"

#include <algorithm>
#include <array>
#include <cstring>

namespace cleft
{

constexpr int kGreatestBlock = 7;
constexpr int kGreatestRows = kGreatestBlock * kGreatestBlock;

// The voxels first .. first + width - 1 along each axis: in place where they lie in the grid, else copied.
template <class Label>
class LabelBlock
{
public:
    LabelBlock(const LabelMap<Label>& map, const std::array<int32_t, 3>& first, int width) : width_(width)
    {
        const auto& dims = map.grid.dims;
        bool inside = true;
        for (size_t a = 0; a < 3; ++a)
            inside = inside && first[a] >= 0 && first[a] <= dims[a] - width;
        if (inside) {
            const int64_t start = map.grid.index(first[0], first[1], first[2]);
            material_ = map.material.data() + start;
            weight_ = map.weight.data() + start;
            row_ = dims[0];
            slice_ = int64_t{dims[0]} * dims[1];
        } else {
            copy(map, first);
        }
    }
    LabelBlock(const LabelBlock&) = delete;
    LabelBlock& operator=(const LabelBlock&) = delete;

    int width() const { return width_; }
    const Label* material(int y, int z) const { return material_ + y * row_ + z * slice_; }
    const uint8_t* weight(int y, int z) const { return weight_ + y * row_ + z * slice_; }

private:
    void copy(const LabelMap<Label>& map, const std::array<int32_t, 3>& first)
    {
        const auto& dims = map.grid.dims;
        for (int z = 0; z < width_; ++z)
            for (int y = 0; y < width_; ++y) {
                const int64_t start =
                    map.grid.index(0, mirrored(first[1] + y, dims[1]), mirrored(first[2] + z, dims[2]));
                for (int x = 0; x < width_; ++x) {
                    const auto v = static_cast<size_t>(start + mirrored(first[0] + x, dims[0]));
                    material_copy_[kLanes * (y + width_ * z) + x] = map.material[v];
                    weight_copy_[kLanes * (y + width_ * z) + x] = map.weight[v];
                }
            }
        material_ = material_copy_;
        weight_ = weight_copy_;
        row_ = kLanes;
        slice_ = int64_t{kLanes} * width_;
    }

    int width_;
    const Label* material_ = nullptr;
    const uint8_t* weight_ = nullptr;
    int64_t row_ = 0, slice_ = 0;
    Label material_copy_[kLanes * kGreatestRows];
    uint8_t weight_copy_[kLanes * kGreatestRows];
};

// Hands out the materials of a block one by one, each with its weights A and zeros where another material is.
template <class Label>
class BlockMaterials
{
public:
    explicit BlockMaterials(const LabelBlock<Label>& block) : block_(block), rows_(block.width() * block.width())
    {
        uint8_t lanes[kLanes];
        for (int i = 0; i < kLanes; ++i)
            lanes[i] = i < block.width() ? 0xff : 0;
        for (int r = 0; r < rows_; ++r)
            std::memcpy(left_[r], lanes, kLanes);
    }

    // False when there is no further material. weights[z * width + y] is a row.
    bool next(Label& material, uint8_t (*weights)[kLanes])
    {
        while (open_ < rows_ && empty(open_))
            ++open_;
        if (open_ == rows_)
            return false;
        const int width = block_.width();
        const Label* first = block_.material(open_ % width, open_ / width);
        int lane = 0;
        while (!left_[open_][lane])
            ++lane;
        material = first[lane];
        for (int z = 0, r = 0; z < width; ++z)
            for (int y = 0; y < width; ++y, ++r)
                take(material, block_.material(y, z), block_.weight(y, z), left_[r], weights[r]);
        return true;
    }

private:
    bool empty(int row) const
    {
        uint64_t bits;
        std::memcpy(&bits, left_[row], sizeof(bits));
        return bits == 0;
    }
    static void take(Label material, const Label* row, const uint8_t* weight, uint8_t* left, uint8_t* out)
    {
        for (int i = 0; i < kLanes; ++i) {
            const auto mine = static_cast<uint8_t>(row[i] == material ? left[i] : 0);
            left[i] = static_cast<uint8_t>(left[i] ^ mine);
            out[i] = static_cast<uint8_t>(weight[i] & mine);
        }
    }

    const LabelBlock<Label>& block_;
    int rows_;
    int open_ = 0;
    alignas(16) uint8_t left_[kGreatestRows][kLanes];
};

}  // namespace cleft
