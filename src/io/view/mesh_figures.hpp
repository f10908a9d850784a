// What the page tells of a mesh in numbers. They come from the whole mesh, also where the page shows a part of it.
#pragma once

#include "base/run.hpp"
#include "io/mesh_view.hpp"
#include "io/tet_shape.hpp"

#include <array>
#include <cstdint>
#include <vector>

namespace cleft::io
{

struct TetShape {
    double least_angle = 0, greatest_angle = 0;  // dihedral, in degrees
    double radius_ratio = 0;                     // see tet_shape.hpp
    double volume = 0;                           // negative for the other orientation
};

struct WorstTet {
    int64_t tet = 0;
    TetShape shape;
};

struct LabelFigures {
    int64_t tets = 0;
    double volume = 0;
};

struct MeshFigures {
    Vector3 low{}, high{};             // the bounding box of the points that tetrahedra use
    std::vector<LabelFigures> labels;  // in the order of MeshView::labels
    std::vector<WorstTet> by_angle;    // the least angles first
    std::vector<WorstTet> by_ratio;    // the greatest radius ratios first
};

MeshFigures figures_of(const MeshView& mesh, const Run& run);

Corners corners_of(const MeshView& mesh, int64_t tet);

}  // namespace cleft::io
