// A mesh as the writers see it: borrowed arrays, and the surface triangles in named groups.
#pragma once

#include "cleft/cleft.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace cleft::io
{

// Triangles of one interface (both labels, the lower first), or of the hull on one side within one label.
struct SurfaceGroup {
    static constexpr int32_t kNoSide = -1;

    std::string name;        // "interface_1_3", "box_x_min_3", "hull_3"
    int32_t side = kNoSide;  // or CLEFT_SIDE_...
    int32_t first = 0;       // the label that the normals point away from
    int32_t second = 0;      // the label that they point to; of the hull: `first` again
    const int32_t* triangles = nullptr;
    int64_t count = 0;
    int32_t number = 0;  // in formats that number groups, see number_groups()

    bool is_interface() const { return side == kNoSide; }
    // Does it lie inside the box, where a surface is worth looking at?
    bool is_inner() const { return is_interface() || side == CLEFT_SIDE_OTHER; }
};

struct MeshView {
    int64_t point_count = 0;
    const double* points = nullptr;
    int64_t tet_count = 0;
    const int32_t* tets = nullptr;
    const int32_t* tet_labels = nullptr;
    std::vector<int32_t> labels;          // ascending
    std::vector<std::string> names;       // of the labels, "" where there is none
    std::vector<int32_t> volume_numbers;  // of the labels, in formats whose numbers must be positive
    // Interfaces first, then the hull; empty if the surface was not asked for.
    std::vector<SurfaceGroup> groups;

    int64_t triangle_count() const;
    // Position of a label in `labels`.
    size_t label_index(int32_t label) const;
    // "material_3", "material_3_right_lung": what a label is called, by its position in `labels`.
    std::string material(size_t index) const;
};

// The surface must live as long as a view of it.
struct SurfaceDeleter {
    void operator()(cleft_surface* surface) const { cleft_surface_destroy(surface); }
};
using SurfaceHandle = std::unique_ptr<cleft_surface, SurfaceDeleter>;

// `surface` may be null. The view borrows from both.
MeshView view_of(const cleft_mesh* mesh, const cleft_surface* surface);

}  // namespace cleft::io
