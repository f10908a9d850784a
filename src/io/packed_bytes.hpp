// Arrays of bytes that are packed and unpacked at once, by libdeflate.
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace cleft::io
{

enum class Wrapping { gzip, zlib };

// The default of zlib and of libdeflate.
inline constexpr int kUsualPacking = 6;

std::string packed_bytes(std::string_view bytes, Wrapping wrapping, int level = kUsualPacking);

// A stream of zlib into exactly `bytes` bytes; false if it is damaged or has another number.
bool unpack_zlib(std::string_view packed, char* to, size_t bytes);

// A stream of deflate without a wrapping, which does not say how long it is. Nothing if it is damaged.
std::optional<std::string> unpacked_deflate(std::string_view packed);

}  // namespace cleft::io
