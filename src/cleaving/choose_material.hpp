// The material of an output tetrahedron.
#pragma once

#include "base/fixed_array.hpp"
#include "cleaving/split_tet.hpp"

namespace cleft
{

// A point of a split tetrahedron belongs to all materials of the corners that carry it; an output tetrahedron has the
// material that its four points share. Snapped corners may leave several to choose from, or none. A whole
// background tetrahedron of two keeps the one it had, so that snapping changes no topology (pinch.hpp); else the volume
// decides at the centroid, among those shared, or else among all that the four points have.
class MaterialChooser
{
public:
    MaterialChooser(const Centres& c, const Tet& corners);

    // x: of the four points of t.
    // `scratch` holds the samples of the last call; each thread needs its own.
    Material choose(const StencilTet& t, const FixedArray<Vec3, 4>& x, Samples& scratch) const;

    // Of the tetrahedron itself, which has no cuts: `kept`, of Centres, comes first among those shared.
    Material choose_whole(uint16_t kept, const FixedArray<Vec3, 4>& x, Samples& scratch) const;

private:
    uint64_t of_point(uint8_t p) const;

    const Volume& volume_;
    // Materials of the four corners, ascending, and which of them each corner has.
    FixedArray<Material, 4 * MaterialSet::kCapacity> material_;
    int count_ = 0;
    FixedArray<uint64_t, 4> of_corner_{};
};

static_assert(4 * MaterialSet::kCapacity <= 64, "the materials of four corners are bits of one word");

}  // namespace cleft
