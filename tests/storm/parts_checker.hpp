// A checker of meshes in parts: ranks, which are threads here, make the mesh of a case again, and must have the same.
#pragma once

#include "storm/random_case.hpp"

#include <string>

namespace storm
{

// What cleft_mesh_volume() made of the case: a mesh, or a status with a sentence.
struct WholeMesh {
    cleft_status status = CLEFT_OK;
    std::string sentence;
    const cleft_mesh* mesh = nullptr;
};

// "" if the ranks of the case make the same, else the first difference in one sentence.
std::string fault_of_parts(const Case& drawn, const cleft_options* options, const WholeMesh& whole);

}  // namespace storm
