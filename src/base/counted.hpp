// How sentences for the user count things: "1 voxel", "2 voxels", "1 tetrahedron", "2 tetrahedra".
#pragma once

#include <cstdint>
#include <string>

namespace cleft
{

inline std::string counted(int64_t count, const char* one, const char* many)
{
    return std::to_string(count) + " " + (count == 1 ? one : many);
}

// With the plural that adds an s.
inline std::string counted(int64_t count, const char* noun)
{
    return std::to_string(count) + " " + noun + (count == 1 ? "" : "s");
}

inline const char* is_or_are(int64_t count) { return count == 1 ? "is" : "are"; }

}  // namespace cleft
