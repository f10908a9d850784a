// Cuts that leave no room for tetrahedra.
#pragma once

#include "cleaving/centres.hpp"

namespace cleft
{

// Gives up cuts of tetrahedra that would otherwise split into pieces of no volume (slivers of the background), the
// least central cut first, until none is left that a smaller number of cuts can mend. Returns the number given up.
// Cuts between vertices that are held stay: a mesh on the other side has them too.
int64_t give_up_flat_cuts(Centres& c, const Array<int32_t>& held, const Run& run);

}  // namespace cleft
