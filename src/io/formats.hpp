// The table of formats: what users read of them, which extensions stand for them, and who writes and reads meshes.
#pragma once

#include "cleft/cleft_io.h"
#include "io/mesh_data.hpp"
#include "io/mesh_view.hpp"

#include <string>

namespace cleft::io
{

// Compression may use `threads`; the bytes do not depend on them.
using MeshWriter = void (*)(const MeshView& mesh, const std::string& path, int threads);
using MeshReader = MeshData (*)(const std::string& path);

struct MeshFormat {
    cleft_io_format_description about;
    MeshWriter write;  // null: Cleft does not write it by itself
    MeshReader read;   // null: Cleft does not read it
    bool has_surface;  // Does it have the triangles of interfaces and hull?
};

// Of meshes first, then of volumes.
int32_t format_count();
// `index` is in 0 .. format_count() - 1 and not checked. The rows live as long as the library.
const cleft_io_format_description& format_row(int32_t index);

// The row of a format of meshes, or null.
const MeshFormat* find_format(cleft_io_format format);
// The first format of meshes that has the extension of the path and one of the directions, or null.
const MeshFormat* format_of_path(const std::string& path, int32_t directions);
// Does a format of volumes have the extension of the path?
bool is_volume_path(const std::string& path);
// ".vtu .vtk ...": for messages.
std::string extensions_with(int32_t direction);

}  // namespace cleft::io
