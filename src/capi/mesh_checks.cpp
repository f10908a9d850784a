// Quality, validation and surfaces of a mesh.
#include "base/touched_array.hpp"
#include "capi/firewall.hpp"
#include "capi/mesh_frame.hpp"
#include "capi/report_rows.hpp"
#include "checking/metric_quality.hpp"
#include "checking/validate.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/quality.hpp"

#include <algorithm>

using namespace cleft::capi;
using cleft::Error;
using cleft::Run;

template <>
inline constexpr size_t cleft::kFirstSize<cleft_metric_quality> = CLEFT_END_OF(cleft_metric_quality,
                                                                               dihedral_histogram);
template <>
inline constexpr size_t cleft::kFirstSize<cleft_validation> = CLEFT_END_OF(cleft_validation, box_area);

namespace
{

// The array of sides is lent as it is, so both enumerations must have the same numbers and the same size.
template <class Number>
constexpr bool is(cleft::Side side, Number number)
{
    return static_cast<int32_t>(side) == number;
}
static_assert(sizeof(cleft::Side) == sizeof(int32_t));
static_assert(is(cleft::Side::x_min, CLEFT_SIDE_X_MIN) && is(cleft::Side::x_max, CLEFT_SIDE_X_MAX) &&
              is(cleft::Side::y_min, CLEFT_SIDE_Y_MIN) && is(cleft::Side::y_max, CLEFT_SIDE_Y_MAX) &&
              is(cleft::Side::z_min, CLEFT_SIDE_Z_MIN) && is(cleft::Side::z_max, CLEFT_SIDE_Z_MAX) &&
              is(cleft::Side::other, CLEFT_SIDE_OTHER));

// The mesh in the frame in which the sides of its box lie across the axes.
// Sides are found by comparing coordinates, which works only where the box stands upright.
cleft::UserMesh upright(const cleft_mesh& mesh, const Run& run)
{
    if (!mesh.frame)
        return mesh.mesh;
    cleft::UserMesh local;
    to_local(mesh, *mesh.frame, local.points, local.tets, run);
    local.labels = cleft::large_copy(run, mesh.mesh.labels);
    return local;
}

// Without a frame the world is the frame: a mesh of arrays has no other.
cleft::Placement placement_of(const cleft_mesh& mesh)
{
    return mesh.frame ? cleft::Placement(*mesh.frame) : cleft::Placement();
}

// The box that the mesh was made for; of a mesh without a volume that of its points.
cleft::BoundingBox box_of(const cleft_mesh& mesh, const cleft::UserMesh& local)
{
    cleft::BoundingBox box;
    // A mesh with labels left out need not reach its walls, but triangles that lie in one are still of that side.
    if (mesh.frame) {
        box.add(cleft::Vec3(0, 0, 0));
        box.add(mesh.frame->grid.extent());
        return box;
    }
    box.add(local.points);
    return box;
}

}  // namespace

cleft_status cleft_mesh_quality(cleft_context* context, const cleft_mesh* mesh, cleft_quality* out) noexcept
{
    return guarded_run(context, "quality", [&](const Run& run) {
        const auto from = held(mesh, "mesh");
        const cleft::UserMesh& m = from->mesh;
        // Before the work: a struct whose size was not set should not cost a pass over the mesh first.
        cleft::check_struct_size(*required(out, "out"), "cleft_quality");
        const cleft::Quality q = cleft::measure_quality(m.points, m.tets, run);
        run.report(1);
        cleft::copy_out(row_of(q), *out);
    });
}

cleft_status cleft_mesh_metric_quality(cleft_context* context, const cleft_mesh* mesh, const cleft_sizing* sizing,
                                       cleft_metric_quality* out) noexcept
{
    return guarded_run(context, "metric quality", [&](const Run& run) {
        const auto from = held(mesh, "mesh");
        const auto field = held(sizing, "sizing");
        cleft::check_struct_size(*required(out, "out"), "cleft_metric_quality");
        if (!field->sizing.field.metric)
            throw Error(CLEFT_ERROR_ARGUMENT, "the sizing field has no metric");
        cleft::TetMesh local;
        to_local(*from, field->frame, local.points, local.tets, run);
        const cleft::MetricQuality q = cleft::measure_by_metric(local, *field->sizing.field.metric, run);
        run.report(1);
        cleft_metric_quality row{};
        row.tet_count = local.tets.count();
        row.edge_count = q.edges;
        row.edges_in_range = q.edges_in_range;
        row.edge_least = q.edge_least;
        row.edge_01 = q.edge_01;
        row.edge_median = q.edge_median;
        row.edge_99 = q.edge_99;
        row.edge_greatest = q.edge_greatest;
        row.mean_ratio_least = q.mean_ratio_least;
        row.mean_ratio_01 = q.mean_ratio_01;
        row.mean_ratio_median = q.mean_ratio_median;
        row.min_dihedral = q.min_dihedral;
        row.max_dihedral = q.max_dihedral;
        std::copy(q.dihedral_histogram.begin(), q.dihedral_histogram.end(), row.dihedral_histogram);
        cleft::copy_out(row, *out);
    });
}

