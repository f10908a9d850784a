// Reads TetGen's .node and .ele files. Whichever of the names is given, the other file is looked
// for beside it.
#include "io/file_name.hpp"
#include "io/mesh_data.hpp"
#include "io/text_scanner.hpp"

namespace cleft::io
{

namespace
{

// The number from which TetGen counts points: 0 or 1, the number of the first one.
int64_t read_nodes(const std::string& path, MeshData& mesh)
{
    TextScanner in(path, '#');
    // A number and three coordinates, each with a blank: 8 bytes at least. The header line also has
    // numbers of attributes and markers, which are not needed.
    const int64_t count = in.count(8, "points");
    if (in.integer() != 3)
        in.unsupported("the points must have three dimensions");
    in.skip_line();
    int64_t base = 0;
    mesh.points.reserve(static_cast<size_t>(3 * count));
    for (int64_t i = 0; i < count; ++i) {
        const int64_t number = in.integer();
        if (i == 0)
            base = number;
        // .ele names points by these numbers. TetGen itself writes them without gaps.
        if (base < 0 || base > 1 || number != base + i)
            in.fail("points must be numbered one by one from 0 or 1");
        for (int axis = 0; axis < 3; ++axis)
            mesh.points.push_back(in.real());
        in.skip_line();  // attributes and marker
    }
    return base;
}

void read_elements(const std::string& path, int64_t base, MeshData& mesh)
{
    TextScanner in(path, '#');
    // A number and four corners: 10 bytes at least.
    const int64_t count = in.count(10, "tetrahedra");
    // 10 corners are of second order, which TetGen writes with -o2.
    if (in.integer() != 4)
        in.unsupported("tetrahedra must have four corners");
    // The number of attributes may be left out by hand-written files. The first attribute is the
    // region, TetGen's -A.
    const bool has_labels = in.more_on_line() && in.integer() > 0;
    in.skip_line();
    mesh.tets.reserve(static_cast<size_t>(4 * count));
    mesh.labels.reserve(has_labels ? static_cast<size_t>(count) : 0);
    for (int64_t t = 0; t < count; ++t) {
        in.integer();
        for (int corner = 0; corner < 4; ++corner)
            mesh.tets.push_back(in.point(base, static_cast<int64_t>(mesh.points.size() / 3)));
        if (has_labels)
            mesh.labels.push_back(in.label());
        in.skip_line();
    }
}

}  // namespace

MeshData read_tetgen(const std::string& path)
{
    const std::string prefix = tetgen_prefix(path);
    MeshData mesh;
    const int64_t base = read_nodes(prefix + ".node", mesh);
    read_elements(prefix + ".ele", base, mesh);
    return mesh;
}

}  // namespace cleft::io
