// All that a tetrahedron can split into, worked out once.
#pragma once

#include "base/array.hpp"
#include "cleaving/stencil.hpp"

namespace cleft
{

// Stencils: the tetrahedra of one fan. Apexes that give the same tetrahedra are listed once.
class StencilTable
{
public:
    // There are 64 masks of cuts with at most 16 choices of diagonals each, so the table is made anew for each run.
    StencilTable();

    struct Range {
        uint16_t begin, end;
    };

    // The stencils of a pattern of cuts.
    Range stencils(CutMask cuts, Diagonals diagonals) const { return of_pattern_[cuts << 4 | diagonals]; }

    struct Tets {
        const StencilTet *first, *last;
        const StencilTet* begin() const { return first; }
        const StencilTet* end() const { return last; }
        int64_t size() const { return last - first; }
    };

    Tets tets(uint16_t stencil) const
    {
        return {tets_.data() + first_tet_[stencil], tets_.data() + first_tet_[stencil + size_t{1}]};
    }

private:
    void add_pattern(CutMask cuts, Diagonals diagonals);

    std::array<Range, 64 * 16> of_pattern_{};
    Array<uint32_t> first_tet_;  // of each stencil, and the end of the last
    Array<StencilTet> tets_;
};

}  // namespace cleft
