// Gathers what writers need of a mesh: its arrays, and its surface as named and numbered groups.
#include "io/mesh_view.hpp"

#include "io/group_numbers.hpp"
#include "io/label_names.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

// Consecutive interface triangles of one pair are one group.
void add_interfaces(const cleft_surface* surface, std::vector<SurfaceGroup>& groups)
{
    const int64_t count = cleft_surface_interface_count(surface);
    const int32_t* triangles = cleft_surface_interface_triangles(surface);
    // The library gives interface triangles sorted by their pairs, so groups are found without
    // sorting.
    const int32_t* pairs = cleft_surface_interface_labels(surface);
    for (int64_t t = 0; t < count; ++t) {
        const int32_t a = pairs[2 * t];
        const int32_t b = pairs[2 * t + 1];
        if (t == 0 || groups.back().first != a || groups.back().second != b)
            groups.push_back(
                {surface_name(SurfaceGroup::kNoSide, a, b), SurfaceGroup::kNoSide, a, b, triangles + 3 * t, 0, 0});
        ++groups.back().count;
    }
}

void add_hull(const cleft_surface* surface, std::vector<SurfaceGroup>& groups)
{
    const int64_t count = cleft_surface_hull_count(surface);
    const int32_t* triangles = cleft_surface_hull_triangles(surface);
    const int32_t* labels = cleft_surface_hull_labels(surface);
    const int32_t* sides = cleft_surface_hull_sides(surface);
    for (int64_t t = 0; t < count; ++t) {
        if (t == 0 || groups.back().first != labels[t] || groups.back().side != sides[t])
            groups.push_back({surface_name(sides[t], labels[t], labels[t]), sides[t], labels[t], labels[t],
                              triangles + 3 * t, 0, 0});
        ++groups.back().count;
    }
}

}  // namespace

int64_t MeshView::triangle_count() const
{
    int64_t count = 0;
    for (const SurfaceGroup& group : groups)
        count += group.count;
    return count;
}

size_t MeshView::label_index(int32_t label) const
{
    return static_cast<size_t>(std::lower_bound(labels.begin(), labels.end(), label) - labels.begin());
}

std::string MeshView::material(size_t index) const { return material_name(labels[index], names[index]); }

MeshView view_of(const cleft_mesh* mesh, const cleft_surface* surface)
{
    MeshView view;
    view.point_count = cleft_mesh_point_count(mesh);
    view.points = cleft_mesh_points(mesh);
    view.tet_count = cleft_mesh_tet_count(mesh);
    view.tets = cleft_mesh_tets(mesh);
    view.tet_labels = cleft_mesh_tet_labels(mesh);
    const int32_t* labels = cleft_mesh_labels(mesh);
    // labels are ascending, which label_index() relies on.
    view.labels.assign(labels, labels + cleft_mesh_label_count(mesh));
    for (const int32_t label : view.labels)
        view.names.push_back(cleft_mesh_label_name(mesh, label));
    add_interfaces(surface, view.groups);
    add_hull(surface, view.groups);
    number_groups(view);
    return view;
}

}  // namespace cleft::io
