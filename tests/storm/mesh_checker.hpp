// A checker of finished meshes that shares no code with the library's own validation: what it accepts, a solver can
// use.
#pragma once

#include "cleft/cleft.h"

#include <array>
#include <string>
#include <vector>

namespace storm
{

struct Expectation {
    std::array<std::array<double, 3>, 8>
        box;                      // world corners of the volume's box; bit a of the index: far along axis a
    std::vector<int32_t> labels;  // that the volume has
    bool fills_box = true;        // false if labels were left out
};

// "" if the mesh is sound, else the first fault in one sentence.
std::string fault_of(const cleft_mesh* mesh, const Expectation& expected);

}  // namespace storm
