// Groups the half-faces of a mesh by their points, with a counting sort by the least point and a hash table by the
// others.
#include "mesh/face_buckets.hpp"

#include "base/counting_sort.hpp"
#include "base/error.hpp"

namespace cleft
{

namespace
{

// The least point of the face opposite each corner.
std::array<int32_t, 4> least_points(const Tet& t)
{
    const int32_t first = std::min(t[0], t[1]);
    const int32_t last = std::min(t[2], t[3]);
    return {std::min(t[1], last), std::min(t[0], last), std::min(first, t[3]), std::min(first, t[2])};
}

// The middle and the greatest point of a face.
uint64_t other_points(const Array<Tet>& tets, uint32_t id)
{
    const auto [a, b, c] = face_points(tets, id);
    const int32_t middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
    const int32_t greatest = std::max(std::max(a, b), c);
    return static_cast<uint64_t>(middle) << 32 | static_cast<uint64_t>(greatest);
}

// give(least point, face) for the faces of a tetrahedron that take part.
template <class Give>
void give_faces(const Array<Tet>& tets, int64_t tet, const Array<uint8_t>* among, const Give& give)
{
    const Tet& corners = tets[tet];
    unsigned marked = 15;
    if (among)
        for (unsigned i = 0; i < 4; ++i)
            if ((*among)[corners[i]] == 0)
                marked &= ~(1U << i);
    const std::array<int32_t, 4> least = least_points(corners);
    for (uint32_t i = 0; i < 4; ++i)
        // Corner i is not a point of the face opposite it, so its mark does not count.
        if ((marked | 1U << i) == 15)
            give(least[i], static_cast<uint32_t>(tet) * 4 + i);
}

}  // namespace

FaceBuckets::FaceBuckets(const Array<Tet>& tets, int64_t point_count, const Run& run, const Array<uint8_t>* among)
    : tets_(tets)
{
    CLEFT_ASSERT(!among || among->count() == point_count);
    if (tets.count() > kMostTetsOfMesh)
        throw Error(CLEFT_ERROR_TOO_LARGE, "a mesh of " + std::to_string(tets.count()) +
                                               " tetrahedra is too large: it may have at most " +
                                               std::to_string(kMostTetsOfMesh));
    Groups<uint32_t, uint32_t> faces =
        group_by_key<uint32_t, uint32_t>(run, tets.count(), point_count, [&](int64_t t, const auto& give) {
            if (!has_bad_index(tets[t], point_count))
                give_faces(tets, t, among, give);
        });
    start_ = std::move(faces.start);
    ids_ = std::move(faces.values);
}

void FaceBuckets::load(int64_t point, Bucket& bucket) const
{
    const uint32_t begin = start_[point], end = start_[point + 1];
    // A table at least twice as large as the bucket keeps searches short. It has at least one bit, because the shift
    // below by 64 would be undefined.
    int bits = 1;
    while ((uint64_t{1} << bits) < 2 * uint64_t{end - begin})
        ++bits;
    const uint64_t mask = (uint64_t{1} << bits) - 1;
    bucket.entries.clear();
    bucket.first_of_face.clear();
    bucket.last_of_face.assign(mask + 1, -1);
    for (uint32_t k = begin; k < end; ++k) {
        const uint64_t key = other_points(tets_, ids_[k]);
        const auto entry = [&](int32_t i) -> Bucket::Entry& { return bucket.entries[i]; };
        // A product with 2^64 over the golden ratio: its upper bits depend on all bits of the key. The table only finds
        // equal keys. Faces are listed in the order of the bucket, so hashing never shows in a result.
        uint64_t slot = key * 0x9e3779b97f4a7c15u >> (64 - bits);
        while (bucket.last_of_face[slot] >= 0 && entry(bucket.last_of_face[slot]).other_points != key)
            slot = (slot + 1) & mask;
        int32_t& last = bucket.last_of_face[slot];
        const auto here = static_cast<int32_t>(bucket.entries.size());
        if (last < 0)
            bucket.first_of_face.push_back(here);
        else
            entry(last).next = here;
        last = here;
        bucket.entries.push_back({key, {ids_[k]}, -1});
    }
}

}  // namespace cleft
