#include "mesh/face_buckets.hpp"

#include "base/error.hpp"

namespace cleft
{

namespace
{

constexpr size_t kMostTets = size_t{1} << 30;

// The least point of the face opposite each corner.
std::array<int32_t, 4> least_points(const Tet& t)
{
    const int32_t first = std::min(t[0], t[1]);
    const int32_t last = std::min(t[2], t[3]);
    return {std::min(t[1], last), std::min(t[0], last), std::min(first, t[3]), std::min(first, t[2])};
}

HalfFace half_face(const std::vector<Tet>& tets, uint32_t id)
{
    const auto [a, b, c] = face_points(tets, id);
    const int32_t middle = std::max(std::min(a, b), std::min(std::max(a, b), c));
    const int32_t greatest = std::max(std::max(a, b), c);
    return {static_cast<uint64_t>(middle) << 32 | static_cast<uint64_t>(greatest), id};
}

}  // namespace

FaceBuckets::FaceBuckets(const std::vector<Tet>& tets, int64_t point_count)
    : tets_(tets), start_(static_cast<size_t>(point_count) + 1, 0)
{
    if (tets.size() >= kMostTets)
        throw Error(CLEFT_ERROR_TOO_LARGE, "a mesh of 2^30 or more tetrahedra is too large for 32-bit face numbers");
    uint32_t total = 0;
    for (const Tet& tet : tets) {
        if (has_bad_index(tet, point_count))
            continue;
        for (const int32_t p : least_points(tet))
            ++start_[static_cast<size_t>(p)];
        total += 4;
    }
    // Counts become ends; the filling below, from the last face to the first, turns the ends into starts.
    uint32_t end = 0;
    for (uint32_t& s : start_)
        s = end += s;
    ids_.resize(total);
    for (size_t t = tets.size(); t-- > 0;) {
        if (has_bad_index(tets[t], point_count))
            continue;
        const std::array<int32_t, 4> least = least_points(tets[t]);
        for (uint32_t i = 4; i-- > 0;)
            ids_[--start_[static_cast<size_t>(least[i])]] = static_cast<uint32_t>(t) * 4 + i;
    }
}

void FaceBuckets::fill(int64_t point, std::vector<HalfFace>& bucket) const
{
    const auto p = static_cast<size_t>(point);
    bucket.clear();
    for (uint32_t k = start_[p]; k < start_[p + 1]; ++k)
        bucket.push_back(half_face(tets_, ids_[k]));
    std::sort(bucket.begin(), bucket.end());
}

}  // namespace cleft
