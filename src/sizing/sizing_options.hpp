// What a caller may ask of a sizing field.
#pragma once

#include "base/array.hpp"

#include <cstdint>
#include <functional>

namespace cleft
{

struct Run;
struct SizingField;

// Lengths are in world units. What is said explicitly wins: interface_size, material_sizes and the user's field may ask
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
    double surface_error = 0;   // greatest distance of triangles from their interface; 0: no limit
    double anisotropy = 1;   // greatest ratio of the sizes along and across an interface; 1: the same in all directions
    bool keep_thin = false;  // half the least spacing where a material is one voxel thick
    double max_tets = 0;     // where size_min is 0, sizes from features are at least as large as keeps the expected
                             // number of background tetrahedra to about this; 0: no limit
    double raised = 1;       // features may ask for so many times less at least than the least size
    // The number that max_tets limits, of the background that will be made. It need be exact near the limit only.
    // Empty: of particles.
    std::function<double(const SizingField& field, double limit, const Run& run)> expected_tets;
    Array<double> material_sizes;  // by material: the greatest size inside it, or 0; empty: none has one
    const float* user = nullptr;   // a user-supplied field at voxel centres, combined by minimum; may be null
};

}  // namespace cleft
