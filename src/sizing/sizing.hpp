// The sizing field h(x): the wanted edge length of tetrahedra, in world units, gradation-Lipschitz.
#pragma once

#include "base/run.hpp"
#include "volume/grid.hpp"
#include "volume/volume.hpp"

#include <utility>
#include <vector>

namespace cleft {

struct SizingOptions {
    double size = 0;             // constant size everywhere; 0: computed from the volume
    double size_min = 0;         // 0: the least spacing of the grid
    double size_max = 0;         // 0: no limit but a quarter of the longest side of the box
    double feature_scale = 1;    // size at an interface = feature_scale * local feature size
    double gradation = 0.3;      // Lipschitz constant of h
    double interface_size = 0;   // greatest size at an interface; 0: none
    std::vector<std::pair<int32_t, double>> label_sizes;  // (label, greatest size inside it)
    const float* user = nullptr;  // a user's own field at voxel centres, combined by minimum; may be null
};

// Values at the voxel centres of the grid; read between them by trilinear interpolation, constant past the outermost.
struct SizingField {
    Grid grid;
    std::vector<float> h;
    double gradation = 0.3;

    double at(const Vec3& x) const;
    double least() const;
    double greatest() const;
};

// The three distance transforms of the paper (section 3, Sizing Field), then limits, user's field and gradation.
SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run);
SizingField constant_sizing(const Grid& grid, double size);
// A user's own values (positive, finite; an Error names the first that is not), taken as they are.
SizingField sizing_from_values(const Grid& grid, const double* values);

// Integral of h^-3 over the box.
double sizing_charge(const SizingField& field);
// Tetrahedra that the particle background would have.
double expected_background_tets(const SizingField& field);
// Every value times `factor`.
void scale_sizing(SizingField& field, double factor);

}  // namespace cleft
