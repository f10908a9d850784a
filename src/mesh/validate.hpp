// Is a mesh what the library promises?
#pragma once

#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <string>

namespace cleft
{

struct Validation {
    int64_t negative = 0;              // tetrahedra of negative orientation (exact)
    int64_t flat = 0;                  // exactly flat, or of a volume below 1e-12 mean edge^3
    int64_t repeated_corner = 0;       // tetrahedra that name a point twice
    int64_t bad_index = 0;             // tetrahedra that name a point that is not there
    int64_t non_finite = 0;            // points with a NaN or infinite coordinate
    int64_t crowded_faces = 0;         // faces of more than two tetrahedra
    int64_t folded_faces = 0;          // faces whose two tetrahedra lie on one side
    int64_t hull_off_box = 0;          // hull triangles in no side of the bounding box
    int64_t open_interface_edges = 0;  // edges inside the box with one interface triangle only
    int64_t unused_points = 0;
    int64_t repeated_points = 0;  // points equal to another one (within 1e-9 of the longest side)
    double volume = 0, box_volume = 0, hull_area = 0, box_area = 0;
    std::string first_fault;  // one sentence naming the first fault and its place; empty if the mesh is valid

    bool valid() const { return first_fault.empty(); }
};

// With `fills_box`, hull triangles off the bounding box and a volume or hull area unlike the box's are faults too.
Validation validate(const LabelledMesh& mesh, bool fills_box, const Run& run);

}  // namespace cleft
