// The tetrahedra that a page has of a mesh: all of them, or a part that a browser can hold.
#pragma once

#include "base/run.hpp"
#include "io/mesh_view.hpp"
#include "io/view/mesh_figures.hpp"

#include <cstdint>
#include <vector>

namespace cleft::io
{

enum class Reduction {
    kNone,
    kInterfaces,  // the tetrahedra at interfaces and at the hull: those with three corners there
    kMiddle,      // of these, the ones in a box of the shape of the mesh around its centre
};

struct PageTets {
    Reduction reduction = Reduction::kNone;
    std::vector<int64_t> tets;    // ascending
    std::vector<int32_t> points;  // that they use, ascending
};

// At most `limit`, which is positive. `surface` gives the interfaces and the hull, and may be null: then kMiddle is of
// all tetrahedra. The choice depends on the mesh and the limit alone.
PageTets choose_tets(const MeshView& mesh, const cleft_surface* surface, const MeshFigures& figures, int64_t limit,
                     const Run& run);

}  // namespace cleft::io