cleft_status cleft_mesh_validate(cleft_context* context, const cleft_mesh* mesh, int32_t fills_box,
                                 cleft_validation* out) noexcept
{
    return guarded_run(context, "validation", [&](const Run& run) {
        const auto from = held(mesh, "mesh");
        const cleft_mesh& m = *from;
        cleft::check_struct_size(*required(out, "out"), "cleft_validation");
        const cleft::Validation v = cleft::validate(upright(m, run), fills_box != 0, run, placement_of(m));
        run.report(1);
        cleft_validation row{};
        row.valid = v.valid();
        row.negative_tets = v.negative;
        row.flat_tets = v.flat;
        row.repeated_corners = v.repeated_corner;
        row.crowded_faces = v.crowded_faces;
        row.folded_faces = v.folded_faces;
        row.hull_off_box = v.hull_off_box;
        row.open_interface_edges = v.open_interface_edges;
        row.unused_points = v.unused_points;
        row.repeated_points = v.repeated_points;
        row.volume = v.volume;
        row.box_volume = v.box_volume;
        row.hull_area = v.hull_area;
        row.box_area = v.box_area;
        row.interface_triangles = v.interface_faces;
        row.hull_triangles = v.hull_faces;
        cleft::copy_out(row, *out);
        // Not an error of the call, so its status is CLEFT_OK. The sentence is the quickest answer to "what is wrong
        // with it?".
        set_message(&context->message, v.first_fault.c_str());
    });
}

cleft_status cleft_surface_create(cleft_context* context, const cleft_mesh* mesh, cleft_surface** out) noexcept
{
    return guarded_create(context, out, "surface", [&](const Run& run) {
        const auto from = held(mesh, "mesh");
        const cleft_mesh& m = *from;
        const cleft::UserMesh local = upright(m, run);
        const cleft::BoundingBox box = box_of(m, local);
        cleft_surface surface{{}, cleft::extract_interfaces(local, box.lo, box.hi, run)};
        if (m.frame && m.frame->flips()) {
            // An affine that mirrors turned the tetrahedra round, and normals must still look from the first label to
            // the second.
            for (auto& triangle : surface.interfaces.triangles)
                std::swap(triangle[1], triangle[2]);
            for (auto& triangle : surface.interfaces.hull)
                std::swap(triangle[1], triangle[2]);
        }
        return surface;
    });
}

void cleft_surface_destroy(cleft_surface* surface) noexcept { destroy(surface); }

int64_t cleft_surface_interface_count(const cleft_surface* surface) noexcept
{
    return is_sound(surface) ? static_cast<int64_t>(surface->interfaces.triangles.size()) : 0;
}

const int32_t* cleft_surface_interface_triangles(const cleft_surface* surface) noexcept
{
    return cleft_surface_interface_count(surface) ? surface->interfaces.triangles.front().data() : nullptr;
}

const int32_t* cleft_surface_interface_labels(const cleft_surface* surface) noexcept
{
    return cleft_surface_interface_count(surface) ? surface->interfaces.pairs.front().data() : nullptr;
}

int64_t cleft_surface_hull_count(const cleft_surface* surface) noexcept
{
    return is_sound(surface) ? static_cast<int64_t>(surface->interfaces.hull.size()) : 0;
}

const int32_t* cleft_surface_hull_triangles(const cleft_surface* surface) noexcept
{
    return cleft_surface_hull_count(surface) ? surface->interfaces.hull.front().data() : nullptr;
}

const int32_t* cleft_surface_hull_labels(const cleft_surface* surface) noexcept
{
    return cleft_surface_hull_count(surface) ? surface->interfaces.hull_region.data() : nullptr;
}

const int32_t* cleft_surface_hull_sides(const cleft_surface* surface) noexcept
{
    return cleft_surface_hull_count(surface) ? reinterpret_cast<const int32_t*>(surface->interfaces.hull_side.data())
                                             : nullptr;
}
