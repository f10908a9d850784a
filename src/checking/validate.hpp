// Is a mesh what the library promises?
#pragma once

#include "base/placement.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <string>

namespace cleft
{

// Tetrahedra with a bad index take no part in the other counts; those with a point that is not finite take no part in
// what needs coordinates. Sides of the bounding box are recognized with a tolerance of 1e-6 of its longest side.
struct Validation {
    // Tetrahedra. Negative or flat by the exact sign, but flat also with a volume below 1e-12 of the cube of
    // its own mean edge.
    int64_t bad_index = 0;        // with a point that is not there
    int64_t repeated_corner = 0;  // with the same point twice
    int64_t negative = 0;
    int64_t flat = 0;
    // Faces.
    int64_t hull_faces = 0;       // of one tetrahedron
    int64_t shared_faces = 0;     // of two
    int64_t crowded_faces = 0;    // of more than two
    int64_t folded_faces = 0;     // of two that lie on one side (exact)
    int64_t hull_off_box = 0;     // hull faces in no side of the bounding box
    int64_t interface_faces = 0;  // of two of different materials
    // Edges of one interface face only that lie in no side of the bounding box.
    int64_t open_interface_edges = 0;
    // Points.
    int64_t non_finite = 0;
    int64_t unused_points = 0;
    int64_t repeated_points = 0;  // used points equal to another one, by rounding to 1e-9 of the longest side
    // In the world; the volume is the sum of signed volumes.
    double volume = 0, box_volume = 0, hull_area = 0, box_area = 0;
    std::string first_fault;  // one sentence naming the first fault and its place; empty if the mesh is valid

    bool valid() const { return first_fault.empty(); }
    // Of a mesh that is not asked to fill its box, and has tetrahedra.
    bool has_more_than_unused_points() const
    {
        return bad_index + repeated_corner + negative + flat + crowded_faces + folded_faces + non_finite +
                   repeated_points >
               0;
    }
};

// With `fills_box`, hull faces off the bounding box, open interface edges, and a volume or hull area unlike the box's
// (by 1e-9) are faults too; a mesh with a material stripped has them by right. An empty `region` stands for one
// region. Volumes, areas and places are reported in the world, in which the mesh lies as `world` says.
// Never throws for a bad mesh: all faults are counts. It throws if it is cancelled, or if the mesh is too large to
// number its faces.
Validation validate(const RegionMesh& mesh, bool fills_box, const Run& run, const Placement& world = {});

}  // namespace cleft
