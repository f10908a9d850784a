// Turns masks into a label map, so that their boundaries lie midway between voxels and are smoothed as those of labels.
#include "io/masks.hpp"

#include "base/counted.hpp"
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
    std::vector<int64_t> voxels;  // that each mask gets
    std::vector<int64_t> wanted;  // that each mask holds
    // A map and not a table: of hundreds of masks few pairs touch, and the order of messages must
    // be fixed.
    std::map<Pair, int64_t> contested;  // voxels of two masks: of the one that gets them, and of the next
};

template <class Body>
void for_each_inside(const Field& mask, const Body& body)
{
    if (mask.mask)
        return mask.mask->for_each_inside(body);
    for_each_value(*mask.image, mask.index, [&](int64_t v, double value) {
        // Any value but 0 is inside: programs write masks with 1, 255 or the label of an organ.
        if (snapped(value) != 0)
            body(v);
    });
}

template <class Label>
Claims claim(const std::vector<Field>& masks, Image& labels)
{
    // The outside gets the number behind the last mask, so that the labels of the masks are their
    // places on the command line.
    const auto nobody = static_cast<Label>(masks.size());
    Claims claims;
    claims.voxels.resize(masks.size());
    claims.wanted.resize(masks.size());
    for (int64_t v = 0; v < labels.field_size(); ++v)
        store<Label>(labels.voxels.get(), v, nobody);
    for (size_t k = 0; k < masks.size(); ++k)
        for_each_inside(masks[k], [&](int64_t v) {
            ++claims.wanted[k];
            const Label owner = load<Label>(labels.voxels.get(), v);
            // The first mask wins, so the user decides by the order of the files. What the others
            // lose is counted and reported.
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
    // More sentences of one kind hide the other warnings; the rest is counted.
    constexpr size_t kNamed = 3;
    size_t empty = 0;
    for (size_t k = 0; k < masks.size(); ++k)
        if (claims.voxels[k] == 0 && ++empty <= kNamed)
            notes.push_back(masks[k].who + ": the mask " +
                            (claims.wanted[k] == 0 ? "holds no voxel" : "holds no voxel that is not in one before it") +
                            ": there is no label " + std::to_string(k));
    if (empty > kNamed)
        notes.push_back(counted(static_cast<int64_t>(empty - kNamed), "more mask holds", "more masks hold") +
                        " no voxel, or none of their own");
}

void note_contested(const std::vector<Field>& masks, const Claims& claims, std::vector<std::string>& notes)
{
    // As above.
    constexpr size_t kNamed = 3;
    std::vector<std::pair<Pair, int64_t>> rows(claims.contested.begin(), claims.contested.end());
    // The greatest overlap first, as it is the likeliest mistake. Equal ones stay in the order of
    // the masks.
    std::stable_sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    if (rows.size() > kNamed) {
        notes.push_back(std::to_string(rows.size() - kNamed) +
                        " more pairs of masks share fewer voxels: the first takes them");
        rows.resize(kNamed);
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
    // At most 255 masks and the outside fit one byte, a quarter of the memory of the general case.
    labels.component = masks.size() < 256 ? Component::uint8 : Component::int32;
    allocate_voxels(labels);
    const Claims claims =
        labels.component == Component::uint8 ? claim<uint8_t>(masks, labels) : claim<int32_t>(masks, labels);
    int64_t outside = labels.field_size();
    for (const int64_t voxels : claims.voxels)
        outside -= voxels;
    // Masks that are all empty give a mesh of the box alone, which nobody asks for.
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
