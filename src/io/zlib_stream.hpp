// Compresses large arrays on all threads, so that a cancel is seen meanwhile.
#pragma once

#include "base/run.hpp"

#include <cstddef>
#include <string>

namespace cleft::io
{

// The bytes as one stream in zlib's format, the same for any number of threads. `level` is one of zlib, 1 to 9.
std::string zlib_stream(const Run& run, const void* data, size_t bytes, int level);

}  // namespace cleft::io
