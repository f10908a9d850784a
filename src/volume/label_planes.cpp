// Copies planes, and keeps what is known of a voxel within the planes that were seen.
#include "volume/label_planes.hpp"

#include <algorithm>
#include <cstring>
#include <type_traits>

namespace cleft
{

namespace
{

// A depth says how far around a voxel all others are like it. Beyond the cut nobody has looked.
void bound_depths(uint8_t* code, int64_t count, int32_t planes_to_cut)
{
    const int bound = kBumpGreatest + std::clamp(planes_to_cut, 1, kDepthGreatest);
    for (int64_t i = 0; i < count; ++i)
        code[i] = static_cast<uint8_t>(std::min<int>(code[i], bound));
}

}  // namespace

Planes planes_around(const Grid& whole, Planes planes, int32_t around)
{
    const int32_t first = std::max(0, planes.first - around);
    return {first, std::min(whole.dims[2], planes.end() + around) - first};
}

template <class Label>
Array<unsigned char> stored_plane(const LabelMap<Label>& map, int32_t k)
{
    const int64_t begin = map.index(0, 0, k), count = map.grid.plane_size();
    Array<unsigned char> bytes;
    bytes.reserve(to_size(count) * (sizeof(Label) + 2));
    const auto add = [&](const auto& values) {
        const auto* first = reinterpret_cast<const unsigned char*>(values.data() + begin);
        bytes.insert(bytes.end(), first, first + to_size(count) * sizeof(values.front()));
    };
    add(map.material);
    add(map.weight);
    add(map.code);
    return bytes;
}

template <class Label>
LabelMap<Label> restored(const Grid& whole, Planes sampled, int kernel, const StoredPlane& plane)
{
    const Planes held = planes_around(whole, sampled, kPlanesOfSample);
    const int64_t count = whole.plane_size(), all = held.count * count + kLanes;
    LabelMap<Label> map;
    map.grid = whole;
    map.kernel = Hann(kernel);
    map.planes = sampled;
    map.first = held.first * count;
    map.material.resize(to_size(all));
    map.weight.resize(to_size(all));
    map.code.resize(to_size(all));
    for (int32_t k = held.first; k < held.end(); ++k) {
        const Array<unsigned char> bytes = plane(k);
        CLEFT_ASSERT(bytes.count() == count * int64_t{sizeof(Label) + 2});
        const unsigned char* from = bytes.data();
        const auto take = [&](auto& values) {
            const size_t size = to_size(count) * sizeof(values.front());
            std::memcpy(values.data() + map.index(0, 0, k), from, size);
            from += size;
        };
        take(map.material);
        take(map.weight);
        take(map.code);
    }
    return map;
}

template <class Label>
void place_in_whole(LabelMap<Label>& map, const Grid& whole, int32_t first)
{
    const int32_t end = first + map.grid.dims[2];
    constexpr int32_t kAround = kPlanesOfWeight + kPlanesOfSample;
    const int32_t low = first > 0 ? first + kAround : 0;
    const int32_t high = end < whole.dims[2] ? end - kAround : whole.dims[2];
    CLEFT_ASSERT(low < high);
    for (int32_t k = first; k < end; ++k) {
        const int32_t below = first > 0 ? k - first : kDepthGreatest;
        const int32_t above = end < whole.dims[2] ? end - 1 - k : kDepthGreatest;
        bound_depths(map.code.data() + (k - first) * whole.plane_size(), whole.plane_size(), std::min(below, above));
    }
    map.grid = whole;
    map.planes = {low, high - low};
    map.first = first * whole.plane_size();
}

template <class Label>
LabelMap<Label> cropped(const LabelMap<Label>& map, Planes planes)
{
    LabelMap<Label> out;
    out.grid = map.grid;
    out.grid.dims[2] = planes.count;
    out.kernel = map.kernel;
    out.planes = {0, planes.count};
    const int64_t begin = planes.first * map.grid.plane_size() - map.first, count = out.grid.size();
    const auto copied = [&](const auto& values) {
        auto copy = std::decay_t<decltype(values)>(to_size(count) + kLanes);
        std::copy_n(values.data() + begin, count, copy.data());
        return copy;
    };
    out.material = copied(map.material);
    out.weight = copied(map.weight);
    out.code = copied(map.code);
    return out;
}

template Array<unsigned char> stored_plane(const LabelMap<uint8_t>&, int32_t);
template Array<unsigned char> stored_plane(const LabelMap<uint16_t>&, int32_t);
template LabelMap<uint8_t> restored(const Grid&, Planes, int, const StoredPlane&);
template LabelMap<uint16_t> restored(const Grid&, Planes, int, const StoredPlane&);
template void place_in_whole(LabelMap<uint8_t>&, const Grid&, int32_t);
template void place_in_whole(LabelMap<uint16_t>&, const Grid&, int32_t);
template LabelMap<uint8_t> cropped(const LabelMap<uint8_t>&, Planes);
template LabelMap<uint16_t> cropped(const LabelMap<uint16_t>&, Planes);

}  // namespace cleft
