// Planes of a label map with their weights, made once.
#pragma once

#include "parts/kept_bytes.hpp"
#include "volume/volume.hpp"

#include <functional>

namespace cleft
{

class HeldPlanes
{
public:
    // `scratch`: the folder where planes are kept; empty: they are in memory.
    explicit HeldPlanes(const std::string& scratch) : planes_(scratch) {}

    // Makes those that are not here yet. `make(planes)` gives a part of the volume that can be sampled there.
    void fill(Planes wanted, const std::function<Volume(Planes planes)>& make);
    // As Volume::stored_plane() gave it.
    Array<unsigned char> plane(int32_t k) const { return planes_.get<unsigned char>(k); }

private:
    KeptBytes planes_;
};

}  // namespace cleft
