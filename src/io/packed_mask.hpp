// A mask at one bit a voxel: what several files mean is known when all are read, so that all have to be in memory.
#pragma once

#include "io/field_values.hpp"
#include "io/image.hpp"

#include <optional>
#include <vector>

namespace cleft::io
{

class PackedMask
{
public:
    // Nothing where the voxels could not be given back as they were.
    static std::optional<PackedMask> of(const Image& image, int64_t field, const FieldValues& values);

    // Calls body(voxel) for those inside, from the first to the last.
    template <class Body>
    void for_each_inside(const Body& body) const
    {
        for (size_t w = 0; w < words_.size(); ++w)
            for (int64_t bit = 0; words_[w] != 0 && bit < kBits; ++bit)
                if (words_[w] >> bit & 1U)
                    body(start_ + static_cast<int64_t>(w) * kBits + bit);
    }

    // Writes the voxels of the field, which has room for them.
    void unpack(Image& image, int64_t field) const;

private:
    static constexpr int64_t kBits = 32;

    int64_t start_ = 0;  // the first voxel inside: most masks fill a part of the volume, and no bit is kept around it
    double inside_ = 0;  // the value of those inside
    std::vector<uint32_t> words_;
};

}  // namespace cleft::io
