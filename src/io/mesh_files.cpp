// Entries: the table of formats, meshes out and in.
#include "base/struct_size.hpp"
#include "cleft/cleft_io.h"
#include "io/byte_source.hpp"
#include "io/entry.hpp"
#include "io/formats.hpp"
#include "io/image_readers.hpp"
#include "io/path_kind.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

// The size of the struct in version 0.1. Callers that were compiled with it stay valid when fields
// are added at the end.
template <>
inline constexpr size_t cleft::kFirstSize<cleft_io_format_description> = CLEFT_END_OF(cleft_io_format_description,
                                                                                      text);

namespace cleft::io
{

namespace
{

const MeshFormat& resolve(const std::string& path, cleft_io_format format, int32_t direction)
{
    const bool by_name = format == CLEFT_FORMAT_BY_NAME;
    const MeshFormat* row = by_name ? format_of_path(path, direction) : find_format(format);
    if (row && (row->about.directions & direction))
        return *row;
    if (direction == CLEFT_IO_READS_MESH)
        naming_file(path, [&] { refuse_foreign_mesh(path); });
    throw Error(CLEFT_ERROR_ARGUMENT,
                by_name ? "'" + path + "': its extension is none of " + extensions_with(direction)
                        : "there is no format " + std::to_string(format) + " in which meshes are written");
}

struct MeshDeleter {
    void operator()(cleft_mesh* mesh) const { cleft_mesh_destroy(mesh); }
};
using MeshHandle = std::unique_ptr<cleft_mesh, MeshDeleter>;

// Files may name labels that no tetrahedron has.
void name_labels(const MeshData& data, const std::string& path, cleft_mesh* mesh)
{
    // A name of a label without tetrahedra is left out: Gmsh keeps groups of entities that were not
    // meshed.
    const int32_t* labels = cleft_mesh_labels(mesh);
    for (const auto& [label, name] : data.names)
        if (std::binary_search(labels, labels + cleft_mesh_label_count(mesh), label) &&
            cleft_mesh_set_label_name(mesh, label, name.c_str()) != CLEFT_OK)
            throw Error(CLEFT_ERROR_FORMAT,
                        "'" + path + "': the name of label " + std::to_string(label) + " is no line of UTF-8");
}

// Both images and meshes may have this extension; its fourth line tells which.
bool is_vtk_mesh(const std::string& path)
{
    // The header of a legacy VTK file: 256 characters at most for each of its first two lines, and
    // two short ones.
    char start[1024] = {};
    try {
        ByteSource(path, Coding::plain).read_some(start, sizeof start - 1);
    } catch (const Error&) {  // whoever reads the file tells more
        return false;
    }
    // The last byte of the array is never written, so the text ends with a zero.
    return std::strstr(start, "UNSTRUCTURED_GRID") != nullptr;
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

int32_t cleft_io_format_count(void) noexcept { return format_count(); }

cleft_status cleft_io_format_info(int32_t index, cleft_io_format_description* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_io_format_description");
        if (index < 0 || index >= format_count())
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there is no such row");
        cleft::copy_out(format_row(index), *out);
    });
}

int32_t cleft_io_guess(const char* path) noexcept
{
    try {
        if (!path)
            return CLEFT_IO_UNKNOWN;
        const bool volume = is_volume_path(path) || is_folder(path);
        const bool mesh = format_of_path(path, CLEFT_IO_READS_MESH | CLEFT_IO_WRITES_MESH) != nullptr;
        if (volume && mesh)
            return is_vtk_mesh(path) ? CLEFT_IO_MESH : CLEFT_IO_VOLUME;
        return volume ? CLEFT_IO_VOLUME : mesh ? CLEFT_IO_MESH : CLEFT_IO_UNKNOWN;
    } catch (...) {
        return CLEFT_IO_UNKNOWN;
    }
}

cleft_status cleft_io_write_mesh(cleft_context* context, const cleft_mesh* mesh, const char* path,
                                 cleft_io_format format) noexcept
{
    return entry(context, {mesh}, [&] {
        required(mesh, "mesh");
        required(path, "path");
        const MeshFormat& row = resolve(path, format, CLEFT_IO_WRITES_MESH);
        // Most formats and programs have no form for an empty mesh. It comes from stripping all labels.
        if (cleft_mesh_tet_count(mesh) == 0)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "the mesh has no tetrahedra to write");
        SurfaceHandle surface;
        if (row.has_surface) {
            // The surface is made once for all formats, so that groups have the same order and numbers in each.
            cleft_surface* made = nullptr;
            check(context, cleft_surface_create(context, mesh, &made));
            surface.reset(made);
        }
        row.write(view_of(mesh, surface.get()), path, cleft_context_threads(context));
    });
}

cleft_status cleft_io_read_mesh(cleft_context* context, const char* path, cleft_mesh** out) noexcept
{
    return entry_making(context, out, {}, [&] {
        required(path, "path");
        const MeshData mesh = resolve(path, CLEFT_FORMAT_BY_NAME, CLEFT_IO_READS_MESH).read(path);
        // A surface mesh is a common mistake here, and the core's sentence about it would not name the file.
        if (mesh.tets.empty())
            throw cleft::Error(CLEFT_ERROR_FORMAT, std::string("'") + path + "': there are no tetrahedra in it");
        const std::string place = std::string("'") + path + "': ";
        cleft_mesh* made = nullptr;
        check(context,
              cleft_mesh_create(context, static_cast<int64_t>(mesh.points.size() / 3), mesh.points.data(),
                                static_cast<int64_t>(mesh.tets.size() / 4), mesh.tets.data(),
                                mesh.labels.empty() ? nullptr : mesh.labels.data(), 0, &made),
              place.c_str());
        // If a name is refused, the handle is destroyed and *out stays NULL.
        MeshHandle owner(made);
        name_labels(mesh, path, made);
        *out = owner.release();
    });
}
