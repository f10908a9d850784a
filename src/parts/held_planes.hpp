// Planes of a label map with their weights, made once.
#pragma once

#include "parts/scratch_file.hpp"
#include "volume/volume.hpp"

#include <functional>
#include <map>
#include <memory>

namespace cleft
{

class HeldPlanes
{
public:
    // `scratch`: the folder where planes are kept; empty: they are in memory.
    explicit HeldPlanes(const std::string& scratch);

    // Makes those that are not here yet. `make(planes)` gives a part of the volume that can be sampled there.
    void fill(Planes wanted, const std::function<Volume(Planes planes)>& make);
    // As Volume::stored_plane() gave it.
    Array<unsigned char> plane(int32_t k) const;

private:
    void keep(int32_t k, Array<unsigned char>&& bytes);

    struct Kept {
        Array<unsigned char> bytes;  // empty: in the file
        ScratchFile::Record record;
    };
    std::map<int32_t, Kept> planes_;
    std::unique_ptr<ScratchFile> file_;
};

}  // namespace cleft
