// Rows of whole numbers, small: what the page unpacks again (page/unpack.js).
#pragma once

#include "base/run.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

// `numbers` are rows of `columns` numbers. The first of a row is written as its difference to that of the row before,
// and the others as theirs to the first of their row (kRow) or to the same column of the row before (kColumn).
// Differences are small where rows are in an order of space. They are then made positive (0, -1, 1, -2, ... as 0, 1, 2,
// 3, ...), split into four planes of bytes, compressed in zlib's format, and written as base64.
enum class Differences { kRow, kColumn };
std::string pack(const std::vector<int32_t>& numbers, size_t columns, Differences differences, const Run& run);

}  // namespace cleft::io
