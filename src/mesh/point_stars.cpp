// Keeps the tetrahedra at each point in one pool of memory, so that a mesh of millions of points takes two allocations.
#include "mesh/point_stars.hpp"

#include "base/error.hpp"
#include "base/large_pages.hpp"
#include "base/ordinal.hpp"
#include "mesh/face_buckets.hpp"

#include <algorithm>

namespace cleft
{

PointStars::PointStars(const Array<Tet>& tets, size_t point_count, const Run& run)
    : lists_(large_array(point_count, List{0, 0, 0})), pool_(large_array<int32_t>(4 * tets.size()))
{
    for (size_t t = 0; t < tets.size(); ++t) {
        run.check_at(t);
        if (has_bad_index(tets[t], static_cast<int64_t>(point_count)) || has_repeated_corner(tets[t]))
            throw Error(CLEFT_ERROR_INVALID_MESH, "the " + ordinal(static_cast<int64_t>(t)) +
                                                      " tetrahedron does not have four different points of the mesh");
        for (const int32_t v : tets[t])
            ++lists_[v].capacity;
    }
    size_t begin = 0;
    for (List& list : lists_) {
        list.begin = begin;
        begin += list.capacity;
    }
    for (size_t t = 0; t < tets.size(); ++t) {
        run.check_at(t);
        for (const int32_t v : tets[t]) {
            List& list = lists_[v];
            pool_[list.begin + list.size++] = static_cast<int32_t>(t);
        }
    }
}

// A list that is full moves to the end of the pool, with room to grow.
void PointStars::add(int32_t v, int32_t t)
{
    List& list = lists_[v];
    if (list.size == list.capacity) {
        const size_t end = pool_.size();
        // Growing by half makes the cost of an addition constant on average. The old place stays unused, which costs
        // little: local operations touch a small part of a mesh.
        list.capacity += std::max<uint32_t>(8, list.capacity / 2);
        pool_.resize(end + list.capacity);
        std::copy_n(pool_.begin() + static_cast<std::ptrdiff_t>(list.begin), list.size,
                    pool_.begin() + static_cast<std::ptrdiff_t>(end));
        list.begin = end;
    }
    pool_[list.begin + list.size++] = t;
}

void PointStars::remove(int32_t v, int32_t t)
{
    List& list = lists_[v];
    int32_t* first = pool_.data() + list.begin;
    int32_t* last = first + list.size;
    int32_t* found = std::find(first, last, t);
    CLEFT_ASSERT(found != last);
    if (found == last)
        return;
    // The order of the list changes here. It follows from the operations made, so it is the same in every run.
    *found = last[-1];
    --list.size;
}

}  // namespace cleft
