// Which blocks of voxels of an indicator field are sure to hold one material.
#pragma once

#include "volume/indicator_field.hpp"

namespace cleft
{

// Voxels along a side. Smaller blocks find more that is sure, but cost more bytes and more tests each.
constexpr int kBlock = 4;

// Sets `blocks` and `depth`.
void find_single_blocks(IndicatorField& field, const Run& run);

}  // namespace cleft
