// The plain mesh values that the stages hand to each other.
#pragma once

#include "base/vec.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

namespace cleft
{

// Corners of a tetrahedron, positively oriented: det[b-a, c-a, d-a] > 0.
using Tet = std::array<int32_t, 4>;

inline bool has_corner(const Tet& tet, int32_t point) { return std::find(tet.begin(), tet.end(), point) != tet.end(); }

// A number of a point, tetrahedron or corner as the standard library counts.
constexpr size_t at(int32_t i) { return static_cast<size_t>(i); }

// A dense material number of a volume, 0 .. count-1 (see Volume::labels for the user's values).
using Material = int32_t;

// A background mesh: knows nothing of materials.
struct TetMesh {
    std::vector<Vec3> points;
    std::vector<Tet> tets;
};

// A mesh of a stage: in the frame of the voxels, with the material of each tetrahedron.
struct LabelledMesh {
    std::vector<Vec3> points;
    std::vector<Tet> tets;
    std::vector<Material> material;
};

// A mesh as users have it: in the world, under their labels, any numbers of 32 bits.
struct UserMesh {
    std::vector<Vec3> points;
    std::vector<Tet> tets;
    std::vector<int32_t> labels;
};

// Either of them, seen by what only asks which tetrahedra lie in one region. Borrows the arrays.
struct RegionMesh {
    const std::vector<Vec3>& points;
    const std::vector<Tet>& tets;
    const std::vector<int32_t>& region;

    RegionMesh(const LabelledMesh& mesh) : points(mesh.points), tets(mesh.tets), region(mesh.material) {}
    RegionMesh(const UserMesh& mesh) : points(mesh.points), tets(mesh.tets), region(mesh.labels) {}
    RegionMesh(const std::vector<Vec3>& p, const std::vector<Tet>& t, const std::vector<int32_t>& r)
        : points(p), tets(t), region(r)
    {
    }
};

}  // namespace cleft
