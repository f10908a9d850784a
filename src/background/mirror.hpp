// The copies of the box behind its walls, which are mirrors.
#pragma once

#include "background/particle_set.hpp"
#include "base/fixed_array.hpp"

namespace cleft
{

// Which copy, counted from the box along each axis.
using CopyNumber = FixedArray<int8_t, 3>;

// On an axis where `odd`, x appears at shift - x, elsewhere at shift + x.
struct MirrorCopy {
    FixedArray<bool, 3> odd;
    Vec3 sign, shift;

    MirrorCopy(const CopyNumber& number, const Vec3& extent)
    {
        for (int a = 0; a < 3; ++a) {
            odd[a] = number[a] % 2 != 0;
            sign[a] = odd[a] ? -1 : 1;
            shift[a] = extent[a] * (odd[a] ? number[a] + 1 : number[a]);
        }
    }
    // The place whose image is x.
    Vec3 origin(const Vec3& x) const { return sign.cwiseProduct(x - shift); }
    // A particle on a wall is its own image in that wall.
    bool has(Walls walls) const
    {
        return !((odd[0] && held(walls, 0)) || (odd[1] && held(walls, 1)) || (odd[2] && held(walls, 2)));
    }
};

}  // namespace cleft
