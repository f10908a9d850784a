// Gathers facts about volumes and meshes through the public C interface. The summary and the JSON
// report are made of the same facts.
#include "findings.hpp"

#include "text.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace cleft_cli
{
namespace
{

using Point = std::array<double, 3>;

Point point_at(const double* points, int32_t number)
{
    const double* p = points + 3 * static_cast<int64_t>(number);
    return {p[0], p[1], p[2]};
}

// Positive for the orientation that the tetrahedra of a valid mesh have.
double tet_volume(const double* points, const int32_t* tet)
{
    const Point a = point_at(points, tet[0]);
    double edges[3][3];
    for (std::size_t corner = 0; corner < 3; ++corner) {
        const Point p = point_at(points, tet[corner + 1]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            edges[corner][axis] = p[axis] - a[axis];
    }
    const auto& [u, v, w] = edges;
    return (u[0] * (v[1] * w[2] - v[2] * w[1]) - u[1] * (v[0] * w[2] - v[2] * w[0]) +
            u[2] * (v[0] * w[1] - v[1] * w[0])) /
           6;
}

void note_surface(const Session& session, const cleft_mesh* mesh, MeshFindings& found)
{
    cleft_surface* surface = nullptr;
    const cleft_status status = cleft_surface_create(session.context(), mesh, &surface);
    const Surface owner(surface);
    // `cleft check` must report on broken meshes, too. Their numbers of triangles are then absent.
    if (status == CLEFT_ERROR_INVALID_MESH)
        return;
    session.check(status, EXIT_MESHING_FAILED);
    found.interface_triangles = cleft_surface_interface_count(surface);
    found.hull_triangles = cleft_surface_hull_count(surface);
}

}  // namespace

void MeshFindings::take_points(const double* coordinates, int64_t count)
{
    points = count;
    // An empty mesh keeps the box of zeros.
    if (count == 0)
        return;
    low = high = point_at(coordinates, 0);
    for (int64_t i = 0; i < 3 * count; ++i) {
        const auto axis = static_cast<std::size_t>(i % 3);
        low[axis] = std::min(low[axis], coordinates[i]);
        high[axis] = std::max(high[axis], coordinates[i]);
    }
}

void MeshFindings::take_tets(const double* coordinates, const int32_t* corners, const int32_t* tet_labels,
                             int64_t count)
{
    tets = count;
    LabelTotals* sum = nullptr;
    for (int64_t t = 0; t < count; ++t) {
        // Neighbours mostly have one label.
        if (!sum || tet_labels[t] != tet_labels[t - 1])
            sum = &labels[tet_labels[t]];
        ++sum->tets;
        sum->volume += tet_volume(coordinates, corners + 4 * t);
    }
}

MeshFindings look_at_mesh(const Session& session, const cleft_mesh* mesh)
{
    MeshFindings found;
    found.take_points(cleft_mesh_points(mesh), cleft_mesh_point_count(mesh));
    found.take_tets(cleft_mesh_points(mesh), cleft_mesh_tets(mesh), cleft_mesh_tet_labels(mesh),
                    cleft_mesh_tet_count(mesh));
    for (const auto& [label, totals] : found.labels)
        found.names[label] = cleft_mesh_label_name(mesh, label);
    note_surface(session, mesh, found);
    found.quality.struct_size = sizeof found.quality;
    session.check(cleft_mesh_quality(session.context(), mesh, &found.quality), EXIT_MESHING_FAILED);
    return found;
}

double VolumeFindings::voxel_volume() const
{
    const auto& a = affine;
    return std::fabs(a[0] * (a[5] * a[10] - a[6] * a[9]) - a[1] * (a[4] * a[10] - a[6] * a[8]) +
                     a[2] * (a[4] * a[9] - a[5] * a[8]));
}

void VolumeFindings::bounds(Point& low, Point& high) const
{
    low.fill(std::numeric_limits<double>::infinity());
    high.fill(-std::numeric_limits<double>::infinity());
    for (unsigned corner = 0; corner < 8; ++corner) {
        for (std::size_t row = 0; row < 3; ++row) {
            double value = affine[4 * row + 3];
            for (std::size_t axis = 0; axis < 3; ++axis) {
                // The box reaches half a voxel beyond the centres of its outer voxels.
                const double index = (corner >> axis & 1U) != 0 ? static_cast<double>(dims[axis]) - 0.5 : -0.5;
                value += affine[4 * row + axis] * index;
            }
            low[row] = std::min(low[row], value);
            high[row] = std::max(high[row], value);
        }
    }
}

void VolumeFindings::take_spacing()
{
    for (std::size_t axis = 0; axis < 3; ++axis)
        // The length of a column of the affine map: the step along that axis.
        spacing[axis] = std::hypot(affine[axis], affine[4 + axis], affine[8 + axis]);
}

VolumeFindings look_at_volume(const Session& session, const cleft_volume* volume)
{
    VolumeFindings found;
    session.check(cleft_volume_dims(volume, found.dims.data()), EXIT_MESHING_FAILED);
    session.check(cleft_volume_affine(volume, found.affine.data()), EXIT_MESHING_FAILED);
    found.take_spacing();
    const int64_t count = cleft_volume_label_count(volume);
    std::vector<int64_t> voxels(static_cast<std::size_t>(count));
    session.check(cleft_volume_copy_voxel_counts(volume, voxels.data(), count), EXIT_MESHING_FAILED);
    for (std::size_t i = 0; i < voxels.size(); ++i)
        found.voxels[cleft_volume_labels(volume)[i]] += voxels[i];
    for (const auto& [label, number] : found.voxels)
        found.names[label] = cleft_volume_label_name(volume, label);
    return found;
}

namespace
{

std::vector<cleft_distance> distances_of(const Session& session, const cleft_report* report)
{
    std::vector<cleft_distance> distances(static_cast<std::size_t>(cleft_report_distance_count(report)));
    for (std::size_t i = 0; i < distances.size(); ++i) {
        distances[i].struct_size = sizeof(cleft_distance);
        session.check(cleft_report_distance(report, static_cast<int64_t>(i), &distances[i]), EXIT_MESHING_FAILED);
    }
    return distances;
}

}  // namespace

ReportFindings look_at_labels(const Session& session, const cleft_volume* volume, const cleft_mesh* mesh,
                              bool with_distances)
{
    const auto create = with_distances ? cleft_report_create_with_distances : cleft_report_create;
    const auto report = session.make<Report>(
        EXIT_MESHING_FAILED, [&](cleft_report** out) { return create(session.context(), volume, mesh, out); });
    ReportFindings found;
    found.labels.resize(static_cast<std::size_t>(cleft_report_count(report.get())));
    for (std::size_t i = 0; i < found.labels.size(); ++i) {
        LabelFindings& row = found.labels[i];
        // Not sizeof row: LabelFindings adds a name behind the library's struct.
        row.struct_size = sizeof(cleft_label_report);
        session.check(cleft_report_label(report.get(), static_cast<int64_t>(i), &row), EXIT_MESHING_FAILED);
        row.name = cleft_volume_label_name(volume, row.label);
    }
    found.contacts.resize(static_cast<std::size_t>(cleft_report_contact_count(report.get())));
    for (std::size_t i = 0; i < found.contacts.size(); ++i) {
        found.contacts[i].struct_size = sizeof(cleft_contact);
        session.check(cleft_report_contact(report.get(), static_cast<int64_t>(i), &found.contacts[i]),
                      EXIT_MESHING_FAILED);
    }
    found.distances = distances_of(session, report.get());
    return found;
}

double difference_percent(const cleft_label_report& row)
{
    // 0 for a label without voxels: there is nothing to compare.
    return row.voxel_volume > 0 ? 100 * (row.mesh_volume / row.voxel_volume - 1) : 0;
}

}  // namespace cleft_cli
