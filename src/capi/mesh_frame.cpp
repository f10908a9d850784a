#include "capi/mesh_frame.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <string>
#include <unordered_map>

namespace cleft::capi
{

std::vector<int32_t> distinct_labels(const std::vector<int32_t>& tet_labels)
{
    std::vector<int32_t> labels;
    for (size_t t = 0; t < tet_labels.size(); ++t) {
        if (t > 0 && tet_labels[t] == tet_labels[t - 1])
            continue;
        const auto at = std::lower_bound(labels.begin(), labels.end(), tet_labels[t]);
        if (at == labels.end() || *at != tet_labels[t])
            labels.insert(at, tet_labels[t]);
    }
    return labels;
}

cleft_mesh to_user(LabelledMesh&& mesh, const Frame& frame, const std::vector<int32_t>& labels)
{
    cleft_mesh out;
    out.frame = frame;
    out.mesh = std::move(mesh);
    for (Vec3& point : out.mesh.points)
        point = frame.to_world(point);
    if (frame.flips())
        for (Tet& tet : out.mesh.tets)
            std::swap(tet[2], tet[3]);
    for (Material& m : out.mesh.material)
        m = labels[static_cast<size_t>(m)];
    out.labels = distinct_labels(out.mesh.material);
    return out;
}

void to_local(const cleft_mesh& mesh, const Frame& frame, std::vector<Vec3>& points, std::vector<Tet>& tets)
{
    points.resize(mesh.mesh.points.size());
    for (size_t i = 0; i < points.size(); ++i)
        points[i] = frame.to_local(mesh.mesh.points[i]);
    tets = mesh.mesh.tets;
    if (frame.flips())
        for (Tet& tet : tets)
            std::swap(tet[2], tet[3]);
}

LabelledMesh to_stage(const cleft_mesh& mesh, const cleft_volume& volume)
{
    LabelledMesh out;
    to_local(mesh, volume.frame, out.points, out.tets);
    std::unordered_map<int32_t, Material> material_of;  // looked up only, never walked
    for (Material m = 0; m < volume.volume.material_count(); ++m)
        material_of[volume.volume.labels()[static_cast<size_t>(m)]] = m;
    out.material.reserve(mesh.mesh.material.size());
    for (const int32_t label : mesh.mesh.material) {
        const auto found = material_of.find(label);
        if (found == material_of.end())
            throw Error(CLEFT_ERROR_ARGUMENT,
                        "the mesh has label " + std::to_string(label) + ", which the volume has not");
        out.material.push_back(found->second);
    }
    return out;
}

}  // namespace cleft::capi
