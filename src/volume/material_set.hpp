// The materials that meet at a vertex of the background.
#pragma once

#include "mesh/tet_mesh.hpp"

#include <algorithm>
#include <cstdint>
#include <optional>

namespace cleft
{

// A vertex away from interfaces carries one material; a vertex that snapped onto an interface carries all that meet
// there. Ascending, inline (half a cache line), at most kCapacity: noise brings ten or more materials together.
class MaterialSet
{
public:
    static constexpr int kCapacity = 15;

    MaterialSet() = default;
    explicit MaterialSet(Material m) : count_(1)
    {
        CLEFT_ASSERT(m >= 0 && m < UINT16_MAX);
        item_[0] = static_cast<uint16_t>(m);
    }

    int size() const { return count_; }
    Material operator[](int i) const
    {
        CLEFT_ASSERT(i >= 0 && i < count_);
        return item_[i];
    }
    const uint16_t* begin() const { return item_; }
    const uint16_t* end() const { return item_ + count_; }

    // False, and this set unchanged, if the union would not fit.
    bool unite(const MaterialSet& other)
    {
        uint16_t both[2 * kCapacity];
        // Both are sorted, so equal sets are equal arrays: the order in which a vertex collected its materials does not
        // show.
        const uint16_t* last = std::set_union(begin(), end(), other.begin(), other.end(), both);
        if (last - both > kCapacity)
            return false;
        count_ = static_cast<uint16_t>(last - both);
        std::copy(static_cast<const uint16_t*>(both), last, item_);
        return true;
    }

    friend bool operator==(const MaterialSet& a, const MaterialSet& b)
    {
        return std::equal(a.begin(), a.end(), b.begin(), b.end());
    }

private:
    uint16_t count_ = 0;
    uint16_t item_[kCapacity] = {};
};

static_assert(sizeof(MaterialSet) == 32, "one set a vertex of the background: keep it small");

// Of some tetrahedra of a mesh. None if they are too many.
inline std::optional<MaterialSet> materials_of(const Array<int32_t>& tets, const Array<Material>& material)
{
    MaterialSet set;
    for (const int32_t t : tets)
        if (!set.unite(MaterialSet(material[t])))
            return std::nullopt;
    return set;
}

inline bool disjoint(const MaterialSet& a, const MaterialSet& b)
{
    const uint16_t *i = a.begin(), *j = b.begin();
    while (i != a.end() && j != b.end()) {
        if (*i == *j)
            return false;
        *i < *j ? ++i : ++j;
    }
    return true;
}

}  // namespace cleft
