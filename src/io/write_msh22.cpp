// Gmsh 2.2, text: physical group and entity have the same number.
#include "io/gmsh_model.hpp"
#include "io/writers.hpp"

namespace cleft::io
{

namespace
{

void write_msh22_elements(const MeshView& mesh, AtomicFile& file)
{
    file.print("$Elements\n", mesh.triangle_count() + mesh.tet_count, '\n');
    int64_t element = 0;
    for (const SurfaceGroup& group : mesh.groups)
        for (int64_t t = 0; t < group.count; ++t) {
            const int32_t* c = group.triangles + 3 * t;
            // " 2 ": two tags follow, physical group and entity. Elements are numbered through both
            // kinds, as no two may have the same number.
            file.print(++element, ' ', kGmshTriangle, " 2 ", group.number, ' ', group.number, ' ', c[0] + int64_t{1},
                       ' ', c[1] + int64_t{1}, ' ', c[2] + int64_t{1}, '\n');
        }
    for (int64_t t = 0; t < mesh.tet_count; ++t) {
        const int32_t* c = mesh.tets + 4 * t;
        const int32_t volume = mesh.volume_numbers[mesh.label_index(mesh.tet_labels[t])];
        file.print(++element, ' ', kGmshTetrahedron, " 2 ", volume, ' ', volume, ' ', c[0] + int64_t{1}, ' ',
                   c[1] + int64_t{1}, ' ', c[2] + int64_t{1}, ' ', c[3] + int64_t{1}, '\n');
    }
    file.print("$EndElements\n");
}

}  // namespace

void write_msh22(const MeshView& mesh, const std::string& path)
{
    AtomicFile file(path);
    file.print("$MeshFormat\n2.2 0 8\n$EndMeshFormat\n");
    write_physical_names(mesh, file);
    file.print("$Nodes\n", mesh.point_count, '\n');
    for (int64_t i = 0; i < mesh.point_count; ++i) {
        const double* p = mesh.points + 3 * i;
        file.print(i + 1, ' ', p[0], ' ', p[1], ' ', p[2], '\n');
    }
    file.print("$EndNodes\n");
    write_msh22_elements(mesh, file);
    file.commit();
}

}  // namespace cleft::io
