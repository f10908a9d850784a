// VTK XML unstructured grids of one piece.
#include "io/mesh_data.hpp"
#include "io/text_scanner.hpp"
#include "io/vtu_piece.hpp"

namespace cleft::io
{

MeshData read_vtu(const std::string& path)
{
    const std::string text = read_whole_file(path);
    return naming_file(path, [&] {
        VtuPiece piece = read_vtu_piece(text);
        MeshData mesh;
        mesh.points = std::move(piece.points);
        take_tetrahedra(piece.cells, piece.arrays, mesh);
        mesh.names = std::move(piece.names);
        return mesh;
    });
}

}  // namespace cleft::io
