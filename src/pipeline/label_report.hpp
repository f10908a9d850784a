// What became of each label: volumes and connected components in the volume and in the mesh.
#pragma once

#include "base/array.hpp"
#include "mesh/tet_mesh.hpp"
#include "volume/volume.hpp"

namespace cleft
{

struct LabelRow {
    UserLabel label{};
    int64_t voxels = 0;
    double voxel_volume = 0, mesh_volume = 0;  // in the frame of the voxels
    int64_t tets = 0;
    int64_t voxel_components = 0, mesh_components = 0;
    // Of more than kLargeComponent voxels: all, those without a tetrahedron, and those in several parts of the mesh.
    int64_t large_components = 0, large_components_lost = 0, large_components_broken = 0;
    int64_t large_components_joined = 0;  // those in a part of the mesh with another of them
};

// Two materials, that of the lesser label first, that share triangles in the mesh but of which no two voxels share a
// face or an edge.
struct LabelContact {
    Material first, second;
    int64_t triangles;
};

struct LabelReport {
    Array<LabelRow> rows;          // by material
    Array<LabelContact> contacts;  // by label, ascending
};

// Voxels. Segmentations have many specks of a few voxels, which are noise as a rule; losing one is no news. More than
// 30 are a cube of three voxels and some.
inline constexpr int64_t kLargeComponent = 30;
// A mesh may cut off a fragment smaller than any voxel at a tip. That is no break that a user could see.
inline constexpr double kLeastPart = 0.5;  // in voxels: what is smaller breaks nothing

// `mesh` in the local frame of the volume.
LabelReport label_report(const Volume& volume, const LabelledMesh& mesh, const Run& run);

}  // namespace cleft
