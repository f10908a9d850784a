// The plain mesh values that the stages hand to each other.
#pragma once

#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/vec.hpp"

#include <algorithm>
#include <cstdint>

namespace cleft
{

// Corners of a tetrahedron, positively oriented: det[b-a, c-a, d-a] > 0.
using Tet = FixedArray<int32_t, 4>;

inline bool has_corner(const Tet& tet, int32_t point) { return std::find(tet.begin(), tet.end(), point) != tet.end(); }

// A dense material number of a volume, 0 .. count-1. What a user calls it is a UserLabel (Volume::labels).
using Material = int32_t;

// A background mesh: knows nothing of materials.
// Points are in the local frame (base/grid.hpp).
struct TetMesh {
    Array<Vec3> points;
    Array<Tet> tets;
};

// A mesh of a stage: in the frame of the voxels, with the material of each tetrahedron.
struct LabelledMesh {
    Array<Vec3> points;
    Array<Tet> tets;
    Array<Material> material;
};

// A mesh as users have it: in the world, under the numbers of their labels. These are no UserLabel, for the C interface
// lends the array as it is.
struct UserMesh {
    Array<Vec3> points;
    Array<Tet> tets;
    Array<int32_t> labels;
};

// Either of them, seen by what only asks which tetrahedra lie in one region. Borrows the arrays.
struct RegionMesh {
    const Array<Vec3>& points;
    const Array<Tet>& tets;
    const Array<int32_t>& region;

    // No `explicit`: a check takes either mesh as it is.
    RegionMesh(const LabelledMesh& mesh) : points(mesh.points), tets(mesh.tets), region(mesh.material) {}
    RegionMesh(const UserMesh& mesh) : points(mesh.points), tets(mesh.tets), region(mesh.labels) {}
    RegionMesh(const Array<Vec3>& p, const Array<Tet>& t, const Array<int32_t>& r) : points(p), tets(t), region(r) {}
};

}  // namespace cleft
