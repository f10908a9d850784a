// Enumerates every pattern of cuts and diagonals, so that splitting a tetrahedron is one look into a table.
#include "cleaving/stencil_table.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Bits of the faces with two cuts.
// Only these faces have a diagonal to choose; a pattern with other bits set cannot come up.
Diagonals faces_with_choice(CutMask cuts)
{
    Diagonals faces = 0;
    for (size_t face = 0; face < 4; ++face) {
        const CutMask in_face = cuts & kFaceCuts[face], without_lowest = in_face & (in_face - 1);
        if (without_lowest && !(without_lowest & (without_lowest - 1)))
            faces |= 1u << face;
    }
    return faces;
}

// Two fans with the same tetrahedra in another order are one stencil. Otherwise its shape would be measured twice.
Array<StencilTet> in_order(const StencilTet* begin, const StencilTet* end)
{
    Array<StencilTet> tets(begin, end);
    for (StencilTet& t : tets)
        std::sort(t.begin(), t.end());
    std::sort(tets.begin(), tets.end());
    return tets;
}

}  // namespace

StencilTable::StencilTable() : first_tet_(1, 0)
{
    for (CutMask cuts = 0; cuts <= kAllCuts; ++cuts)
        for (Diagonals d = 0; d < 16; ++d)
            if (!(d & ~faces_with_choice(cuts)))
                add_pattern(cuts, d);
}

void StencilTable::add_pattern(CutMask cuts, Diagonals diagonals)
{
    const SplitSurface surface = split_surface(cuts, diagonals);
    const Apexes found = apexes(cuts, surface);
    Range& range = of_pattern_[cuts << 4 | diagonals];
    range.begin = range.end = static_cast<uint16_t>(first_tet_.size() - 1);
    for (int a = 0; a < found.count; ++a) {
        FixedArray<StencilTet, 24> fanned;
        const int count = fan(surface, found.point[a], fanned);
        const auto same = [&, wanted = in_order(fanned.data(), fanned.data() + count)](uint16_t stencil) {
            return in_order(tets(stencil).begin(), tets(stencil).end()) == wanted;
        };
        bool is_new = true;
        for (uint16_t s = range.begin; s < range.end; ++s)
            is_new = is_new && !same(s);
        if (!is_new)
            continue;
        tets_.insert(tets_.end(), fanned.begin(), fanned.begin() + count);
        first_tet_.push_back(static_cast<uint32_t>(tets_.size()));
        ++range.end;
    }
}

}  // namespace cleft
