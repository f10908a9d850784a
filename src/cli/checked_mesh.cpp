// Validates a mesh, and holds the validator's counts of faces against the surface.
#include "checked_mesh.hpp"

#include "text.hpp"

namespace cleft_cli
{
namespace
{

// The library is at fault here and not the mesh, so the sentence says so.
std::string count_fault(const char* what, int64_t faces, const std::optional<int64_t>& triangles)
{
    if (!triangles || *triangles == faces)
        return "";
    return "the mesh has " + plural(faces, "face") + " " + what + ", but its surface has " +
           plural(*triangles, "triangle") + " there: a fault of cleft";
}

// A sentence if the surface of the mesh is not the faces that the validator counted; else "".
std::string surface_fault(const cleft_validation& validation, const MeshFindings& found)
{
    const std::string fault =
        count_fault("between different labels", validation.interface_triangles, found.interface_triangles);
    return fault.empty() ? count_fault("on its hull", validation.hull_triangles, found.hull_triangles) : fault;
}

}  // namespace

CheckedMesh check_mesh(const Session& session, const cleft_mesh* mesh, bool fills_box)
{
    CheckedMesh checked;
    checked.validation.struct_size = sizeof checked.validation;
    session.check(cleft_mesh_validate(session.context(), mesh, fills_box ? 1 : 0, &checked.validation),
                  EXIT_MESHING_FAILED);
    // The sentence of the first fault is left on the context, which the next call of the library forgets.
    if (!checked.valid())
        checked.fault = cleft_context_last_error(session.context());
    checked.found = look_at_mesh(session, mesh);
    // A second opinion: the validator and the surface count the same faces by code of their own.
    if (checked.valid()) {
        checked.fault = surface_fault(checked.validation, checked.found);
        checked.validation.valid = checked.fault.empty() ? 1 : 0;
    }
    return checked;
}

}  // namespace cleft_cli
