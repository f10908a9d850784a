// Planes that are missing are made run by run, since what is around them costs as much for one as for many.
#include "parts/held_planes.hpp"

#include <utility>

namespace cleft
{

HeldPlanes::HeldPlanes(const std::string& scratch)
{
    if (!scratch.empty())
        file_ = std::make_unique<ScratchFile>(scratch);
}

void HeldPlanes::fill(Planes wanted, const std::function<Volume(Planes planes)>& make)
{
    for (int32_t k = wanted.first; k < wanted.end(); ++k) {
        Planes missing{k, 0};
        while (missing.end() < wanted.end() && planes_.find(missing.end()) == planes_.end())
            ++missing.count;
        if (missing.count == 0)
            continue;
        const Volume made = make(missing);
        for (; k < missing.end(); ++k)
            keep(k, made.stored_plane(k));
    }
}

Array<unsigned char> HeldPlanes::plane(int32_t k) const
{
    const Kept& kept = planes_.at(k);
    return file_ ? file_->read(kept.record) : Array<unsigned char>(kept.bytes.begin(), kept.bytes.end());
}

void HeldPlanes::keep(int32_t k, Array<unsigned char>&& bytes)
{
    Kept kept;
    if (file_)
        file_->write(kept.record, bytes);
    else
        kept.bytes = std::move(bytes);
    planes_.emplace(k, std::move(kept));
}

}  // namespace cleft
