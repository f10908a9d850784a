// The connected parts of a mesh, by material.
#pragma once

#include "mesh/materials.hpp"
#include "mesh/quality.hpp"

#include <algorithm>
#include <functional>

namespace cleft_test
{

// The volumes of the parts of each material, falling.
inline std::vector<std::vector<double>> material_parts(const cleft::LabelledMesh& mesh, cleft::Material material_count)
{
    const std::vector<int32_t> part = cleft::mesh_parts(mesh, cleft::Run()).of_tet;
    std::vector<double> volume(part.size(), 0.0);  // of a part, at its least tetrahedron
    for (size_t t = 0; t < part.size(); ++t) {
        const auto corner = [&](size_t i) { return mesh.points[static_cast<size_t>(mesh.tets[t][i])]; };
        volume[static_cast<size_t>(part[t])] += cleft::orient(corner(0), corner(1), corner(2), corner(3)) / 6;
    }
    std::vector<std::vector<double>> parts(static_cast<size_t>(material_count));
    for (size_t t = 0; t < part.size(); ++t)
        if (part[t] == static_cast<int32_t>(t))
            parts[static_cast<size_t>(mesh.material[t])].push_back(volume[t]);
    for (std::vector<double>& volumes : parts)
        std::sort(volumes.begin(), volumes.end(), std::greater<>());
    return parts;
}

}  // namespace cleft_test
