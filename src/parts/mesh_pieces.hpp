// A mesh that a rank has in pieces, which need not be in memory together.
#pragma once

#include "mesh/tet_mesh.hpp"

#include <functional>
#include <memory>

namespace cleft
{

// Each tetrahedron is in one piece. Points where pieces meet are in each of them, with the same coordinates.
struct MeshPieces {
    int32_t count = 0;
    // A piece is there until two others were asked for.
    std::function<const LabelledMesh&(int32_t piece)> read;
    // The same to change it. Who needs it no more may empty it.
    std::function<LabelledMesh&(int32_t piece)> at;

    static MeshPieces of(LabelledMesh whole)
    {
        const auto kept = std::make_shared<LabelledMesh>(std::move(whole));
        return {1, [kept](int32_t) -> const LabelledMesh& { return *kept; },
                [kept](int32_t) -> LabelledMesh& { return *kept; }};
    }
};

}  // namespace cleft
