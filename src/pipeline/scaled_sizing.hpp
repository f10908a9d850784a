// A sizing field, and what the search for a number of tetrahedra made of it.
#pragma once

#include "sizing/sizing_field.hpp"

namespace cleft
{

struct ScaledSizing {
    SizingField field;
    double scale = 1;  // what its values have been multiplied by since they were asked for
    // The scale was found by meshing for a wanted number of tetrahedra (0: for none), and gave so many.
    int64_t found_for = 0, found = 0;
};

}  // namespace cleft
