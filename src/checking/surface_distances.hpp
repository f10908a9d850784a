// How far the interfaces of a mesh are from those of its volume, and its lines from the volume's lines.
#pragma once

#include "base/array.hpp"
#include "base/placement.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"
#include "volume/tie_points.hpp"
#include "volume/volume.hpp"

namespace cleft
{

// Of many distances. All are 0 where there are none.
struct DistanceFigures {
    double mean = 0;
    double most = 0;  // 99 % of them are no greater
    double greatest = 0;
};

// Of two materials, or of three at a line.
struct SurfaceDistances {
    TieMaterials of;
    int64_t elements = 0;    // triangles of an interface, edges of a line
    int64_t points = 0;      // of the interface or the line in the volume
    DistanceFigures mesh;    // from the elements to the volume's interface
    DistanceFigures volume;  // from the points to the elements
};

// The interface of two materials in a volume is where their indicator functions tie and no other is greater, and a line
// is where three tie.
//   From the mesh: the places are those of tie_samples(), weighted by area or length, and the distance is that to the
// nearest point of the tie.
//   From the volume: the places are those of find_interface_points() and find_line_points(), all of one weight, and the
// distance is that to the nearest triangle or edge of the same materials.
// tie_surfaces.hpp says what stands for materials that the other side does not have together.
// `mesh` in the local frame; lengths are those of `world`. Rows ascend by material, lines after interfaces. Materials
// that the mesh lacks have none.
Array<SurfaceDistances> surface_distances(const Volume& volume, const LabelledMesh& mesh, const Placement& world,
                                          const Run& run);

}  // namespace cleft
