// What improving must not change: the topology of every material and which materials touch.
#pragma once

#include "mesh/adjacency.hpp"
#include "support/parts.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace cleft_test
{

struct Topology {
    std::vector<int64_t> euler;                         // of each material, as a closed set of tetrahedra
    std::vector<size_t> parts;                          // of each material, joined by faces
    std::vector<std::array<cleft::Material, 2>> pairs;  // that share a face, ascending

    bool operator==(const Topology& other) const
    {
        return euler == other.euler && parts == other.parts && pairs == other.pairs;
    }
};

// Vertices, edges and faces of the tetrahedra of one material, each once, padded with -1.
inline int64_t count_simplices(const cleft::LabelledMesh& mesh, cleft::Material material, unsigned corners)
{
    std::vector<std::array<int32_t, 3>> simplices;
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        if (mesh.material[t] != material)
            continue;
        for (unsigned subset = 1; subset < 15; ++subset) {
            std::array<int32_t, 3> simplex{-1, -1, -1};
            unsigned count = 0;
            for (unsigned i = 0; i < 4; ++i)
                if (subset >> i & 1u) {
                    if (count < corners)
                        simplex[count] = mesh.tets[t][i];
                    ++count;
                }
            if (count != corners)
                continue;
            std::sort(simplex.begin(), simplex.end());
            simplices.push_back(simplex);
        }
    }
    std::sort(simplices.begin(), simplices.end());
    return std::unique(simplices.begin(), simplices.end()) - simplices.begin();
}

inline Topology topology_of(const cleft::LabelledMesh& mesh, cleft::Material materials)
{
    Topology topology;
    for (cleft::Material m = 0; m < materials; ++m)
        topology.euler.push_back(count_simplices(mesh, m, 1) - count_simplices(mesh, m, 2) +
                                 count_simplices(mesh, m, 3) -
                                 std::count(mesh.material.begin(), mesh.material.end(), m));
    for (const auto& parts : material_parts(mesh, materials))
        topology.parts.push_back(parts.size());
    const auto neighbours = cleft::tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (const int32_t n : neighbours[t])
            if (n >= 0 && mesh.material[t] < mesh.material[static_cast<size_t>(n)])
                topology.pairs.push_back({mesh.material[t], mesh.material[static_cast<size_t>(n)]});
    std::sort(topology.pairs.begin(), topology.pairs.end());
    topology.pairs.erase(std::unique(topology.pairs.begin(), topology.pairs.end()), topology.pairs.end());
    return topology;
}

}  // namespace cleft_test
