// Where an interface of two materials is no manifold.
#pragma once

#include "mesh/adjacency.hpp"

#include <algorithm>
#include <array>
#include <vector>

namespace cleft_test
{

// Edges at which two materials alone meet, and meet in more than the two faces of a surface (on the hull: in more than
// one).
inline int64_t count_pinched_edges(const cleft::LabelledMesh& mesh)
{
    struct Use {
        std::array<int32_t, 2> edge;
        cleft::Material low, high;  // of an interface face; -1, -1: of a hull face
        bool operator<(const Use& other) const { return edge < other.edge; }
    };
    const auto neighbours = cleft::tet_neighbours(mesh.tets, static_cast<int64_t>(mesh.points.size()));
    std::vector<Use> uses;
    for (size_t t = 0; t < mesh.tets.size(); ++t)
        for (size_t i = 0; i < 4; ++i) {
            const int32_t n = neighbours[t][i];
            const cleft::Material own = mesh.material[t], other = n < 0 ? -1 : mesh.material[static_cast<size_t>(n)];
            if (own == other || (n >= 0 && own > other))
                continue;
            for (size_t k = 0; k < 3; ++k) {
                const int32_t a = mesh.tets[t][static_cast<size_t>(cleft::kFaceCorners[i][k])];
                const int32_t b = mesh.tets[t][static_cast<size_t>(cleft::kFaceCorners[i][(k + 1) % 3])];
                uses.push_back({{std::min(a, b), std::max(a, b)}, n < 0 ? -1 : own, other});
            }
        }
    std::sort(uses.begin(), uses.end());
    int64_t pinched = 0;
    for (auto first = uses.begin(); first != uses.end();) {
        const auto last = std::upper_bound(first, uses.end(), *first);
        int faces = 0;
        bool on_hull = false;
        std::vector<cleft::Material> materials;
        for (auto use = first; use != last; ++use) {
            on_hull = on_hull || use->high < 0;
            if (use->high < 0)
                continue;
            ++faces;
            materials.push_back(use->low);
            materials.push_back(use->high);
        }
        std::sort(materials.begin(), materials.end());
        materials.erase(std::unique(materials.begin(), materials.end()), materials.end());
        pinched += materials.size() == 2 && faces > (on_hull ? 1 : 2);
        first = last;
    }
    return pinched;
}

}  // namespace cleft_test
