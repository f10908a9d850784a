// Finds the points of hull and interfaces in one pass over the tetrahedra, without a table of faces.
#include "mesh/surface_points.hpp"

#include "base/counting_sort.hpp"
#include "mesh/face_buckets.hpp"

namespace cleft
{

namespace
{

// The mixing of splitmix64 (Steele, Lea and Flood, 2014).
uint64_t mix(uint64_t x)
{
    x = (x + 0x9e3779b97f4a7c15) * 0xbf58476d1ce4e5b9;
    x = (x ^ x >> 30) * 0x94d049bb133111eb;
    return x ^ x >> 31;
}

// Adds, by exclusive or, numbers of the three faces at each corner.
void add_faces(const Tet& tet, uint64_t of_region, Array<uint64_t>& sum)
{
    std::array<uint64_t, 4> number;
    uint64_t all = of_region;
    for (size_t i = 0; i < 4; ++i) {
        number[i] = mix(static_cast<uint64_t>(tet[i]));
        all += number[i];
    }
    uint64_t faces = 0;
    for (uint64_t& n : number) {
        // The number comes from a sum, so both tetrahedra of a face get the same one in whatever order they name its
        // points.
        n = mix(all - n);  // of the face opposite
        faces ^= n;
    }
    for (size_t i = 0; i < 4; ++i)
        sum[tet[i]] ^= faces ^ number[i];
}

// What a face adds at its corners it adds twice inside, if of_region(tetrahedron) is the same on both sides: nothing in
// all. (Numbers of 64 bits mixed well: that others cancel by chance is not to be expected in any mesh that fits a
// computer.) By point: 1 if nothing is left. Each thread has a sum of its own; in which order they are added makes no
// difference.
template <class OfRegion>
Array<uint8_t> points_where_faces_cancel(const Array<Tet>& tets, int64_t point_count, const OfRegion& of_region,
                                         const Run& run)
{
    constexpr int64_t kPointsAtOnce = 1 << 14;
    const int64_t grain = items_of_part(run, tets.count(), point_count);
    Array<Array<uint64_t>> sums(chunk_count(tets.count(), grain));
    parallel_chunks(run, tets.count(), grain, [&](int64_t part, int64_t begin, int64_t end) {
        sums[part] = large_array(point_count, uint64_t{0});
        for (int64_t t = begin; t < end; ++t) {
            run.check_at(t);
            if (!has_bad_index(tets[t], point_count))
                add_faces(tets[t], of_region(t), sums[part]);
        }
    });
    Array<uint8_t> cancel(point_count);
    parallel_for(run, point_count, kPointsAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t p = begin; p < end; ++p) {
            uint64_t all = 0;
            for (const Array<uint64_t>& sum : sums)
                all ^= sum[p];
            cancel[p] = all == 0;
        }
    });
    return cancel;
}

}  // namespace

Array<uint8_t> points_inside(const Array<Tet>& tets, size_t point_count, const Run& run)
{
    return points_where_faces_cancel(
        tets, static_cast<int64_t>(point_count), [](int64_t) { return uint64_t{0}; }, run);
}

Array<uint8_t> surface_points(const RegionMesh& mesh, const Run& run)
{
    const auto of_region = [&](int64_t t) { return mix(static_cast<uint64_t>(mesh.region[t])); };
    Array<uint8_t> points = points_where_faces_cancel(mesh.tets, mesh.points.count(), of_region, run);
    for (uint8_t& is_on_surface : points)
        is_on_surface = is_on_surface == 0;
    return points;
}

}  // namespace cleft
