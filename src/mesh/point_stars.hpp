// Which tetrahedra are at each point, in lists that may change.
#pragma once

#include "base/large_pages.hpp"
#include "base/run.hpp"
#include "mesh/tet_mesh.hpp"

#include <memory>
#include <vector>

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
    // As many workers as the run has threads may change lists side by side, if no two change that of the same point.
    PointStars(const Array<Tet>& tets, size_t point_count, const Run& run);

    // The tetrahedra at a point. Valid until the next change.
    Range at(int32_t v) const
    {
        const List& list = lists_[v];
        return {list.first, list.first + list.size};
    }

    // For a point with the next number, without tetrahedra.
    void add_point()
    {
        make_room(lists_);
        lists_.push_back({nullptr, 0, 0});
    }
    // Either call ends the life of all ranges. `t` must not be in the list before add(), and must be before remove().
    void add(int32_t v, int32_t t, int worker = 0);
    void remove(int32_t v, int32_t t);

private:
    struct List {
        int32_t* first;
        uint32_t size, capacity;
    };
    // Room of one worker for lists that grow.
    struct Room {
        std::vector<std::unique_ptr<int32_t[]>> blocks;
        int32_t* next = nullptr;
        size_t left = 0;  // at `next`

        int32_t* take(size_t count);
    };

    template <class Number>
    void fill(const Array<Tet>& tets, size_t point_count, const Run& run);

    Array<List> lists_;
    Array<int32_t> pool_;  // the lists as they began
    std::vector<Room> rooms_;
};

}  // namespace cleft
