// What is in a mesh by material.
#include "mesh/materials.hpp"

#include "base/disjoint_sets.hpp"
#include "base/stage.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/quality.hpp"
#include "mesh/surface_points.hpp"

#include <map>

namespace cleft
{

namespace
{

double tet_volume(const Array<Vec3>& points, const Tet& t)
{
    const auto corner = [&](size_t i) { return points[t[i]]; };
    return orient(corner(0), corner(1), corner(2), corner(3)) / 6;
}

// Counts triangles by the two materials at them. Faces next to each other mostly have the same two.
class Borders
{
public:
    void add(Material a, Material b)
    {
        const std::pair<Material, Material> both = std::minmax(a, b);
        if (last_ == counts_.end() || last_->first != both)
            last_ = counts_.try_emplace(both, 0).first;
        ++last_->second;
    }

    Array<Border> ascending() const
    {
        Array<Border> all;
        for (const auto& [both, triangles] : counts_)
            all.push_back({both.first, both.second, triangles});
        return all;
    }

private:
    // An ordered map, since its order is that of the result.
    std::map<std::pair<Material, Material>, int64_t> counts_;
    std::map<std::pair<Material, Material>, int64_t>::iterator last_ = counts_.end();
};

}  // namespace

Array<double> material_volumes(const Array<Vec3>& points, const Array<Tet>& tets, const Array<Material>& material,
                               Material material_count)
{
    CLEFT_ASSERT(material.size() == tets.size());
    Array<double> volumes(material_count, 0.0);
    for (size_t t = 0; t < tets.size(); ++t)
        if (tets[t][0] >= 0)
            volumes[material[t]] += tet_volume(points, tets[t]);
    return volumes;
}

Array<double> material_volumes(const LabelledMesh& mesh, Material material_count)
{
    return material_volumes(mesh.points, mesh.tets, mesh.material, material_count);
}

// The tetrahedra around a point off the surface have one material and hang together, over faces. So those are joined at
// the point, and only faces with all corners on the surface have to be looked for.
MeshParts mesh_parts(const LabelledMesh& mesh, const Run& run)
{
    const auto material = [&](int32_t t) { return mesh.material[t]; };
    const auto point_count = mesh.points.count();
    Steps steps(run, {{nullptr, 1}, {nullptr, 1}});
    const Array<uint8_t> surface = surface_points(mesh, steps.next());
    DisjointSets sets(mesh.tets.size());
    Array<int32_t> first(mesh.points.size(), -1);  // tetrahedron at a point
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const int32_t p : mesh.tets[t]) {
            int32_t& before = first[p];
            if (before < 0)
                before = static_cast<int32_t>(t);
            else if (surface[p] == 0)
                sets.join(before, static_cast<int32_t>(t));
        }
    Borders borders;
    const FaceBuckets buckets(mesh.tets, point_count, steps.next(), &surface);
    buckets.for_each_face(0, point_count, [&](const HalfFace* face, size_t count) {
        // A face of more than two tetrahedra is no error here; validate() finds such faces.
        for (size_t k = 1; k < count; ++k) {
            const Material here = material(face[k].tet()), before = material(face[k - 1].tet());
            if (here == before)
                sets.join(face[k].tet(), face[k - 1].tet());
            else
                borders.add(here, before);
        }
    });
    return {sets.take(), borders.ascending()};
}

}  // namespace cleft
