// Points that the parts of a mesh have in common.
#pragma once

#include "io/mesh_data.hpp"

#include <cstdint>
#include <vector>

namespace cleft::io
{

// Points of different parts with the same coordinates become one: the first of them. Equal points of one part stay
// apart, as its writer meant them to. Parts follow one another and have so many points. Coordinates are finite.
void join_shared_points(const std::vector<int64_t>& part_points, MeshData& mesh);

// Points of equal numbers become one, and come in the order of these.
void join_points_of_numbers(const std::vector<int64_t>& numbers, MeshData& mesh);

}  // namespace cleft::io
