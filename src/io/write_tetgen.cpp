// TetGen .node, .ele and .face, text, numbered from 1. The attribute of a tetrahedron is its label, the marker of a
// face the number of its group, whose name is in a comment at the end of .face.
#include "io/atomic_file.hpp"
#include "io/file_name.hpp"
#include "io/writers.hpp"

namespace cleft::io
{

namespace
{

void write_nodes(const MeshView& mesh, AtomicFile& file)
{
    // Dimension 3, no attributes, no markers.
    file.print(mesh.point_count, " 3 0 0\n");
    for (int64_t i = 0; i < mesh.point_count; ++i) {
        const double* p = mesh.points + 3 * i;
        file.print(i + 1, ' ', p[0], ' ', p[1], ' ', p[2], '\n');
    }
}

void write_ele(const MeshView& mesh, AtomicFile& file)
{
    // Four corners, one attribute.
    file.print(mesh.tet_count, " 4 1\n");
    for (int64_t t = 0; t < mesh.tet_count; ++t) {
        const int32_t* c = mesh.tets + 4 * t;
        file.print(t + 1, ' ', c[0] + int64_t{1}, ' ', c[1] + int64_t{1}, ' ', c[2] + int64_t{1}, ' ',
                   c[3] + int64_t{1}, ' ', mesh.tet_labels[t], '\n');
    }
}

void write_faces(const MeshView& mesh, AtomicFile& file)
{
    file.print(mesh.triangle_count(), " 1\n");
    int64_t number = 0;
    for (const SurfaceGroup& group : mesh.groups)
        for (int64_t t = 0; t < group.count; ++t) {
            const int32_t* c = group.triangles + 3 * t;
            file.print(++number, ' ', c[0] + int64_t{1}, ' ', c[1] + int64_t{1}, ' ', c[2] + int64_t{1}, ' ',
                       group.number, '\n');
        }
    for (const SurfaceGroup& group : mesh.groups)
        file.print("# ", group.number, " = ", group.name, '\n');
    for (size_t l = 0; l < mesh.labels.size(); ++l)
        if (!mesh.names[l].empty())
            file.print("# material ", mesh.labels[l], " = ", mesh.names[l], '\n');
}

}  // namespace

void write_tetgen(const MeshView& mesh, const std::string& path)
{
    const std::string prefix = tetgen_prefix(path);
    // All three are written before any takes its name: a .ele file beside the .node file of another
    // mesh would be wrong without a sign.
    AtomicFile nodes(prefix + ".node");
    write_nodes(mesh, nodes);
    AtomicFile elements(prefix + ".ele");
    write_ele(mesh, elements);
    AtomicFile faces(prefix + ".face");
    write_faces(mesh, faces);
    AtomicFile::commit_all({&nodes, &elements, &faces});
}

}  // namespace cleft::io
