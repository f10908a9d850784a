// Entry: a page that shows a mesh, or two.
#include "base/stage.hpp"
#include "base/struct_size.hpp"
#include "cleft/cleft_io.h"
#include "io/call_run.hpp"
#include "io/create_volume.hpp"
#include "io/entry.hpp"
#include "io/name_table.hpp"
#include "io/view/write_page.hpp"

#include <cmath>

// The size of the struct in version 0.1. Callers that were compiled with it stay valid when fields
// are added at the end.
template <>
inline constexpr size_t cleft::kFirstSize<cleft_io_view> = CLEFT_END_OF(cleft_io_view, other_report);

namespace cleft::io
{

namespace
{

// A million tetrahedra take some 100 MB in a browser, and a tenth of a second when a cut moves.
constexpr int64_t kMostTets = 3000000;

cleft_io_view checked_view(const cleft_io_view* given)
{
    cleft_io_view view = given ? copy_in(*given, "cleft_io_view") : cleft_io_view{};
    if (view.reserved != 0)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "reserved of the cleft_io_view is " + std::to_string(view.reserved) + "; it must be 0");
    if (view.max_tets < 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "max_tets is " + std::to_string(view.max_tets) + "; it must not be negative");
    if (!std::isfinite(view.goal) || view.goal < 0 || view.goal > 90)
        throw Error(CLEFT_ERROR_ARGUMENT, "the goal of the least dihedral angle must be from 0 to 90 degrees");
    if (view.max_tets == 0)
        view.max_tets = kMostTets;
    return view;
}

// Before the struct is checked: the second mesh has to live during the call as the first one does.
const cleft_mesh* other_of(const cleft_io_view* view)
{
    return view && view->struct_size >= CLEFT_END_OF(cleft_io_view, other) ? view->other : nullptr;
}

const char* text_or_empty(const char* text) { return text ? text : ""; }

// Only a mesh that is shown in part needs its surface. One whose faces are broken has none, and is shown all the same.
SurfaceHandle surface_for(cleft_context* context, const cleft_mesh* mesh, int64_t max_tets)
{
    cleft_surface* surface = nullptr;
    if (cleft_mesh_tet_count(mesh) <= max_tets)
        return nullptr;
    const cleft_status status = cleft_surface_create(context, mesh, &surface);
    if (status != CLEFT_OK && status != CLEFT_ERROR_INVALID_MESH)
        check(context, status);
    return SurfaceHandle(surface);
}

PageMesh page_mesh(cleft_context* context, const cleft_mesh* mesh, const cleft_surface* surface, const char* title,
                   const char* report)
{
    if (cleft_mesh_tet_count(mesh) == 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "the mesh has no tetrahedra to show");
    PageMesh page;
    page.mesh = mesh;
    page.surface = surface;
    page.title = title && *title ? title : "Mesh";
    page.report = text_or_empty(report);
    page.quality.struct_size = sizeof page.quality;
    check(context, cleft_mesh_quality(context, mesh, &page.quality));
    page.view = view_of(mesh, nullptr);
    return page;
}

void use_names(const std::map<int32_t, std::string>& names, PageMesh& page)
{
    for (size_t l = 0; l < page.view.labels.size(); ++l) {
        const auto found = names.find(page.view.labels[l]);
        if (found != names.end() && !found->second.empty())
            page.view.names[l] = found->second;
    }
}

void read_names(cleft_context* context, const char* path, std::vector<PageMesh>& pages)
{
    const NameTable table = read_name_table(path);
    for (const std::string& note : table.notes)
        report(context, "'" + std::string(path) + "': " + note);
    for (PageMesh& page : pages)
        use_names(table.names, page);
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

cleft_status cleft_io_write_view(cleft_context* context, const cleft_mesh* mesh, const cleft_io_view* view,
                                 const char* path) noexcept
{
    return entry(context, {mesh, other_of(view)}, [&] {
        required(mesh, "mesh");
        required(path, "path");
        const cleft_io_view options = checked_view(view);
        const cleft_mesh* other = options.other;
        // The core measures each mesh first, and finds the surface of a large one.
        constexpr double kCoreShare = 0.1;
        const double each = kCoreShare / (other ? 4 : 2);
        CallRun call(context, "page");
        SurfaceHandle surfaces[2];
        std::vector<PageMesh> pages;
        const auto add = [&](const cleft_mesh* shown, const char* title, const char* report) {
            SurfaceHandle& surface = surfaces[pages.size()];
            call.begin_inner(each, "page: surface");
            surface = surface_for(context, shown, options.max_tets);
            call.begin_inner(each, "page: quality");
            pages.push_back(page_mesh(context, shown, surface.get(), title, report));
        };
        add(mesh, options.title, options.report);
        if (other)
            add(other, options.other_title, options.other_report);
        if (options.names)
            read_names(context, options.names, pages);
        cleft::Steps steps(call.run(), {{nullptr, kCoreShare}, {nullptr, 1 - kCoreShare}});
        steps.next();
        write_page(pages, {options.max_tets, options.goal}, path, steps.next());
    });
}
