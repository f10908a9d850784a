// Packs the voxels of a mask into bits, and unpacks them where the files turn out to be functions.
#include "io/packed_mask.hpp"

#include "io/voxel_access.hpp"

#include <algorithm>

namespace cleft::io
{

std::optional<PackedMask> PackedMask::of(const Image& image, int64_t field, const FieldValues& values)
{
    constexpr double kExact = 9007199254740992;  // 2^53: a double holds all whole numbers below
    if (!values.is_mask() || values.not_whole > 0 || values.greatest >= kExact)
        return std::nullopt;
    PackedMask mask;
    mask.inside_ = values.greatest;
    int64_t first = -1, last = -1;
    for_each_value(image, field, [&](int64_t v, double value) {
        if (value == 0)
            return;
        first = first < 0 ? v : first;
        last = v;
    });
    if (first < 0)
        return mask;
    mask.start_ = first;
    mask.words_.resize(static_cast<size_t>((last - first) / kBits + 1), 0);
    for_each_value(image, field, [&](int64_t v, double value) {
        if (value != 0)
            mask.words_[static_cast<size_t>((v - first) / kBits)] |= uint32_t{1} << ((v - first) % kBits);
    });
    return mask;
}

void PackedMask::unpack(Image& image, int64_t field) const
{
    with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        const int64_t count = image.field_size();
        std::byte* const voxels = image.voxels.get() + static_cast<size_t>(field * count) * sizeof(T);
        for (int64_t v = 0; v < count; ++v)
            store<T>(voxels, v, zero);
        for_each_inside([&](int64_t v) { store<T>(voxels, v, static_cast<T>(inside_)); });
    });
}

}  // namespace cleft::io
