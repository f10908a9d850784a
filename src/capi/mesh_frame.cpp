// Takes results of the stages to the world of the caller, and meshes of callers to the frame of the stages. Affine and
// labels are applied here and nowhere else (decision 1).
#include "capi/mesh_frame.hpp"

#include "base/collect.hpp"
#include "base/error.hpp"
#include "base/stage_timer.hpp"
#include "checking/quick_check.hpp"

#include <algorithm>
#include <string>

namespace cleft::capi
{

namespace
{

// Points or tetrahedra that a thread takes. The number changes the time alone.
constexpr int64_t kAtOnce = 1 << 14;

// A mesh that is sound in its own frame was spoilt by the rounding of world coordinates.
[[noreturn]] void refuse_result(Array<Tet> tets, const Array<Vec3>& local, const Frame& frame, const std::string& fault,
                                const Run& run)
{
    if (frame.flips())
        turn_round(tets, run);
    // Whose fault it is decides the status: the caller can move the origin, but can do nothing about a defect of a
    // stage.
    if (quick_fault(local, tets, run).empty())
        refuse_coarse_world(fault);
    throw Error(CLEFT_ERROR_INTERNAL, "the finished mesh has a fault, so it is not returned: " + fault);
}

Array<Vec3> local_points(const cleft_mesh& mesh, const Frame& frame, const Run& run)
{
    Array<Vec3> points = large_array<Vec3>(run, mesh.mesh.points.size(), Vec3::Zero());
    parallel_for(run, points.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            points[i] = frame.to_local(mesh.mesh.points[i]);
    });
    return points;
}

// Turned back, since what is positive in a mirrored world is negative in the frame.
Array<Tet> local_tets(const cleft_mesh& mesh, const Frame& frame, const Run& run)
{
    Array<Tet> tets = large_copy(run, mesh.mesh.tets);
    if (frame.flips())
        turn_round(tets, run);
    return tets;
}

Material material_of_label(const Volume& volume, int32_t label)
{
    const auto found = std::find(volume.labels().begin(), volume.labels().end(), UserLabel{label});
    // Stages work by the functions of the volume, which has none for such a label.
    if (found == volume.labels().end())
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "the mesh has label " + std::to_string(label) + ", which the volume does not have");
    return static_cast<Material>(found - volume.labels().begin());
}

// Compared bit by bit: a difference in the last digit could change a decision of the next stage, and so its bytes.
bool come_back(const Array<Vec3>& local, const Array<Vec3>& world, const Frame& frame)
{
    for (size_t i = 0; i < local.size(); ++i)
        if (frame.to_local(world[i]) != local[i])
            return false;
    return true;
}

}  // namespace

void refuse_coarse_world(const std::string& fault)
{
    throw Error(CLEFT_ERROR_ARGUMENT,
                "world coordinates are too coarse for tetrahedra of these sizes so far from the origin: " + fault +
                    "; move the origin nearer or set a greater size");
}

Array<Vec3> to_world(const Array<Vec3>& local, Array<Tet>& tets, const Frame& frame, const Run& run)
{
    Array<Vec3> world = large_array<Vec3>(run, local.size(), Vec3::Zero());
    parallel_for(run, local.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            world[i] = frame.to_world(local[i]);
    });
    if (frame.flips())
        turn_round(tets, run);
    // The last look at what a caller gets: rounding far from the origin can merge points that were apart.
    const std::string fault = quick_fault(world, tets, run);
    if (!fault.empty())
        refuse_result(std::move(tets), local, frame, fault, run);
    return world;
}

void turn_round(Array<Tet>& tets, const Run& run)
{
    parallel_for(run, tets.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            std::swap(tets[t][2], tets[t][3]);
    });
}

// A sorted list: meshes have few labels, and callers get them ascending.
Array<int32_t> distinct_labels(const Array<int32_t>& tet_labels, const Run& run)
{
    const auto sort_once = [](Array<int32_t>& labels) {
        std::sort(labels.begin(), labels.end());
        labels.erase(std::unique(labels.begin(), labels.end()), labels.end());
    };
    auto labels =
        collect<int32_t>(run, tet_labels.count(), kAtOnce, [&](int64_t begin, int64_t end, Array<int32_t>& list) {
            for (int64_t t = begin; t < end; ++t)
                // Tetrahedra of a label follow each other mostly, so few are left to sort.
                if (list.empty() || list.back() != tet_labels[t])
                    list.push_back(tet_labels[t]);
            sort_once(list);
        });
    sort_once(labels);
    return labels;
}

cleft_mesh to_user(LabelledMesh&& mesh, const Frame& frame, const Array<UserLabel>& labels, const Run& run)
{
    const StageTimer timer(run, "result_check");
    cleft_mesh out;
    out.frame = frame;
    out.mesh.tets = std::move(mesh.tets);
    out.mesh.labels = std::move(mesh.material);
    out.mesh.points = to_world(mesh.points, out.mesh.tets, frame, run);
    // In place: the array of materials becomes that of labels, and a mesh needs no second one.
    parallel_for(run, out.mesh.labels.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            out.mesh.labels[t] = number_of(labels[out.mesh.labels[t]]);  // a material until here
    });
    out.labels = distinct_labels(out.mesh.labels, run);
    return out;
}

cleft_mesh to_next_stage(LabelledMesh&& mesh, MadeBy stage, const Frame& frame, const Array<UserLabel>& labels,
                         const Run& run)
{
    Array<Vec3> local = mesh.points;
    cleft_mesh out = to_user(std::move(mesh), frame, labels, run);
    out.made_by = stage;
    // Mostly the way back is exact, and the second copy of all points is saved.
    if (!come_back(local, out.mesh.points, frame))
        out.local = std::move(local);
    return out;
}

bool is_as_left(const cleft_mesh& mesh, MadeBy stage, const Frame& frame)
{
    // Another volume, or the same voxels with another affine, has other local points.
    return mesh.made_by == stage && mesh.frame && mesh.frame->is_that_of(frame);
}

TetMesh as_left(const cleft_mesh& mesh, const Run& run)
{
    const Array<Vec3>& kept = mesh.local;
    return {kept.empty() ? local_points(mesh, *mesh.frame, run) : kept, local_tets(mesh, *mesh.frame, run)};
}

void to_local(const cleft_mesh& mesh, const Frame& frame, Array<Vec3>& points, Array<Tet>& tets, const Run& run)
{
    points = local_points(mesh, frame, run);
    tets = local_tets(mesh, frame, run);
}

LabelledMesh to_stage(const cleft_mesh& mesh, const cleft_volume& volume, const Run& run)
{
    LabelledMesh out;
    if (is_as_left(mesh, MadeBy::cleaving, volume.frame)) {
        TetMesh left = as_left(mesh, run);
        out.points = std::move(left.points);
        out.tets = std::move(left.tets);
    } else {
        to_local(mesh, volume.frame, out.points, out.tets, run);
    }
    // By place among the labels of the mesh, which are few.
    Array<Material> material_of;
    for (const int32_t label : mesh.labels)
        material_of.push_back(material_of_label(volume.volume, label));
    out.material = large_array<Material>(run, mesh.mesh.labels.size());
    parallel_for(run, out.material.count(), kAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t) {
            const int32_t label = mesh.mesh.labels[t];
            // Tetrahedra of a label follow each other mostly.
            out.material[t] = t > begin && label == mesh.mesh.labels[t - 1]
                                  ? out.material[t - 1]
                                  : material_of[std::lower_bound(mesh.labels.begin(), mesh.labels.end(), label) -
                                                mesh.labels.begin()];
        }
    });
    return out;
}

}  // namespace cleft::capi
