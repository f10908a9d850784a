// Which materials a user wants of the finished mesh.
#pragma once

#include "base/array.hpp"
#include "mesh/tet_mesh.hpp"

#include <algorithm>

namespace cleft
{

class KeptMaterials
{
public:
    // All of them.
    KeptMaterials() = default;
    // Those m with is_kept[m] != 0.
    explicit KeptMaterials(Array<char> is_kept) : is_kept_(std::move(is_kept))
    {
        // Stages skip their tests where all are kept, so lists that leave nothing out cost nothing.
        if (std::find(is_kept_.begin(), is_kept_.end(), 0) == is_kept_.end())
            is_kept_.clear();
    }

    bool all() const { return is_kept_.empty(); }
    bool has(Material m) const { return all() || is_kept_[m] != 0; }

private:
    Array<char> is_kept_;  // empty: all are
};

}  // namespace cleft
