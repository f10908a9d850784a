// The copies of the box behind its walls, which are mirrors.
#pragma once

#include "background/particle_set.hpp"

#include <array>

namespace cleft
{

// Which copy, counted from the box along each axis.
using CopyNumber = std::array<int8_t, 3>;

// On an axis where `odd`, x appears at shift - x, elsewhere at shift + x.
struct MirrorCopy {
    std::array<bool, 3> odd;
    Vec3 sign, shift;

    MirrorCopy(const CopyNumber& number, const Vec3& extent)
    {
        for (size_t a = 0; a < 3; ++a) {
            const auto axis = static_cast<int>(a);
            odd[a] = number[a] % 2 != 0;
            sign[axis] = odd[a] ? -1 : 1;
            shift[axis] = extent[axis] * (odd[a] ? number[a] + 1 : number[a]);
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
