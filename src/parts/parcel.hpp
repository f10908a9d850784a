// Several arrays as one message.
#pragma once

#include "base/array.hpp"

#include <cstring>
#include <type_traits>

namespace cleft
{

// Arrays go in and come out in the same order. Their items have no memory of their own. (Vec3 is not trivially copyable
// by the letter, but it is its three numbers.)
class Parcel
{
public:
    Parcel() = default;
    explicit Parcel(Array<unsigned char> bytes) : bytes_(std::move(bytes)) {}

    template <class T>
    void put(const Array<T>& items)
    {
        static_assert(std::is_trivially_destructible_v<T>, "items travel as bytes");
        const int64_t count = items.count();
        put_bytes(&count, sizeof count);
        put_bytes(items.data(), items.size() * sizeof(T));
    }
    template <class T>
    void take(Array<T>& items)
    {
        int64_t count = 0;
        take_bytes(&count, sizeof count);
        items.resize(to_size(count));
        take_bytes(items.data(), items.size() * sizeof(T));
    }

    bool empty() const { return bytes_.empty(); }
    const Array<unsigned char>& bytes() const { return bytes_; }
    Array<unsigned char> take_all() { return std::move(bytes_); }

private:
    void put_bytes(const void* from, size_t count)
    {
        const auto* first = static_cast<const unsigned char*>(from);
        bytes_.insert(bytes_.end(), first, first + count);
    }
    void take_bytes(void* to, size_t count)
    {
        CLEFT_ASSERT(at_ + count <= bytes_.size());
        if (count > 0)
            std::memcpy(to, bytes_.data() + at_, count);
        at_ += count;
    }

    Array<unsigned char> bytes_;
    size_t at_ = 0;
};

}  // namespace cleft
