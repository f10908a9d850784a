// Every face of every tetrahedron, grouped by its three points.
#pragma once

#include "mesh/adjacency.hpp"

#include <algorithm>
#include <vector>

namespace cleft
{

// A face as one tetrahedron sees it: `id` is 4 * tetrahedron + the corner opposite.
struct HalfFace {
    uint64_t middle_and_greatest;  // of its points
    uint32_t id;

    int32_t tet() const { return static_cast<int32_t>(id >> 2); }
    int corner() const { return static_cast<int>(id & 3); }
    bool operator<(const HalfFace& other) const
    {
        return middle_and_greatest != other.middle_and_greatest ? middle_and_greatest < other.middle_and_greatest
                                                                : id < other.id;
    }
};

inline bool has_bad_index(const Tet& tet, int64_t point_count)
{
    return std::any_of(tet.begin(), tet.end(), [&](int32_t p) { return p < 0 || p >= point_count; });
}

inline bool has_repeated_corner(const Tet& t)
{
    return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

// The points of the face of a half-face, in the order of kFaceCorners.
inline std::array<int32_t, 3> face_points(const std::vector<Tet>& tets, uint32_t id)
{
    const Tet& tet = tets[id >> 2];
    const int* f = kFaceCorners[id & 3];
    return {tet[static_cast<size_t>(f[0])], tet[static_cast<size_t>(f[1])], tet[static_cast<size_t>(f[2])]};
}

// Half-faces in buckets by their least point (a counting sort, linear); the few of a bucket are sorted when it is
// visited. 16 bytes a tetrahedron and 4 a point. Tetrahedra with a bad index are left out.
class FaceBuckets
{
public:
    // Throws CLEFT_ERROR_TOO_LARGE past 2^30 tetrahedra: four times their number must fit 32 bits.
    FaceBuckets(const std::vector<Tet>& tets, int64_t point_count);

    // visit(const HalfFace* faces, size_t count) for each different face whose least point is in [begin, end), in
    // ascending order of its points; its half-faces are in ascending order of tetrahedra.
    template <class Visit>
    void for_each_face(int64_t begin, int64_t end, const Visit& visit) const
    {
        std::vector<HalfFace> bucket;
        for (int64_t point = begin; point < end; ++point) {
            fill(point, bucket);
            for (size_t first = 0, last = 0; first < bucket.size(); first = last) {
                while (last < bucket.size() && bucket[last].middle_and_greatest == bucket[first].middle_and_greatest)
                    ++last;
                visit(bucket.data() + first, last - first);
            }
        }
    }

private:
    void fill(int64_t point, std::vector<HalfFace>& bucket) const;

    const std::vector<Tet>& tets_;
    std::vector<uint32_t> start_;
    std::vector<uint32_t> ids_;
};

}  // namespace cleft
