// VTK legacy, text: the format that the most programs read.
#include "io/atomic_file.hpp"
#include "io/writers.hpp"

namespace cleft::io
{

void write_vtk(const MeshView& mesh, const std::string& path)
{
    constexpr int kVtkTetra = 10;
    AtomicFile file(path);
    // Version 3.0 and not 5.1, whose OFFSETS many programs do not know.
    file.print("# vtk DataFile Version 3.0\ncleft\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS ", mesh.point_count,
               " double\n");
    for (int64_t i = 0; i < mesh.point_count; ++i) {
        const double* p = mesh.points + 3 * i;
        file.print(p[0], ' ', p[1], ' ', p[2], '\n');
    }
    // Five numbers for each cell: the count of its corners and four corners.
    file.print("CELLS ", mesh.tet_count, ' ', 5 * mesh.tet_count, '\n');
    for (int64_t t = 0; t < mesh.tet_count; ++t) {
        const int32_t* c = mesh.tets + 4 * t;
        file.print("4 ", c[0], ' ', c[1], ' ', c[2], ' ', c[3], '\n');
    }
    file.print("CELL_TYPES ", mesh.tet_count, '\n');
    for (int64_t t = 0; t < mesh.tet_count; ++t)
        file.print(kVtkTetra, '\n');
    file.print("CELL_DATA ", mesh.tet_count, "\nSCALARS material int 1\nLOOKUP_TABLE default\n");
    for (int64_t t = 0; t < mesh.tet_count; ++t)
        file.print(mesh.tet_labels[t], '\n');
    file.commit();
}

}  // namespace cleft::io
