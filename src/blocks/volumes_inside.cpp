// Looks at the voxels in the box of each tetrahedron.
#include "blocks/volumes_inside.hpp"

#include "base/parallel.hpp"
#include "mesh/adjacency.hpp"

#include <cmath>

namespace cleft
{

namespace
{

// A place in a voxel, in voxels from its least corner. Where a mesh was cut out along planes of voxels, centres of
// voxels would all lie on one side of the cut, and the volume of a label be off by half a plane. So places are spread
// evenly over the voxel, from neighbour to neighbour, by multiples of irrational numbers (a Kronecker sequence).
Vec3 place_in_voxel(int32_t i, int32_t j, int32_t k)
{
    constexpr double kA = 0.8191725133961645, kB = 0.6710436067037893, kC = 0.5497004779019703;
    const auto spread = [](double x) { return x - std::floor(x); };
    return Vec3(spread(kA * j + kB * k + kC * i), spread(kA * k + kB * i + kC * j), spread(kA * i + kB * j + kC * k));
}

// Tetrahedra that a thread takes. The number changes the time alone.
constexpr int64_t kTetsCovered = 1024;

// The four half spaces that a tetrahedron is, in the frame of the voxels.
struct HalfSpaces {
    Vec3 normal[4];
    double at[4];

    HalfSpaces(const Array<Vec3>& points, const Tet& tet)
    {
        for (int i = 0; i < 4; ++i) {
            const int* face = kFaceCorners[i];
            const Vec3& a = points[tet[face[0]]];
            normal[i] = (points[tet[face[1]]] - a).cross(points[tet[face[2]]] - a);
            at[i] = normal[i].dot(a);
        }
    }
    bool has(const Vec3& x) const
    {
        for (int i = 0; i < 4; ++i)
            if (normal[i].dot(x) > at[i])
                return false;
        return true;
    }
};

class Counter
{
public:
    Counter(const Volume& volume, const Array<Vec3>& points)
        : volume_(volume), grid_(volume.grid()), points_(points), counts_(volume.material_count(), 0)
    {
    }

    void add(const Tet& tet)
    {
        const HalfSpaces inside(points_, tet);
        FixedArray<int32_t, 3> first{}, last{};
        for (int a = 0; a < 3; ++a) {
            double lo = INFINITY, hi = -INFINITY;
            for (const int32_t p : tet) {
                lo = std::min(lo, points_[p][a]);
                hi = std::max(hi, points_[p][a]);
            }
            first[a] = std::max(0, static_cast<int32_t>(std::floor(lo / grid_.spacing[a])));
            last[a] = std::min(grid_.dims[a] - 1, static_cast<int32_t>(std::floor(hi / grid_.spacing[a])));
        }
        for (int32_t k = first[2]; k <= last[2]; ++k)
            for (int32_t j = first[1]; j <= last[1]; ++j)
                for (int32_t i = first[0]; i <= last[0]; ++i)
                    if (inside.has((Vec3(i, j, k) + place_in_voxel(i, j, k)).cwiseProduct(grid_.spacing)))
                        ++counts_[volume_.voxel_material(grid_.index(i, j, k))];
    }

    const Array<int64_t>& counts() const { return counts_; }

private:
    const Volume& volume_;
    const Grid& grid_;
    const Array<Vec3>& points_;
    Array<int64_t> counts_;
};

}  // namespace

Array<double> volumes_inside(const Volume& volume, const LabelledMesh& mesh, const Run& run)
{
    if (!volume.is_label_map())
        return {};
    const double voxel = volume.grid().spacing.prod();
    Array<double> all(volume.material_count(), 0.0);
    Array<Array<int64_t>> of_chunks(chunk_count(mesh.tets.count(), kTetsCovered));
    parallel_chunks(run, mesh.tets.count(), kTetsCovered, [&](int64_t chunk, int64_t begin, int64_t end) {
        Counter counter(volume, mesh.points);
        for (int64_t t = begin; t < end; ++t)
            counter.add(mesh.tets[t]);
        of_chunks[chunk] = counter.counts();
    });
    for (const Array<int64_t>& counts : of_chunks)
        for (size_t m = 0; m < counts.size(); ++m)
            all[m] += voxel * static_cast<double>(counts[m]);
    return all;
}

}  // namespace cleft
