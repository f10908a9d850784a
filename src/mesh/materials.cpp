// What is in a mesh by material, and taking materials out of it.
#include "base/disjoint_sets.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/finish.hpp"
#include "mesh/quality.hpp"

#include <functional>

namespace cleft
{

namespace
{

double tet_volume(const LabelledMesh& mesh, size_t t)
{
    const auto corner = [&](size_t i) { return mesh.points[static_cast<size_t>(mesh.tets[t][i])]; };
    return orient(corner(0), corner(1), corner(2), corner(3)) / 6;
}

}  // namespace

std::vector<double> material_volumes(const LabelledMesh& mesh, Material material_count)
{
    std::vector<double> volumes(static_cast<size_t>(material_count), 0.0);
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        volumes[static_cast<size_t>(mesh.material[t])] += tet_volume(mesh, t);
    return volumes;
}

std::vector<int32_t> part_of_tets(const LabelledMesh& mesh, const Run& run)
{
    constexpr int64_t kPointsAReport = 100000;
    const auto material = [&](int32_t t) { return mesh.material[static_cast<size_t>(t)]; };
    const auto point_count = static_cast<int64_t>(mesh.points.size());
    run.report(0, "finding parts");
    const FaceBuckets buckets(mesh.tets, point_count, run);
    DisjointSets sets(mesh.tets.size());
    for (int64_t begin = 0; begin < point_count; begin += kPointsAReport) {
        run.report(0.3 + 0.6 * static_cast<double>(begin) / static_cast<double>(point_count), "finding parts");
        const int64_t end = std::min(point_count, begin + kPointsAReport);
        buckets.for_each_face(begin, end, [&](const HalfFace* face, size_t count) {
            for (size_t k = 1; k < count; ++k)
                if (material(face[k].tet()) == material(face[k - 1].tet()))
                    sets.join(face[k].tet(), face[k - 1].tet());
        });
    }
    return sets.take();
}

std::vector<std::vector<double>> material_parts(const LabelledMesh& mesh, Material material_count, const Run& run)
{
    const std::vector<int32_t> part = part_of_tets(mesh, run);
    // A part is met first at its least tetrahedron, which opens it.
    std::vector<std::vector<double>> parts(static_cast<size_t>(material_count));
    std::vector<size_t> number(mesh.tets.size());
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        std::vector<double>& volumes = parts[static_cast<size_t>(mesh.material[t])];
        const auto least = static_cast<size_t>(part[t]);
        if (least == t) {
            number[t] = volumes.size();
            volumes.push_back(0);
        }
        volumes[number[least]] += tet_volume(mesh, t);
    }
    for (std::vector<double>& volumes : parts)
        std::sort(volumes.begin(), volumes.end(), std::greater<>());
    return parts;
}

void strip_materials(LabelledMesh& mesh, const std::vector<char>& keep)
{
    size_t kept = 0;
    std::vector<int32_t> new_number(mesh.points.size(), -1);
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        if (!keep[static_cast<size_t>(mesh.material[t])])
            continue;
        for (const int32_t p : mesh.tets[t])
            new_number[static_cast<size_t>(p)] = 0;
        mesh.tets[kept] = mesh.tets[t];
        mesh.material[kept] = mesh.material[t];
        ++kept;
    }
    mesh.tets.resize(kept);
    mesh.material.resize(kept);

    size_t points = 0;
    for (size_t p = 0; p < mesh.points.size(); ++p)
        if (new_number[p] == 0) {
            new_number[p] = static_cast<int32_t>(points);
            mesh.points[points++] = mesh.points[p];
        }
    mesh.points.resize(points);
    for (Tet& tet : mesh.tets)
        for (int32_t& p : tet)
            p = new_number[static_cast<size_t>(p)];
}

}  // namespace cleft
