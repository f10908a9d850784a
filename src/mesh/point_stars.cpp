// Keeps the tetrahedra at each point in one pool of memory, so that a mesh of millions of points takes few allocations.
#include "mesh/point_stars.hpp"

#include "base/counting_sort.hpp"
#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "mesh/face_buckets.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Points whose lists a thread sets up at once. The number changes the time alone.
constexpr int64_t kPointsListed = 1 << 14;

void require_four_points(const Array<Tet>& tets, int64_t t, int64_t point_count)
{
    if (has_bad_index(tets[t], point_count) || has_repeated_corner(tets[t]))
        throw Error(CLEFT_ERROR_INVALID_MESH,
                    "the " + ordinal(t) + " tetrahedron does not have four different points of the mesh");
}

}  // namespace

PointStars::PointStars(const Array<Tet>& tets, size_t point_count, const Run& run) : rooms_(to_size(worker_count(run)))
{
    // Four numbers a tetrahedron: below this many, 32 bits count them, and the tables take half the memory.
    constexpr size_t kFew = size_t{1} << 30;
    if (tets.size() < kFew)
        fill<uint32_t>(tets, point_count, run);
    else
        fill<size_t>(tets, point_count, run);
}

template <class Number>
void PointStars::fill(const Array<Tet>& tets, size_t point_count, const Run& run)
{
    const auto points = static_cast<int64_t>(point_count);
    Groups<Number, int32_t> stars =
        group_by_key<Number, int32_t>(run, tets.count(), points, [&](int64_t t, const auto& give) {
            require_four_points(tets, t, points);
            for (const int32_t v : tets[t])
                give(v, static_cast<int32_t>(t));
        });
    pool_ = std::move(stars.values);
    lists_ = array_with_room<List>(run, point_count);
    parallel_for(run, points, kPointsListed, [&](int64_t begin, int64_t end) {
        for (int64_t v = begin; v < end; ++v) {
            const auto size = static_cast<uint32_t>(stars.start[v + 1] - stars.start[v]);
            lists_[v] = {pool_.data() + stars.start[v], size, size};
        }
    });
}

int32_t* PointStars::Room::take(size_t count)
{
    // Large enough that allocations do not show, small enough that a mesh with few changes wastes little.
    constexpr size_t kBlock = size_t{1} << 14;
    if (left < count) {
        const size_t size = std::max(kBlock, count);
        // Owned before the list grows: that may fail.
        std::unique_ptr<int32_t[]> block(new int32_t[size]);
        blocks.push_back(std::move(block));
        next = blocks.back().get();
        left = size;
    }
    int32_t* const first = next;
    next += count;
    left -= count;
    return first;
}

// A list that is full moves to a place with room to grow. The old place stays unused, which costs little: local
// operations touch a small part of a mesh.
void PointStars::add(int32_t v, int32_t t, int worker)
{
    List& list = lists_[v];
    if (list.size == list.capacity) {
        // Growing by half makes the cost of an addition constant on average.
        list.capacity += std::max<uint32_t>(8, list.capacity / 2);
        int32_t* const first = rooms_[to_size(worker)].take(list.capacity);
        std::copy_n(list.first, list.size, first);
        list.first = first;
    }
    list.first[list.size++] = t;
}

void PointStars::remove(int32_t v, int32_t t)
{
    List& list = lists_[v];
    int32_t* const last = list.first + list.size;
    int32_t* const found = std::find(list.first, last, t);
    CLEFT_ASSERT(found != last);
    if (found == last)
        return;
    // The order of the list changes here. It follows from the operations made, so it is the same in every run.
    *found = last[-1];
    --list.size;
}

}  // namespace cleft
