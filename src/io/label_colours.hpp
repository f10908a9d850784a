// The colour that a label has in every picture and view.
#pragma once

#include "io/colour.hpp"

#include <cstdint>

namespace cleft::io
{

// It depends on the label alone, so that a label looks the same in every mesh. Label 0 is grey: it is most often the
// outside. Labels that follow each other differ in hue; two labels have the same colour if they are 21 apart.
Colour colour_of_label(int32_t label);

}  // namespace cleft::io
