// Entry: a picture of a mesh.
#include "base/stage.hpp"
#include "base/struct_size.hpp"
#include "cleft/cleft_io.h"
#include "io/call_run.hpp"
#include "io/create_volume.hpp"
#include "io/entry.hpp"
#include "io/file_name.hpp"
#include "io/mesh_view.hpp"
#include "io/render/picture.hpp"
#include "io/write_png.hpp"

#include <algorithm>

// The size of the struct in version 0.1. Callers that were compiled with it stay valid when fields
// are added at the end.
template <>
inline constexpr size_t cleft::kFirstSize<cleft_io_picture> = CLEFT_END_OF(cleft_io_picture, range);

namespace cleft::io
{

namespace
{

std::vector<int32_t> label_list(const int32_t* labels, int64_t count, const char* name)
{
    if (count < 0)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    std::string("the number of labels in ") + name + " is " + std::to_string(count));
    if (count == 0)
        return {};
    const int32_t* first = required(labels, name);
    return {first, first + count};
}

// A misspelt number would otherwise leave a label in the picture unnoticed.
void warn_of_unknown(cleft_context* context, const MeshView& mesh, const std::vector<int32_t>& list, const char* name)
{
    for (const int32_t label : list)
        if (!std::binary_search(mesh.labels.begin(), mesh.labels.end(), label))
            report(context,
                   std::string(name) + " names label " + std::to_string(label) + ", which the mesh does not have");
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

cleft_status cleft_io_write_picture(cleft_context* context, const cleft_mesh* mesh, const int32_t* strip,
                                    int64_t strip_count, const int32_t* whole, int64_t whole_count,
                                    const cleft_io_picture* picture, const char* path) noexcept
{
    return entry(context, {mesh}, [&] {
        required(mesh, "mesh");
        const std::string name = required(path, "path");
        if (extension_of(name) != ".png")
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "'" + name + "': a picture is written as .png");
        cleft_io_picture defaults{};
        defaults.struct_size = sizeof defaults;
        const PictureRequest request =
            checked_request(cleft::copy_in(picture ? *picture : defaults, "cleft_io_picture"),
                            label_list(strip, strip_count, "strip"), label_list(whole, whole_count, "whole"));
        if (cleft_mesh_tet_count(mesh) == 0)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "the mesh has no tetrahedra to draw");
        const MeshView view = view_of(mesh, nullptr);
        warn_of_unknown(context, view, request.strip, "strip");
        warn_of_unknown(context, view, request.whole, "whole");
        CallRun call(context, "picture");
        // Microseconds on one thread.
        const auto tets = static_cast<double>(view.tet_count);
        const double pixels = static_cast<double>(request.width) * request.height;
        cleft::Steps steps(call.run(),
                           {{nullptr, 0.16 * tets + 0.37 * pixels}, {"picture: compressing", 0.25 * pixels}});
        const Canvas canvas = draw_picture(view, request, steps.next());
        write_png(name, canvas, request.backdrop == CLEFT_IO_BACKDROP_NONE, steps.next());
    });
}
