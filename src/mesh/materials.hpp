// What is in a mesh by material: volumes, connected parts and common borders.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Two materials, the lesser first, and the number of triangles between them.
struct Border {
    Material first, second;
    int64_t triangles;
};

struct MeshParts {
    Array<int32_t> of_tet;  // the connected part, over shared faces: named by its least tetrahedron
    Array<Border> borders;  // of all materials that share triangles, ascending
};

// Both from one look at the faces.
MeshParts mesh_parts(const LabelledMesh& mesh, const Run& run);

// Volume of each material.
// In the frame of the points, by material number. Inverted tetrahedra count negative. The sum runs in the order of the
// tetrahedra, so it is the same for any number of threads.
Array<double> material_volumes(const LabelledMesh& mesh, Material material_count, const Run& run = Run());
// The same; dead tetrahedra, whose first corner is -1, are passed over.
Array<double> material_volumes(const Array<Vec3>& points, const Array<Tet>& tets, const Array<Material>& material,
                               Material material_count, const Run& run = Run());

}  // namespace cleft
