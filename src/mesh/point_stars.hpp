// Which tetrahedra are at each point, in lists that may change.
#pragma once

#include "base/large_pages.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

namespace cleft
{

// Cheaper to make than face neighbours (one counting sort), and all that a local operation asks of a mesh.
class PointStars
{
public:
    struct Range {
        const int32_t *first, *last;
        const int32_t* begin() const { return first; }
        const int32_t* end() const { return last; }
        int64_t size() const { return last - first; }
        bool empty() const { return first == last; }
    };

    // Corners that are not points, or repeated, are an Error (CLEFT_ERROR_INVALID_MESH).
    PointStars(const Array<Tet>& tets, size_t point_count, const Run& run);

    // The tetrahedra at a point. Valid until the next change.
    Range at(int32_t v) const
    {
        const List& list = lists_[v];
        const int32_t* first = pool_.data() + list.begin;
        return {first, first + list.size};
    }

    // For a point with the next number, without tetrahedra.
    void add_point()
    {
        make_room(lists_);
        lists_.push_back({pool_.size(), 0, 0});
    }
    // Either call ends the life of all ranges. `t` must not be in the list before add(), and must be before remove().
    void add(int32_t v, int32_t t);
    void remove(int32_t v, int32_t t);

private:
    struct List {
        size_t begin;
        uint32_t size, capacity;
    };

    template <class Number>
    void fill(const Array<Tet>& tets, size_t point_count, const Run& run);

    Array<List> lists_;
    Array<int32_t> pool_;
};

}  // namespace cleft
