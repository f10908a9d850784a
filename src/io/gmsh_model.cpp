#include "io/gmsh_model.hpp"

#include <algorithm>

namespace cleft::io
{

std::vector<int32_t> gmsh_volume_numbers(const MeshView& mesh)
{
    std::vector<int32_t> numbers = mesh.labels;
    int32_t next = 1;
    for (int32_t& number : numbers) {
        if (number > 0)
            break;  // labels ascend
        while (std::binary_search(mesh.labels.begin(), mesh.labels.end(), next))
            ++next;
        number = next++;
    }
    return numbers;
}

void write_physical_names(const MeshView& mesh, const std::vector<int32_t>& volumes, AtomicFile& file)
{
    file.print("$PhysicalNames\n", mesh.groups.size() + volumes.size(), '\n');
    for (size_t g = 0; g < mesh.groups.size(); ++g)
        file.print("2 ", g + 1, " \"", mesh.groups[g].name, "\"\n");
    for (size_t v = 0; v < volumes.size(); ++v)
        file.print("3 ", volumes[v], " \"", material_name(mesh.labels[v]), "\"\n");
    file.print("$EndPhysicalNames\n");
}

}  // namespace cleft::io
