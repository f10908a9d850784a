// What `--memory` means: a bound on what a rank may hold, which the system keeps, and slabs that leave room.
#pragma once

#include <cstdint>
#include <string>

namespace cleft_mpi_cli
{

// "4G" in bytes, with K, M, G and T for powers of 1024. Throws a usage Failure for what is none.
uint64_t bytes_of_size(const std::string& text);

// From here on, a rank that asks for more memory gets none.
void hold_memory_within(uint64_t bytes);

// The thickest slabs, in planes of voxels, of which a rank can hold what their sizes are computed from, but no more
// than a quarter of the volume. Throws a usage Failure if there are none. `size`: the bound as the user wrote it.
int64_t block_within(uint64_t bytes, const std::string& size, const int64_t dims[3]);

}  // namespace cleft_mpi_cli
