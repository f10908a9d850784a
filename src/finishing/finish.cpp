// Counts, and the sentence.
#include "finishing/finish.hpp"

#include "base/error.hpp"

#include <algorithm>

namespace cleft
{

int64_t kept_tets(const LabelledMesh& mesh, const KeptMaterials& kept)
{
    return std::count_if(mesh.material.begin(), mesh.material.end(), [&](Material m) { return kept.has(m); });
}

void require_kept(int64_t kept_tets)
{
    if (kept_tets == 0)
        throw Error(CLEFT_ERROR_LABEL_LOST,
                    "none of the labels that are kept has a tetrahedron; a smaller size would keep them");
}

}  // namespace cleft
