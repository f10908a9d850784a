// The names of physical groups, for both Gmsh formats.
#include "io/gmsh_model.hpp"

namespace cleft::io
{

void write_physical_names(const MeshView& mesh, AtomicFile& file)
{
    file.print("$PhysicalNames\n", mesh.groups.size() + mesh.labels.size(), '\n');
    for (const SurfaceGroup& group : mesh.groups)
        file.print("2 ", group.number, " \"", group.name, "\"\n");
    // Gmsh takes names of up to 127 characters; material() keeps to 40 of the user's.
    for (size_t v = 0; v < mesh.labels.size(); ++v)
        file.print("3 ", mesh.volume_numbers[v], " \"", mesh.material(v), "\"\n");
    file.print("$EndPhysicalNames\n");
}

}  // namespace cleft::io
