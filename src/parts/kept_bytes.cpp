// Whether there is a file decides where bytes are, and nothing else does.
#include "parts/kept_bytes.hpp"

#include <cstring>

namespace cleft
{

KeptBytes::KeptBytes(const std::string& scratch)
{
    if (!scratch.empty())
        file_ = std::make_unique<ScratchFile>(scratch);
}

void KeptBytes::clear()
{
    for (auto& [number, kept] : kept_) {
        kept.size = 0;
        kept.bytes = Array<unsigned char>();
    }
}

int64_t KeptBytes::count_bytes(int64_t number) const
{
    const auto found = kept_.find(number);
    return found == kept_.end() ? 0 : found->second.size;
}

void KeptBytes::put_bytes(int64_t number, const void* bytes, int64_t size)
{
    Kept& kept = kept_[number];
    const auto* first = static_cast<const unsigned char*>(bytes);
    if (file_)
        file_->write(kept.place, first, size);
    else
        kept.bytes = Array<unsigned char>(first, first + size);
    kept.size = size;
}

void KeptBytes::get_bytes(int64_t number, int64_t first, int64_t size, void* to) const
{
    if (size == 0)
        return;
    const Kept& kept = kept_.at(number);
    CLEFT_ASSERT(first >= 0 && first + size <= kept.size);
    if (file_)
        file_->read(kept.place, first, size, to);
    else
        std::memcpy(to, kept.bytes.data() + first, to_size(size));
}

}  // namespace cleft
