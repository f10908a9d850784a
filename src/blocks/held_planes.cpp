// Planes that are missing are made run by run, since what is around them costs as much for one as for many.
#include "blocks/held_planes.hpp"

namespace cleft
{

void HeldPlanes::fill(Planes wanted, const std::function<Volume(Planes planes)>& make)
{
    for (int32_t k = wanted.first; k < wanted.end(); ++k) {
        Planes missing{k, 0};
        while (missing.end() < wanted.end() && !planes_.has(missing.end()))
            ++missing.count;
        if (missing.count == 0)
            continue;
        const Volume made = make(missing);
        for (; k < missing.end(); ++k)
            planes_.put(k, made.stored_plane(k));
    }
}

}  // namespace cleft
