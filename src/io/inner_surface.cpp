// Gathers the triangles that lie inside the box, and renumbers their points. VTP, STL and PLY hold
// such a surface and nothing else.
#include "io/inner_surface.hpp"

namespace cleft::io
{

InnerSurface inner_surface(const MeshView& mesh)
{
    InnerSurface surface;
    for (const SurfaceGroup& group : mesh.groups) {
        if (!group.is_inner())
            continue;
        surface.triangles.insert(surface.triangles.end(), group.triangles, group.triangles + 3 * group.count);
        for (int64_t t = 0; t < group.count; ++t) {
            surface.labels.push_back(group.first);
            surface.labels.push_back(group.second);
        }
    }
    // -1: not used, 0: used, then the number in the surface. The order of the mesh is kept, so that
    // the file does not depend on the order of triangles.
    std::vector<int32_t> number(static_cast<size_t>(mesh.point_count), -1);
    for (const int32_t p : surface.triangles)
        number[static_cast<size_t>(p)] = 0;
    for (int32_t p = 0; p < mesh.point_count; ++p)
        if (number[static_cast<size_t>(p)] == 0) {
            number[static_cast<size_t>(p)] = static_cast<int32_t>(surface.points.size());
            surface.points.push_back(p);
        }
    surface.corners.reserve(surface.triangles.size());
    for (const int32_t p : surface.triangles)
        surface.corners.push_back(number[static_cast<size_t>(p)]);
    return surface;
}

}  // namespace cleft::io
