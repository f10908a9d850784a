// A page that shows meshes in a browser, as one file.
#pragma once

#include "base/run.hpp"
#include "io/mesh_view.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft::io
{

// One of the meshes of a page.
struct PageMesh {
    const cleft_mesh* mesh = nullptr;
    const cleft_surface* surface = nullptr;  // null where it is not needed, or cannot be made
    cleft_quality quality{};
    std::string title;
    std::string report;  // JSON, or ""
    MeshView view;       // of `mesh`
};

struct PageOptions {
    int64_t max_tets = 0;  // that the page has of each mesh
    double goal = 0;       // the least dihedral angle that was wanted, in degrees; 0: what the report says
};

// Throws Error where the file cannot be written.
void write_page(const std::vector<PageMesh>& meshes, const PageOptions& options, const std::string& path,
                const Run& run);

}  // namespace cleft::io
