// Which blocks of voxels of an indicator field are sure to hold one material.
#pragma once

#include "volume/indicator_field.hpp"

namespace cleft
{

constexpr int kBlock = 4;

// Sets `blocks` and `depth`.
void find_single_blocks(IndicatorField& field, const Run& run);

}  // namespace cleft
