// Reads an input as numbers; 0 behind its end.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace fuzz
{

class Bytes
{
public:
    Bytes(const uint8_t* data, size_t size) : at_(data), end_(data + size) {}

    bool are_left() const { return at_ != end_; }

    // Any value of a plain type.
    template <class T>
    T any()
    {
        T value{};
        const size_t bytes = std::min(sizeof value, static_cast<size_t>(end_ - at_));
        std::memcpy(&value, at_, bytes);
        at_ += bytes;
        return value;
    }
    // From 0 to n - 1, n <= 256.
    int below(int n) { return any<uint8_t>() % n; }
    bool one_in(int n) { return below(n) == n - 1; }
    double between(double least, double greatest)
    {
        return least + (greatest - least) * static_cast<double>(any<uint16_t>()) / 65535;
    }
    std::string line()
    {
        const uint8_t* end = std::find(at_, end_, '\n');
        const std::string text(at_, end);
        at_ = end == end_ ? end : end + 1;
        return text;
    }
    // So many bytes: those that are left, again and again.
    std::vector<unsigned char> repeated(size_t count)
    {
        std::vector<unsigned char> made(count);
        const auto left = static_cast<size_t>(end_ - at_);
        for (size_t i = 0; left > 0 && i < count; ++i)
            made[i] = at_[i % left];
        at_ = end_;
        return made;
    }

private:
    const uint8_t* at_;
    const uint8_t* end_;
};

}  // namespace fuzz
