// The sizing field h(x): the wanted edge length of tetrahedra, in world units, gradation-Lipschitz.
#pragma once

#include "base/mix.hpp"
#include "base/run.hpp"
#include "volume/grid.hpp"
#include "volume/volume.hpp"

#include <algorithm>
#include <functional>
#include <utility>
#include <vector>

namespace cleft
{

// Lengths are in world units. What is said explicitly wins: interface_size, label_sizes and the user's field may ask
// for sizes below the least spacing. A size_min that is given (not 0) holds for them too: nothing is smaller.
struct SizingOptions {
    double size = 0;            // constant size instead of features (size_min, size_max unused); 0: from the volume
    double size_min = 0;        // 0: the least spacing of the grid, for sizes that come from features
    double size_max = 0;        // 0: a quarter of the longest side of the box, but no more than its shortest side
                                // or the greatest spacing, nor 1.5 times the shortest side, unless a very flat plate
                                // would have very many elements (they should not be flatter than it)
    double feature_scale = 1;   // size at an interface = feature_scale * local feature size
    double gradation = 0.3;     // Lipschitz constant of h
    double interface_size = 0;  // greatest size at an interface; 0: none
    bool keep_thin = false;     // half the least spacing where a material is one voxel thick
    double max_tets = 0;        // where size_min is 0, sizes from features are at least as large as keeps the expected
                                // number of background tetrahedra to about this; 0: no limit
    std::vector<std::pair<int32_t, double>> label_sizes;  // (label, greatest size inside it)
    const float* user = nullptr;  // a user's own field at voxel centres, combined by minimum; may be null
};

// Values at the voxel centres of the grid; read between them by trilinear interpolation, constant past the outermost.
struct SizingField {
    Grid grid;
    std::vector<float> h;
    double gradation = 0.3;
    double scale = 1;  // what its values have been multiplied by since they were asked for
    // The scale was found by meshing for a wanted number of tetrahedra (0: for none), and gave so many.
    int64_t found_for = 0, found = 0;

    double at(const Vec3& x) const;
    double least() const;
    double greatest() const;
};

// In the header because particles ask for it a hundred times each.
inline double SizingField::at(const Vec3& x) const
{
    const float* corner = h.data();
    double t[3];
    int64_t step[3];
    int64_t stride = 1;
    for (int a = 0; a < 3; ++a) {
        const int32_t n = grid.dims[static_cast<size_t>(a)];
        const double u = std::min(std::max(0.0, x[a] / grid.spacing[a] - 0.5), static_cast<double>(n - 1));
        const int32_t low = std::min(static_cast<int32_t>(u), std::max(n - 2, 0));
        t[a] = u - low;
        step[a] = n > 1 ? stride : 0;
        corner += low * stride;
        stride *= n;
    }
    const auto along_x = [&](const float* p) { return mix(double{p[0]}, double{p[step[0]]}, t[0]); };
    const auto in_plane = [&](const float* p) { return mix(along_x(p), along_x(p + step[1]), t[1]); };
    return mix(in_plane(corner), in_plane(corner + step[2]), t[2]);
}

// The three distance transforms of the paper (section 3, Sizing Field), then limits, user's field and gradation.
SizingField compute_sizing(const Volume& volume, const SizingOptions& options, const Run& run);

// Throws if the greatest wanted size is less than the least.
void check_size_range(const SizingOptions& options);
SizingField constant_sizing(const Grid& grid, double size);
// A user's own values (positive, finite; an Error names the first that is not), taken as they are.
SizingField sizing_from_values(const Grid& grid, const double* values);

// Integral of h^-3 over the voxels that count (all, if `counts` is null), as the field is interpolated.
double sizing_charge(const SizingField& field, const std::function<bool(int64_t voxel)>& counts = nullptr);
// Tetrahedra that the particle background would have.
double expected_background_tets(const SizingField& field);
// Those of them in the voxels of some materials; keep[material] != 0, all if it is empty.
double expected_background_tets(const SizingField& field, const Volume& volume, const std::vector<char>& keep);
// Every value times `factor`, and then as much less as the gradation asks for: sizes at the interfaces scale, their
// growth away from them does not.
void scale_sizing(SizingField& field, double factor, const Run& run);

}  // namespace cleft
