// Finds the points of hull and interfaces in two passes over the tetrahedra, without a table of faces.
#include "mesh/surface_points.hpp"

#include "base/large_pages.hpp"
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

// The exclusive or, at each corner, of numbers of the three faces there.
void add_faces(const Tet& tet, Array<uint64_t>& sum)
{
    std::array<uint64_t, 4> number;
    uint64_t all = 0;
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

}  // namespace

// What a face adds at its corners it adds twice inside: nothing in all. (Numbers of 64 bits mixed well: that others
// cancel by chance is not to be expected in any mesh that fits a computer.)
Array<uint8_t> points_inside(const Array<Tet>& tets, size_t point_count, const Run& run)
{
    Array<uint64_t> sum = large_array(point_count, uint64_t{0});
    for (size_t t = 0; t < tets.size(); ++t) {
        run.check_at(t);
        if (!has_bad_index(tets[t], static_cast<int64_t>(point_count)))
            add_faces(tets[t], sum);
    }
    Array<uint8_t> inside(point_count);
    std::transform(sum.begin(), sum.end(), inside.begin(), [](uint64_t s) { return s == 0; });
    return inside;
}

Array<uint8_t> surface_points(const RegionMesh& mesh, const Run& run)
{
    // Apart from the regions, which may be any number.
    // No value of a region is free to stand for "none met yet".
    enum class Met : uint8_t { none, one, several };
    Array<uint8_t> surface = points_inside(mesh.tets, mesh.points.size(), run);
    Array<Met> met(mesh.points.size(), Met::none);
    Array<int32_t> region(mesh.points.size());  // where one is met
    for (size_t t = 0; t < mesh.tets.size(); ++t) {
        if (has_bad_index(mesh.tets[t], mesh.points.count()))
            continue;
        for (const int32_t p : mesh.tets[t]) {
            if (met[p] == Met::none) {
                met[p] = Met::one;
                region[p] = mesh.region[t];
            } else if (region[p] != mesh.region[t]) {
                met[p] = Met::several;
            }
        }
    }
    for (size_t p = 0; p < surface.size(); ++p)
        surface[p] = surface[p] == 0 || met[p] == Met::several;
    return surface;
}

}  // namespace cleft
