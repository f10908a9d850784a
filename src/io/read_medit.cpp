// Reads the tetrahedra of MEDIT's .mesh files of text. The reference of a tetrahedron is its label.
#include "io/mesh_data.hpp"
#include "io/text_scanner.hpp"

#include <map>

namespace cleft::io
{

namespace
{

// Numbers in each row of the sections that may be passed over.
// Each row of them has a fixed number of numbers. Sections of other elements of three dimensions
// are not here, so that they are refused.
const std::map<std::string, int, std::less<>> kRowsToSkip = {
    {"Corners", 1},
    {"RequiredVertices", 1},
    {"Edges", 3},
    {"Ridges", 1},
    {"RequiredEdges", 1},
    {"Triangles", 4},
    {"RequiredTriangles", 1},
    {"Quadrilaterals", 5},
    {"RequiredQuadrilaterals", 1},
    {"Normals", 3},
    {"NormalAtVertices", 2},
    {"Tangents", 3},
    {"TangentAtVertices", 2},
    {"RequiredTetrahedra", 1},
};

void read_vertices(TextScanner& in, MeshData& mesh)
{
    // Three coordinates and a reference, each with a blank: 8 bytes at least.
    const int64_t count = in.count(8, "vertices");
    mesh.points.reserve(static_cast<size_t>(3 * count));
    for (int64_t i = 0; i < count; ++i) {
        for (int axis = 0; axis < 3; ++axis)
            mesh.points.push_back(in.real());
        // Read as a real, as some writers give references with a decimal point.
        in.real();  // the reference of a vertex
    }
}

void read_tetrahedra(TextScanner& in, MeshData& mesh)
{
    // Four corners and a reference: 10 bytes at least.
    const int64_t count = in.count(10, "tetrahedra");
    // MEDIT counts from 1. "Vertices" comes before the elements in all known files; the other way
    // round, corners would be refused.
    const int64_t points = static_cast<int64_t>(mesh.points.size() / 3);
    mesh.tets.reserve(static_cast<size_t>(4 * count));
    mesh.labels.reserve(static_cast<size_t>(count));
    for (int64_t t = 0; t < count; ++t) {
        for (int corner = 0; corner < 4; ++corner)
            mesh.tets.push_back(in.point(1, points));
        mesh.labels.push_back(in.label());
    }
}

}  // namespace

MeshData read_medit(const std::string& path)
{
    TextScanner in(path, '#');
    MeshData mesh;
    if (in.at_end() || in.word() != "MeshVersionFormatted")
        in.fail("a MEDIT file begins with MeshVersionFormatted");
    // The version tells single or double precision of binary files, and changes nothing in text.
    in.integer();
    while (!in.at_end()) {
        const std::string_view section = in.word();
        const auto skip = kRowsToSkip.find(section);
        if (section == "End")
            break;
        if (section == "Dimension") {
            if (in.integer() != 3)
                in.unsupported("the mesh must have three dimensions");
        } else if (section == "Vertices") {
            read_vertices(in, mesh);
        } else if (section == "Tetrahedra") {
            read_tetrahedra(in, mesh);
        } else if (skip != kRowsToSkip.end()) {
            const int64_t count = in.count(2, "rows");
            for (int64_t i = 0; i < count * skip->second; ++i)
                in.real();
        } else {
            in.unsupported("section " + std::string(section.substr(0, 40)) + " cannot be read");
        }
    }
    return mesh;
}

}  // namespace cleft::io
