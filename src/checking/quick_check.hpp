// The check that every result of the library passes before a user gets it: cheap, and exact. The whole one, of faces,
// hull and interfaces too, is validate().
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <string>

namespace cleft
{

// Of equal places, whatever the sign of a zero, equal numbers, and an order of different ones.
uint64_t hash_of_place(const Vec3& point);
bool is_before(const Vec3& a, const Vec3& b);

// "" if all coordinates are finite, no two points are at one place, and every tetrahedron is positively oriented by the
// exact predicate; else the first fault in words. All point numbers must be in range.
std::string quick_fault(const Array<Vec3>& points, const Array<Tet>& tets, const Run& run);

}  // namespace cleft
