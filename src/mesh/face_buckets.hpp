// Every face of every tetrahedron, grouped by its three points.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "mesh/adjacency.hpp"

#include <algorithm>

namespace cleft
{

// Of one mesh, so that its half-faces have numbers of 32 bits.
inline constexpr int64_t kMostTetsOfMesh = (int64_t{1} << 30) - 1;

// A face as one tetrahedron sees it: `id` is 4 * tetrahedron + the corner opposite.
struct HalfFace {
    uint32_t id;

    int32_t tet() const { return static_cast<int32_t>(id >> 2); }
    int corner() const { return static_cast<int>(id & 3); }
};

inline bool has_bad_index(const Tet& tet, int64_t point_count)
{
    // Without a branch at each point: this is asked of every tetrahedron of a mesh, again and again. A negative number
    // is a great one without its sign.
    bool is_bad = false;
    for (const int32_t p : tet)
        is_bad |= static_cast<uint64_t>(p) >= static_cast<uint64_t>(point_count);
    return is_bad;
}

inline bool has_repeated_corner(const Tet& t)
{
    return t[0] == t[1] || t[0] == t[2] || t[0] == t[3] || t[1] == t[2] || t[1] == t[3] || t[2] == t[3];
}

// The points of the face of a half-face, in the order of kFaceCorners.
inline std::array<int32_t, 3> face_points(const Array<Tet>& tets, uint32_t id)
{
    const Tet& tet = tets[id >> 2];
    const int* f = kFaceCorners[id & 3];
    return {tet[f[0]], tet[f[1]], tet[f[2]]};
}

// Half-faces in buckets by their least point (a counting sort), and in each bucket by their other points (a small hash
// table, when it is visited): linear time. 16 bytes a tetrahedron and 4 a point. Tetrahedra with a bad index are left
// out.
class FaceBuckets
{
public:
    // The number is fixed: sums of callers are taken chunk by chunk, and would differ in the last digits with another
    // one.
    static constexpr int64_t kPointsAtOnce = 2048;  // whose faces a thread looks at

    // More than kMostTetsOfMesh are CLEFT_ERROR_TOO_LARGE.
    // With `among`, by point, only faces all of whose points are marked there; these then are found much sooner.
    // Borrows `tets`, which must not change while the buckets are in use.
    FaceBuckets(const Array<Tet>& tets, int64_t point_count, const Run& run, const Array<uint8_t>* among = nullptr);

    // visit(const HalfFace* faces, size_t count) for each different face whose least point is in [begin, end), in an
    // order that depends on the mesh alone: least points ascend, and so do the tetrahedra of one face.
    template <class Visit>
    void for_each_face(int64_t begin, int64_t end, const Visit& visit) const
    {
        Bucket bucket;
        Array<HalfFace> face;
        for (int64_t point = begin; point < end; ++point) {
            load(point, bucket);
            for (int32_t i : bucket.first_of_face) {
                face.clear();
                for (; i >= 0; i = bucket.entries[i].next)
                    face.push_back(bucket.entries[i].face);
                visit(face.data(), face.size());
            }
        }
    }

private:
    // The half-faces of one bucket; those of one face make a chain.
    struct Bucket {
        struct Entry {
            uint64_t other_points;
            HalfFace face;
            int32_t next;
        };
        Array<Entry> entries;
        Array<int32_t> first_of_face;
        Array<int32_t> last_of_face;  // the hash table, by other_points
    };

    void load(int64_t point, Bucket& bucket) const;

    const Array<Tet>& tets_;
    Array<uint32_t> start_;
    Array<uint32_t> ids_;
};

}  // namespace cleft
