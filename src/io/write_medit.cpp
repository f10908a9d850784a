// MEDIT .mesh, text. The reference of a tetrahedron is its label, that of a triangle the number of its group; the names
// of the groups are in comments at the top.
#include "io/atomic_file.hpp"
#include "io/writers.hpp"

namespace cleft::io
{

namespace
{

void write_triangles(const MeshView& mesh, AtomicFile& file)
{
    file.print("\nTriangles\n", mesh.triangle_count(), '\n');
    for (const SurfaceGroup& group : mesh.groups)
        for (int64_t t = 0; t < group.count; ++t) {
            const int32_t* c = group.triangles + 3 * t;
            file.print(c[0] + int64_t{1}, ' ', c[1] + int64_t{1}, ' ', c[2] + int64_t{1}, ' ', group.number, '\n');
        }
}

}  // namespace

void write_medit(const MeshView& mesh, const std::string& path)
{
    AtomicFile file(path);
    // 2: double precision.
    file.print("MeshVersionFormatted 2\n# tetrahedra: the reference is the material; triangles:\n");
    for (const SurfaceGroup& group : mesh.groups)
        file.print("# ", group.number, " = ", group.name, '\n');
    for (size_t l = 0; l < mesh.labels.size(); ++l)
        if (!mesh.names[l].empty())
            file.print("# material ", mesh.labels[l], " = ", mesh.names[l], '\n');
    file.print("Dimension 3\n\nVertices\n", mesh.point_count, '\n');
    for (int64_t i = 0; i < mesh.point_count; ++i) {
        const double* p = mesh.points + 3 * i;
        // Points have no reference of their own: one may touch several materials.
        file.print(p[0], ' ', p[1], ' ', p[2], " 0\n");
    }
    file.print("\nTetrahedra\n", mesh.tet_count, '\n');
    for (int64_t t = 0; t < mesh.tet_count; ++t) {
        const int32_t* c = mesh.tets + 4 * t;
        file.print(c[0] + int64_t{1}, ' ', c[1] + int64_t{1}, ' ', c[2] + int64_t{1}, ' ', c[3] + int64_t{1}, ' ',
                   mesh.tet_labels[t], '\n');
    }
    write_triangles(mesh, file);
    // The keyword that ends a file in MEDIT's format.
    file.print("\nEnd\n");
    file.commit();
}

}  // namespace cleft::io
