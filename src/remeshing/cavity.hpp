// What a local operation takes out of a mesh and puts in. One object is used again and again, so that its memory is
// kept.
#pragma once

#include "base/array.hpp"
#include "mesh/quality.hpp"
#include "remeshing/local_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

// No operation may leave a tetrahedron with a smaller least sine: above it the sign of a volume is never in doubt.
inline constexpr double kLeastSine = 1e-7;

struct Cavity {
    EdgeRing ring, other_ring;
    Array<int32_t> old_tets;
    Array<Tet> new_tets;
    Array<Material> new_materials;
    Array<int32_t> created;  // after the operation: the numbers of the new tetrahedra
    // What was taken out, to take the operation back.
    Array<Tet> taken_tets;
    Array<Material> taken_materials;

    void clear()
    {
        old_tets.clear();
        new_tets.clear();
        new_materials.clear();
        created.clear();
    }
    void add(const Tet& tet, Material material)
    {
        new_tets.push_back(tet);
        new_materials.push_back(material);
    }
    void apply(LocalMesh& mesh)
    {
        taken_tets.clear();
        taken_materials.clear();
        for (const int32_t t : old_tets) {
            taken_tets.push_back(mesh.tet(t));
            taken_materials.push_back(mesh.material(t));
        }
        mesh.replace(old_tets, new_tets, new_materials, created);
    }
    // As long as nothing but points has changed since. The tetrahedra get new numbers, those in `old_tets`.
    void undo(LocalMesh& mesh) { mesh.replace(created, taken_tets, taken_materials, old_tets); }
};

}  // namespace cleft
