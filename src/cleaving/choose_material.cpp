// Chooses materials by sets, kept as bits of one word: intersections and unions are single instructions.
#include "cleaving/choose_material.hpp"

#include <limits>

namespace cleft
{

MaterialChooser::MaterialChooser(const Centres& c, const Tet& corners) : volume_(c.volume)
{
    const MaterialSet& first = c.materials_of(corners[0]);
    // Most tetrahedra lie inside one material; they skip the sets and the volume.
    if (first.size() == 1 &&
        std::all_of(corners.begin(), corners.end(), [&](int32_t v) { return c.materials_of(v) == first; })) {
        material_[count_++] = first[0];
        return;
    }
    for (const int32_t v : corners)
        for (const Material m : c.materials_of(v))
            material_[count_++] = m;
    std::sort(material_.begin(), material_.begin() + count_);
    count_ = static_cast<int>(std::unique(material_.begin(), material_.begin() + count_) - material_.begin());
    for (size_t i = 0; i < 4; ++i)
        for (const Material m : c.materials_of(corners[i]))
            of_corner_[i] |=
                uint64_t{1} << (std::lower_bound(material_.begin(), material_.begin() + count_, m) - material_.begin());
}

uint64_t MaterialChooser::of_point(uint8_t p) const
{
    uint64_t materials = 0;
    for (size_t i = 0; i < 4; ++i)
        if (kCarrier[p] >> i & 1u)
            materials |= of_corner_[i];
    return materials;
}

Material MaterialChooser::choose(const StencilTet& t, const FixedArray<Vec3, 4>& x, Samples& scratch) const
{
    if (count_ == 1)
        return material_[0];
    const FixedArray<uint64_t, 4> of = {of_point(t[0]), of_point(t[1]), of_point(t[2]), of_point(t[3])};
    uint64_t candidates = of[0] & of[1] & of[2] & of[3];
    // One common material needs no sample of the volume, which costs far more than all else here.
    const bool is_single = candidates && !(candidates & (candidates - 1));
    if (!candidates)
        candidates = of[0] | of[1] | of[2] | of[3];
    if (!is_single)
        volume_.sample((x[0] + x[1] + x[2] + x[3]) / 4, scratch);
    Material best = -1;
    double greatest = -std::numeric_limits<double>::infinity();
    for (int i = 0; i < count_; ++i) {
        if (!(candidates >> i & 1u))
            continue;
        if (is_single)
            return material_[i];
        const int entry = scratch.find(material_[i]);
        const double value = entry < 0 ? 0.0 : scratch.value[entry];
        // Of equal values the lesser material wins, as at the vertices of the background.
        if (best < 0 || value > greatest) {
            best = material_[i];
            greatest = value;
        }
    }
    CLEFT_ASSERT(best >= 0);
    return best;
}

Material MaterialChooser::choose_whole(uint16_t kept, const FixedArray<Vec3, 4>& x, Samples& scratch) const
{
    const uint64_t shared = of_corner_[0] & of_corner_[1] & of_corner_[2] & of_corner_[3];
    for (int i = 0; i < count_; ++i)
        if (material_[i] == kept && (shared >> i & 1u))
            return kept;
    return choose({0, 1, 2, 3}, x, scratch);
}

}  // namespace cleft
