// Looks at tetrahedra of the wanted sizes at random places, or at those of a background: how are they crossed?
#include "pipeline/expected_mesh.hpp"

#include "base/random.hpp"
#include "mesh/bounding_box.hpp"
#include "pipeline/pieces.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleft
{

namespace
{

// With them chance moves a number by a percent or so, which is less than the figures of pieces.cpp are off.
constexpr int kSamples = 5000;

// Means over tetrahedra of the background: of all of them, and of the share of each that will be kept.
struct Means {
    MeanCrossings all, kept;
};

class MeansOfTets
{
public:
    MeansOfTets(const Volume& volume, const Run& run) : counter_(volume, run) {}

    void add(const std::array<Vec3, 4>& corners, double weight, double kept_share)
    {
        const Crossings crossings = counter_.crossings(corners);
        sum_.all.add(crossings, weight);
        sum_.kept.add(crossings, weight * kept_share);
    }

    Means take() const
    {
        const double each = sum_.all.tets() > 0 ? 1 / sum_.all.tets() : 0;
        return {sum_.all.times(each), sum_.kept.times(each)};
    }

private:
    CrossingCounter counter_;
    Means sum_;
};

// The corners of a regular tetrahedron that has one at x, turned at random. It is kept if that one is: the corners are
// alike, and so a place outside of a small label never stands for a part of it.
// A random turn, since interfaces of voxels prefer the axes and a fixed one would see too many or too few of them.
std::array<Vec3, 4> corners_at(const Vec3& x, double edge, uint64_t sample)
{
    const auto random = [&](uint64_t i) { return unit_random(sample, i); };
    const double angle = 2 * M_PI * random(0), z = 2 * random(1) - 1, turn = 2 * M_PI * random(2);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3 axis(r * std::cos(angle), r * std::sin(angle), z);
    const Vec3 u = (std::abs(z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)).cross(axis).normalized(), v = axis.cross(u);
    const double height = std::sqrt(2.0 / 3.0), radius = 1 / std::sqrt(3.0);
    std::array<Vec3, 4> corners;
    corners[3] = x;
    for (size_t i = 0; i < 3; ++i) {
        const double a = turn + 2 * M_PI * static_cast<double>(i) / 3;
        corners[i] = x + edge * (radius * (std::cos(a) * u + std::sin(a) * v) - height * axis);
    }
    return corners;
}

// Tetrahedra at a wall end there.
void move_into_box(std::array<Vec3, 4>& corners, const Vec3& extent)
{
    BoundingBox box;
    for (const Vec3& x : corners)
        box.add(x);
    const Vec3 by = (-box.lo).cwiseMax(0) - (box.hi - extent).cwiseMax(0);
    for (Vec3& x : corners)
        x += by;
}

// A random place in the voxel.
// The same sample always has the same place, so the same call gives the same estimate.
Vec3 place_in(int64_t voxel, const Grid& grid, uint64_t sample)
{
    const int64_t row = grid.dims[0], rows = grid.dims[1], k = voxel / row / rows;
    Vec3 place(static_cast<double>(voxel % row), static_cast<double>(voxel / row % rows), static_cast<double>(k));
    for (int axis = 0; axis < 3; ++axis)
        place[axis] += unit_random(sample, 3 + static_cast<uint64_t>(axis));
    return place.cwiseProduct(grid.spacing);
}

double density(const SizingField& field, int64_t voxel) { return 1 / std::pow(static_cast<double>(field.h[voxel]), 3); }

// Tetrahedra of the sizes of a field at random places (the same ones each time), more where they are smaller. Half of
// them or more are in kept voxels, however few these are.
class Sampling
{
public:
    // `scale`: how large the tetrahedra will be, for the sizes that are asked for.
    Sampling(const SizingField& field, double scale, const Volume& volume, const KeptMaterials& kept)
        : field_(field), scale_(scale), volume_(volume), kept_(kept)
    {
        for (int64_t v = 0; v < field.grid.size(); ++v)
            (is_kept(v) ? in_kept_ : in_other_) += density(field, v);
        // Without this, a small label that is kept would get a few samples, and its number would be a matter of chance.
        boost_ = in_kept_ > 0 ? std::max(1.0, in_other_ / in_kept_) : 1;
    }

    Means means(const Run& run) const
    {
        const double whole = boost_ * in_kept_ + in_other_;
        MeansOfTets means(volume_, run);
        uint64_t samples = 0;
        double passed = 0;
        for (int64_t v = 0; v < field_.grid.size(); ++v) {
            run.check_at(v, 1 << 20);
            const double boost = is_kept(v) ? boost_ : 1;
            passed += kSamples / whole * boost * density(field_, v);
            // Steps of equal weight through the voxels spread the samples more evenly than drawing each voxel would.
            for (; static_cast<double>(samples) + 0.5 < passed; ++samples) {
                const Vec3 x = place_in(v, field_.grid, samples);
                auto corners = corners_at(x, scale_ * field_.at(x), samples);
                move_into_box(corners, field_.grid.extent());
                means.add(corners, 1 / boost, is_kept(v) ? 1 : 0);
            }
        }
        return means.take();
    }

private:
    bool is_kept(int64_t voxel) const { return kept_.has(volume_.voxel_material(voxel)); }

    const SizingField& field_;
    const double scale_;
    const Volume& volume_;
    const KeptMaterials& kept_;
    double in_kept_ = 0, in_other_ = 0;  // sums of the density over the voxels
    double boost_ = 1;                   // how much denser the samples are in kept voxels
};

// The same of tetrahedra that are there.
Means means_of_background(const TetMesh& background, const Volume& volume, const KeptMaterials& kept, const Run& run)
{
    const size_t count = background.tets.size(), step = std::max<size_t>(1, count / kSamples);
    const auto kept_share = [&](const std::array<Vec3, 4>& corners) {
        double share = 0;
        for (const Vec3& x : corners)
            share += kept.has(volume.material_at(x)) ? 0.25 : 0;
        return share;
    };
    MeansOfTets means(volume, run);
    for (size_t t = 0; t < count; t += step) {
        std::array<Vec3, 4> corners;
        for (size_t i = 0; i < 4; ++i)
            corners[i] = background.points[background.tets[t][i]];
        means.add(corners, 1, kept_share(corners));
    }
    return means.take();
}

ExpectedMesh mesh_of(const Means& means, double tets, const PipelineOptions& options, Arrangement arrangement)
{
    const Pieces all = pieces_of(means.all, options, arrangement), kept = pieces_of(means.kept, options, arrangement);
    return {tets, tets * all.cleaved, tets * all.finished, tets * kept.finished, is_rough(means.all)};
}

Arrangement arrangement_of(const SizingField& field, BackgroundKind kind)
{
    if (!is_graded(kind) || field.range().is_one_size())
        return Arrangement::lattice;
    return kind == BackgroundKind::octree ? Arrangement::octree : Arrangement::particles;
}

}  // namespace

ExpectedMesh expected_mesh(const Volume& volume, const SizingField& field, const PipelineOptions& options,
                           const Run& run)
{
    const BackgroundRow& row = row_of(options.background.kind);
    const double tets = row.expected_tets(field, options.background, run);
    const Arrangement arrangement = arrangement_of(field, options.background.kind);
    const auto mesh_of_sizes = [&](const SizingField& sizes) {
        // Leaves of an octree are up to half as large as is asked for, and cells of a lattice have to fit the box.
        const double scale = std::cbrt(expected_particle_tets(sizes) / tets);
        return mesh_of(Sampling(sizes, scale, volume, options.kept).means(run), tets, options, arrangement);
    };
    if (!row.uniform_size)
        return mesh_of_sizes(field);
    return mesh_of_sizes(constant_sizing(field.grid, row.uniform_size(field, options.background)));
}

ExpectedMesh expected_mesh(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                           const Run& run)
{
    // Of one of the user nothing is known: it is taken for the most irregular.
    return mesh_of(means_of_background(background, volume, options.kept, run),
                   static_cast<double>(background.tets.size()), options, Arrangement::particles);
}

}  // namespace cleft
