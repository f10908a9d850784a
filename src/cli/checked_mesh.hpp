// A mesh that was validated.
#pragma once

#include "findings.hpp"

#include <string>

namespace cleft_cli
{

struct CheckedMesh {
    cleft_validation validation{};
    std::string fault;  // the sentence of the first; "" for a valid mesh
    MeshFindings found;

    bool valid() const { return validation.valid != 0; }
};

// Throws Failure where it cannot be told whether the mesh is valid.
CheckedMesh check_mesh(const Session& session, const cleft_mesh* mesh, bool fills_box);

}  // namespace cleft_cli
