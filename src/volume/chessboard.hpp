// The distance in the maximum norm (moves of a king in chess), in bytes.
#pragma once

#include "base/grid.hpp"
#include "base/run.hpp"

#include <cstdint>

namespace cleft
{

// On entry 0 or `greatest` (at most 254); on return min(greatest, distance to the nearest 0) in grid steps. One thread
// does it, since each row needs the one before. The progress of `run` goes from 0 to 1.
void chessboard_distance(const Grid& grid, uint8_t* distance, int greatest, const Run& run);

}  // namespace cleft
