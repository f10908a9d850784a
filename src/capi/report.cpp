// The report on a mesh: what became of each label, contacts, and distances of interfaces.
#include "base/stage.hpp"
#include "capi/firewall.hpp"
#include "capi/mesh_frame.hpp"
#include "capi/report_rows.hpp"
#include "checking/surface_distances.hpp"

#include <algorithm>
#include <cstdint>

using namespace cleft::capi;
using cleft::Error;
using cleft::LabelledMesh;
using cleft::Run;

template <>
inline constexpr size_t cleft::kFirstSize<cleft_contact> = CLEFT_END_OF(cleft_contact, triangles);
template <>
inline constexpr size_t cleft::kFirstSize<cleft_distance> = CLEFT_END_OF(cleft_distance, volume_greatest);

namespace
{

// A report whose volumes are those of the voxel frame, in the world.
// Callers compare them with volumes of their own, which are in the units of the affine.
cleft::LabelReport in_world(cleft::LabelReport report, const cleft::Placement& world)
{
    for (cleft::LabelRow& row : report.rows) {
        row.voxel_volume = world.volume(row.voxel_volume);
        row.mesh_volume = world.volume(row.mesh_volume);
    }
    return report;
}

// Rows are kept by material. Callers see them in the order of cleft_volume_labels().
const cleft::LabelRow& row_at(const cleft_report& report, int64_t index)
{
    return report.report.rows[report.listed[index]];
}

// The labels of an interface or line, ascending; a third that is not there is the greatest number.
cleft::Array<int64_t> labels_of(const cleft::TieMaterials& of, const cleft::LabelReport& report)
{
    cleft::Array<int64_t> labels;
    for (const cleft::Material m : of.material)
        labels.push_back(m == cleft::kNoThird ? INT64_MAX : number_of(report.rows[m].label));
    std::sort(labels.begin(), labels.end());
    return labels;
}

void sort_by_label(cleft::Array<cleft::SurfaceDistances>& distances, const cleft::LabelReport& report)
{
    std::sort(distances.begin(), distances.end(), [&](const auto& a, const auto& b) {
        return a.of.is_line() != b.of.is_line() ? b.of.is_line() : labels_of(a.of, report) < labels_of(b.of, report);
    });
}

}  // namespace

cleft_status cleft_report_create(cleft_context* context, const cleft_volume* volume, const cleft_mesh* mesh,
                                 cleft_report** out) noexcept
{
    return guarded_create(context, out, "report", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const LabelledMesh m = to_stage(*held(mesh, "mesh"), *v, run);
        return cleft_report{{}, in_world(cleft::label_report(v->volume, m, run), v->frame), {}, v->listed};
    });
}

cleft_status cleft_report_create_with_distances(cleft_context* context, const cleft_volume* volume,
                                                const cleft_mesh* mesh, cleft_report** out) noexcept
{
    return guarded_create(context, out, "report", [&](const Run& run) {
        const auto v = held(volume, "volume");
        const LabelledMesh m = to_stage(*held(mesh, "mesh"), *v, run);
        cleft::Steps steps(run, {{nullptr, 1}, {nullptr, 6}});
        cleft::LabelReport rows = in_world(cleft::label_report(v->volume, m, steps.next()), v->frame);
        auto distances = cleft::surface_distances(v->volume, m, v->frame, steps.next());
        sort_by_label(distances, rows);
        return cleft_report{{}, std::move(rows), std::move(distances), v->listed};
    });
}

void cleft_report_destroy(cleft_report* report) noexcept { destroy(report); }

int64_t cleft_report_count(const cleft_report* report) noexcept
{
    return is_sound(report) ? static_cast<int64_t>(report->report.rows.size()) : 0;
}

cleft_status cleft_report_label(const cleft_report* report, int64_t index, cleft_label_report* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_label_report");
        if (index < 0 || index >= static_cast<int64_t>(checked(report, "report").report.rows.size()))
            throw Error(CLEFT_ERROR_ARGUMENT, "there is no such row");
        cleft::copy_out(row_of(row_at(*report, index)), *out);
    });
}

int64_t cleft_report_contact_count(const cleft_report* report) noexcept
{
    return is_sound(report) ? static_cast<int64_t>(report->report.contacts.size()) : 0;
}

cleft_status cleft_report_contact(const cleft_report* report, int64_t index, cleft_contact* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_contact");
        checked(report, "report");
        if (index < 0 || index >= cleft_report_contact_count(report))
            throw Error(CLEFT_ERROR_ARGUMENT, "there is no such contact");
        const cleft::LabelContact& from = report->report.contacts[index];
        const auto label = [&](cleft::Material m) { return number_of(report->report.rows[m].label); };
        cleft_contact contact{};
        contact.first = label(from.first);
        contact.second = label(from.second);
        contact.triangles = from.triangles;
        cleft::copy_out(contact, *out);
    });
}

int64_t cleft_report_distance_count(const cleft_report* report) noexcept
{
    return is_sound(report) ? report->distances.count() : 0;
}

cleft_status cleft_report_distance(const cleft_report* report, int64_t index, cleft_distance* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_distance");
        checked(report, "report");
        if (index < 0 || index >= cleft_report_distance_count(report))
            throw Error(CLEFT_ERROR_ARGUMENT, "there is no such interface or line");
        const cleft::SurfaceDistances& from = report->distances[index];
        const auto labels = labels_of(from.of, report->report);
        cleft_distance row{};
        row.first = static_cast<int32_t>(labels[0]);
        row.second = static_cast<int32_t>(labels[1]);
        row.is_line = from.of.is_line();
        row.third = static_cast<int32_t>(labels[from.of.is_line() ? 2 : 1]);
        row.elements = from.elements;
        row.points = from.points;
        row.mesh_mean = from.mesh.mean;
        row.mesh_99 = from.mesh.most;
        row.mesh_greatest = from.mesh.greatest;
        row.volume_mean = from.volume.mean;
        row.volume_99 = from.volume.most;
        row.volume_greatest = from.volume.greatest;
        cleft::copy_out(row, *out);
    });
}
