// Owners of the library's handles.
#pragma once

#include "cleft/cleft.h"

#include <memory>

namespace cleft_cli
{

// One type serves all handles, as overloads choose the function. unique_ptr never calls it for
// NULL.
struct Destroy {
    void operator()(cleft_context* handle) const { cleft_context_destroy(handle); }
    void operator()(cleft_options* handle) const { cleft_options_destroy(handle); }
    void operator()(cleft_volume* handle) const { cleft_volume_destroy(handle); }
    void operator()(cleft_sizing* handle) const { cleft_sizing_destroy(handle); }
    void operator()(cleft_mesh* handle) const { cleft_mesh_destroy(handle); }
    void operator()(cleft_surface* handle) const { cleft_surface_destroy(handle); }
    void operator()(cleft_report* handle) const { cleft_report_destroy(handle); }
};

using Context = std::unique_ptr<cleft_context, Destroy>;
using Options = std::unique_ptr<cleft_options, Destroy>;
using Volume = std::unique_ptr<cleft_volume, Destroy>;
using Sizing = std::unique_ptr<cleft_sizing, Destroy>;
using Mesh = std::unique_ptr<cleft_mesh, Destroy>;
using Surface = std::unique_ptr<cleft_surface, Destroy>;
using Report = std::unique_ptr<cleft_report, Destroy>;

}  // namespace cleft_cli
