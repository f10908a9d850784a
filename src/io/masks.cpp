// Turns masks into a label map, so that their boundaries lie midway between voxels and are smoothed as those of labels.
#include "io/masks.hpp"

#include "base/error.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <cstring>
#include <map>
#include <utility>

namespace cleft::io
{

namespace
{

using Pair = std::pair<size_t, size_t>;

struct Claims {
    std::vector<int64_t> voxels;        // that each mask gets
    std::vector<int64_t> wanted;        // that each mask holds
    std::map<Pair, int64_t> contested;  // voxels of two masks: of the one that gets them, and of the next
};

template <class Label>
Claims claim(const std::vector<Field>& masks, Image& labels)
{
    const auto nobody = static_cast<Label>(masks.size());
    Claims claims;
    claims.voxels.resize(masks.size());
    claims.wanted.resize(masks.size());
    for (int64_t v = 0; v < labels.field_size(); ++v)
        store<Label>(labels.voxels.get(), v, nobody);
    for (size_t k = 0; k < masks.size(); ++k)
        for_each_value(*masks[k].image, masks[k].index, [&](int64_t v, double value) {
            if (snapped(value) == 0)
                return;
            ++claims.wanted[k];
            const Label owner = load<Label>(labels.voxels.get(), v);
            if (owner != nobody) {
                ++claims.contested[{static_cast<size_t>(owner), k}];
            } else {
                ++claims.voxels[k];
                store<Label>(labels.voxels.get(), v, static_cast<Label>(k));
            }
        });
    return claims;
}

void note_empty(const std::vector<Field>& masks, const Claims& claims, std::vector<std::string>& notes)
{
    constexpr size_t told = 3;
    size_t empty = 0;
    for (size_t k = 0; k < masks.size(); ++k)
        if (claims.voxels[k] == 0 && ++empty <= told)
            notes.push_back(masks[k].who + ": the mask " +
                            (claims.wanted[k] == 0 ? "holds no voxel" : "holds no voxel that is not in one before it") +
                            ": there is no label " + std::to_string(k));
    if (empty > told)
        notes.push_back(std::to_string(empty - told) + " more masks hold no voxel, or none of their own");
}

void note_contested(const std::vector<Field>& masks, const Claims& claims, std::vector<std::string>& notes)
{
    constexpr size_t told = 3;
    std::vector<std::pair<Pair, int64_t>> rows(claims.contested.begin(), claims.contested.end());
    std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    if (rows.size() > told) {
        notes.push_back(std::to_string(rows.size() - told) +
                        " more pairs of masks share fewer voxels: the first takes them");
        rows.resize(told);
    }
    for (const auto& [pair, voxels] : rows)
        notes.push_back(voxels_text(voxels) + (voxels == 1 ? " is" : " are") + " in the mask " + masks[pair.first].who +
                        " and in " + masks[pair.second].who + ": the first takes " + (voxels == 1 ? "it" : "them"));
}

}  // namespace

Image label_map_of_masks(const std::vector<Field>& masks, std::vector<std::string>& notes)
{
    const Image& first = *masks.front().image;
    Image labels;
    labels.dims = first.dims;
    labels.directions = first.directions;
    labels.spacing = first.spacing;
    labels.origin = first.origin;
    labels.component = masks.size() < 256 ? Component::uint8 : Component::int32;
    allocate_voxels(labels);
    const Claims claims =
        labels.component == Component::uint8 ? claim<uint8_t>(masks, labels) : claim<int32_t>(masks, labels);
    int64_t outside = labels.field_size();
    for (const int64_t voxels : claims.voxels)
        outside -= voxels;
    if (outside == labels.field_size())
        throw Error(CLEFT_ERROR_FORMAT, masks.front().who + " and the others are masks, but no mask holds a voxel");
    note_empty(masks, claims, notes);
    note_contested(masks, claims, notes);
    if (outside > 0)
        notes.push_back(voxels_text(outside) + (outside == 1 ? " is" : " are") + " in no mask: the outside, label " +
                        std::to_string(masks.size()));
    return labels;
}

}  // namespace cleft::io
