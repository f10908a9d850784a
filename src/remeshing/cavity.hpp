// What a local operation takes out of a mesh and puts in. One object is used again and again, so that its memory is
// kept.
#pragma once

#include "base/array.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"
#include "remeshing/local_mesh.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

// No operation may leave a tetrahedron with a smaller least sine: above it the sign of a volume is never in doubt.
// A greater bound would refuse steps by which very flat tetrahedra of a background get better a little at a time.
inline constexpr double kLeastSine = 1e-7;

// Stands for a point that an operation adds, until it is made.
inline constexpr int32_t kNewPoint = -1;

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
    void number_new_point(int32_t number)
    {
        for (Tet& tet : new_tets)
            std::replace(tet.begin(), tet.end(), kNewPoint, number);
    }
    // Keeps the old tetrahedra first, so that undo() can put them back. The caller has made sure of positive volumes.
    void apply(LocalMesh& mesh)
    {
        keep_taken(mesh);
        CLEFT_ASSERT(fills_the_same(mesh));
        mesh.replace(old_tets, new_tets, new_materials, created);
    }
    // The same for several threads at once, for operations that put in no more tetrahedra than they take out: the slots
    // of the others stay taken until release(). `worker`: see LocalMesh::refill().
    void apply_in_place(LocalMesh& mesh, int worker)
    {
        CLEFT_ASSERT(new_tets.size() <= old_tets.size());
        keep_taken(mesh);
        reserve(mesh);
        refill(mesh, worker);
    }
    void undo_in_place(LocalMesh& mesh, int worker)
    {
        mesh.refill(created, taken_tets, taken_materials, old_tets, worker);
    }
    // apply() in the steps of LocalMesh::replace(); for changes that are not taken back.
    void reserve(LocalMesh& mesh) { mesh.reserve(old_tets, new_tets.size(), created); }
    void refill(LocalMesh& mesh, int worker)
    {
        CLEFT_ASSERT(fills_the_same(mesh));
        mesh.refill(old_tets, new_tets, new_materials, created, worker);
    }
    void release(LocalMesh& mesh) { mesh.release(old_tets, new_tets.size()); }
    // As long as nothing but points has changed since. The tetrahedra get new numbers, those in `old_tets`.
    void undo(LocalMesh& mesh) { mesh.replace(created, taken_tets, taken_materials, old_tets); }

private:
    void keep_taken(const LocalMesh& mesh)
    {
        taken_tets.clear();
        taken_materials.clear();
        for (const int32_t t : old_tets) {
            taken_tets.push_back(mesh.tet(t));
            taken_materials.push_back(mesh.material(t));
        }
    }
    // The new tetrahedra are positive, and have the volume of the old ones, up to rounding.
    bool fills_the_same(const LocalMesh& mesh) const
    {
        double before = 0, after = 0, longest = 0;
        const auto six_volumes = [&](const Tet& t) {
            const Vec3& a = mesh.point(t[0]);
            for (const int32_t v : t)
                longest = std::max(longest, (mesh.point(v) - a).norm());
            return orient(a, mesh.point(t[1]), mesh.point(t[2]), mesh.point(t[3]));
        };
        for (const int32_t t : old_tets)
            before += six_volumes(mesh.tet(t));
        bool all_positive = true;
        for (const Tet& t : new_tets) {
            const double volume = six_volumes(t);
            all_positive =
                all_positive && orient_sign(mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2]), mesh.point(t[3])) > 0;
            after += volume;
        }
        return all_positive && std::abs(after - before) <= 1e-9 * longest * longest * longest;
    }
};

}  // namespace cleft
