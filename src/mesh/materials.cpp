// What is in a mesh by material.
#include "mesh/materials.hpp"

#include "base/collect.hpp"
#include "base/disjoint_sets.hpp"
#include "base/stage.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/quality.hpp"
#include "mesh/surface_points.hpp"

#include <limits>
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
    void add(Material a, Material b, int64_t triangles = 1)
    {
        const std::pair<Material, Material> both = std::minmax(a, b);
        if (last_ == counts_.end() || last_->first != both)
            last_ = counts_.try_emplace(both, 0).first;
        last_->second += triangles;
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

// The tetrahedra around a point off the surface have one material and hang together, over faces. So such points stand
// for all tetrahedra at them, and only faces with all corners on the surface have to be looked for.
class PartSets
{
public:
    PartSets(const LabelledMesh& mesh, const Array<uint8_t>& surface, const Run& run)
        : mesh_(mesh), surface_(surface), number_(large_array<int32_t>(mesh.tets.size())), sets_(count_members(run))
    {
        parallel_for(run, mesh.tets.count(), kTetsAtOnce, [&](int64_t begin, int64_t end) {
            for (int64_t t = begin; t < end; ++t)
                for (const int32_t p : mesh.tets[t])
                    if (surface[p] == 0)
                        sets_.join(number_[t], p);
        });
    }

    // May be called by several threads.
    void join(int32_t tet, int32_t other) { sets_.join(number_[tet], number_[other]); }

    // By tetrahedron: the least one of its set.
    Array<int32_t> take(const Run& run)
    {
        Array<int32_t> least = sets_.take();  // first the root of each member
        for_each_tet(run, [&](int64_t t) { number_[t] = least[number_[t]]; });
        least.assign(least.size(), std::numeric_limits<int32_t>::max());
        for_each_tet(run, [&](int64_t t) { lower_shared(least[number_[t]], static_cast<int32_t>(t)); });
        for_each_tet(run, [&](int64_t t) { number_[t] = least[number_[t]]; });
        return std::move(number_);
    }

private:
    // The number changes the time alone.
    static constexpr int64_t kTetsAtOnce = 1 << 14;

    template <class Body>
    void for_each_tet(const Run& run, const Body& body) const
    {
        parallel_for(run, mesh_.tets.count(), kTetsAtOnce, [&](int64_t begin, int64_t end) {
            for (int64_t t = begin; t < end; ++t)
                body(t);
        });
    }

    // A tetrahedron has the number of its first corner off the surface; if it has none, one of its own, after all
    // points. Returns how many numbers there are.
    size_t count_members(const Run& run)
    {
        const Array<int32_t> alone =
            collect<int32_t>(run, mesh_.tets.count(), kTetsAtOnce, [&](int64_t begin, int64_t end, auto& list) {
                for (int64_t t = begin; t < end; ++t) {
                    const Tet& tet = mesh_.tets[t];
                    const auto inside = std::find_if(tet.begin(), tet.end(), [&](int32_t p) { return !surface_[p]; });
                    if (inside == tet.end())
                        list.push_back(static_cast<int32_t>(t));
                    else
                        number_[t] = *inside;
                }
            });
        const size_t members = mesh_.points.size() + alone.size();
        if (members > to_size(std::numeric_limits<int32_t>::max()))
            throw Error(CLEFT_ERROR_TOO_LARGE, "the mesh is too large for its parts to have 32-bit numbers");
        for (size_t i = 0; i < alone.size(); ++i)
            number_[alone[i]] = static_cast<int32_t>(mesh_.points.size() + i);
        return members;
    }

    const LabelledMesh& mesh_;
    const Array<uint8_t>& surface_;
    Array<int32_t> number_;
    DisjointSets sets_;
};

}  // namespace

Array<double> material_volumes(const Array<Vec3>& points, const Array<Tet>& tets, const Array<Material>& material,
                               Material material_count, const Run& run)
{
    CLEFT_ASSERT(material.size() == tets.size());
    constexpr int64_t kTetsHeld = 1 << 18, kTetsAtOnce = 1 << 13;  // these numbers change the time alone
    Array<double> volumes(material_count, 0.0);
    Array<double> of_tet(std::min(kTetsHeld, tets.count()));
    for (int64_t first = 0; first < tets.count(); first += kTetsHeld) {
        const int64_t held = std::min(kTetsHeld, tets.count() - first);
        parallel_for(run, held, kTetsAtOnce, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i)
                of_tet[i] = tets[first + i][0] >= 0 ? tet_volume(points, tets[first + i]) : 0;
        });
        // By one thread, in the order of the tetrahedra. Mostly one follows another of the same material.
        for (int64_t i = 0; i < held;) {
            const Material m = material[first + i];
            double sum = volumes[m];
            for (; i < held && material[first + i] == m; ++i)
                sum += of_tet[i];
            volumes[m] = sum;
        }
    }
    return volumes;
}

Array<double> material_volumes(const LabelledMesh& mesh, Material material_count, const Run& run)
{
    return material_volumes(mesh.points, mesh.tets, mesh.material, material_count, run);
}

MeshParts mesh_parts(const LabelledMesh& mesh, const Run& run)
{
    const auto material = [&](int32_t t) { return mesh.material[t]; };
    const auto point_count = mesh.points.count();
    Steps steps(run, {{nullptr, 1}, {nullptr, 1}});
    const Run of_points = steps.next();
    const Array<uint8_t> surface = surface_points(mesh, of_points);
    PartSets sets(mesh, surface, of_points);
    const Run of_faces = steps.next();
    const FaceBuckets buckets(mesh.tets, point_count, of_faces, &surface);
    const auto look_at_faces = [&](int64_t begin, int64_t end, Array<Border>& found) {
        Borders borders;
        buckets.for_each_face(begin, end, [&](const HalfFace* face, size_t count) {
            // A face of more than two tetrahedra is no error here; validate() finds such faces.
            for (size_t k = 1; k < count; ++k) {
                const Material here = material(face[k].tet()), before = material(face[k - 1].tet());
                if (here == before)
                    sets.join(face[k].tet(), face[k - 1].tet());
                else
                    borders.add(here, before);
            }
        });
        found = borders.ascending();
    };
    Borders borders;
    for (const Border& b : collect<Border>(of_faces, point_count, FaceBuckets::kPointsAtOnce, look_at_faces))
        borders.add(b.first, b.second, b.triangles);
    return {sets.take(of_faces), borders.ascending()};
}

}  // namespace cleft
