// Looks at tetrahedra of the wanted sizes at random places, or at those of a background: how many materials do their
// corners have?
#include "pipeline/expected_mesh.hpp"

#include "background/charge.hpp"
#include "base/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace cleft
{

namespace
{

// Of one background tetrahedron, by the number of materials at its corners. Snapping takes nearly all cuts away; but a
// label keeps its last point where it is, so that of tetrahedra whose points have a label each all pieces stay. The
// figures are those of balls, grains, noise, checkers and sheets at several sizes.
constexpr FixedArray<double, 4> kSnapped = {1.03, 1.28, 1.57, 1.57}, kWhole = {1, 6, 12, 24};
// The share of points that are the only one of their label from which on all pieces may stay, and up to which none do.
constexpr double kAllStay = 0.35, kNoneStay = 0.05;

// With them chance moves a number by a percent or so, which is less than the figures above are off.
constexpr int kSamples = 5000;

// What one tetrahedron of the background becomes.
struct Pieces {
    double all = 0, kept = 0;
};

class PieceCounter
{
public:
    // `points`: how many points the background has in each material.
    PieceCounter(const Volume& volume, const KeptMaterials& kept, const Array<double>& points)
        : volume_(volume), kept_(kept)
    {
        double lone = 0, all = 0;
        for (const double n : points) {
            lone += 1 - std::exp(-n);  // materials with one point, where points lie at random
            all += n;
        }
        stay_ = std::clamp((lone / all - kNoneStay) / (kAllStay - kNoneStay), 0.0, 1.0);
    }

    // The part of the cuts that snapping cannot take away.
    double stay() const { return stay_; }

    Pieces pieces(const std::array<Vec3, 4>& corners) const
    {
        std::array<Material, 4> materials{};
        double share = 0;  // of the corners that are kept
        for (size_t i = 0; i < 4; ++i) {
            materials[i] = volume_.material_at(corners[i]);
            share += kept_.has(materials[i]) ? 0.25 : 0;
        }
        std::sort(materials.begin(), materials.end());
        const auto different = std::unique(materials.begin(), materials.end()) - materials.begin();
        const double all = (1 - stay_) * kSnapped[different - 1] + stay_ * kWhole[different - 1];
        return {all, all * share};
    }

private:
    const Volume& volume_;
    const KeptMaterials& kept_;
    double stay_ = 0;
};

// The corners of a regular tetrahedron around x, turned at random.
// A random turn, since interfaces of voxels prefer the axes and a fixed one would see too many or too few of them.
std::array<Vec3, 4> corners_around(const Vec3& x, double edge, uint64_t sample)
{
    const auto random = [&](uint64_t i) { return unit_random(sample, i); };
    const double angle = 2 * M_PI * random(0), z = 2 * random(1) - 1, turn = 2 * M_PI * random(2);
    const double r = std::sqrt(std::max(0.0, 1 - z * z));
    const Vec3 axis(r * std::cos(angle), r * std::sin(angle), z);
    const Vec3 u = (std::abs(z) < 0.9 ? Vec3(0, 0, 1) : Vec3(1, 0, 0)).cross(axis).normalized(), v = axis.cross(u);
    const double height = std::sqrt(2.0 / 3.0), radius = 1 / std::sqrt(3.0);
    std::array<Vec3, 4> corners;
    corners[3] = x + 0.75 * height * edge * axis;
    for (size_t i = 0; i < 3; ++i) {
        const double a = turn + 2 * M_PI * static_cast<double>(i) / 3;
        corners[i] = x + edge * (radius * (std::cos(a) * u + std::sin(a) * v) - 0.25 * height * axis);
    }
    return corners;
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

Array<double> expected_points(const SizingField& field, const Volume& volume)
{
    Array<double> points(volume.material_count(), 0);
    const double charge = kParticleDensity[3] * field.grid.spacing.prod();
    for (int64_t v = 0; v < field.grid.size(); ++v)
        points[volume.voxel_material(v)] += charge * density(field, v);
    return points;
}

// Tetrahedra of the sizes of a field at random places (the same ones each time), more where they are smaller. Half of
// them or more are in kept voxels, however few these are.
class Sampling
{
public:
    Sampling(const SizingField& field, const Volume& volume, const KeptMaterials& kept)
        : field_(field), volume_(volume), kept_(kept)
    {
        for (int64_t v = 0; v < field.grid.size(); ++v)
            (is_kept(v) ? in_kept_ : in_other_) += density(field, v);
        // Without this, a small label that is kept would get a few samples, and its number would be a matter of chance.
        boost_ = in_kept_ > 0 ? std::max(1.0, in_other_ / in_kept_) : 1;
    }

    Pieces mean_pieces(const PieceCounter& counter, const Run& run) const
    {
        const double whole = boost_ * in_kept_ + in_other_;
        Pieces sum;
        uint64_t samples = 0;
        double passed = 0, weights = 0;
        for (int64_t v = 0; v < field_.grid.size(); ++v) {
            run.check_at(v, 1 << 20);
            const double boost = is_kept(v) ? boost_ : 1;
            passed += kSamples / whole * boost * density(field_, v);
            // Steps of equal weight through the voxels spread the samples more evenly than drawing each voxel would.
            for (; static_cast<double>(samples) + 0.5 < passed; ++samples) {
                const Vec3 x = place_in(v, field_.grid, samples);
                const Pieces pieces = counter.pieces(corners_around(x, field_.at(x), samples));
                sum.all += pieces.all / boost;
                sum.kept += pieces.kept / boost;
                weights += 1 / boost;
            }
        }
        const double each = weights > 0 ? 1 / weights : 0;
        return {each * sum.all, each * sum.kept};
    }

private:
    bool is_kept(int64_t voxel) const { return kept_.has(volume_.voxel_material(voxel)); }

    const SizingField& field_;
    const Volume& volume_;
    const KeptMaterials& kept_;
    double in_kept_ = 0, in_other_ = 0;  // sums of the density over the voxels
    double boost_ = 1;                   // how much denser the samples are in kept voxels
};

// The same of tetrahedra that are there.
Pieces mean_pieces(const TetMesh& background, const PieceCounter& counter)
{
    const size_t count = background.tets.size(), step = std::max<size_t>(1, count / kSamples);
    Pieces sum;
    double samples = 0;
    for (size_t t = 0; t < count; t += step, ++samples) {
        std::array<Vec3, 4> corners;
        for (size_t i = 0; i < 4; ++i)
            corners[i] = background.points[background.tets[t][i]];
        const Pieces pieces = counter.pieces(corners);
        sum.all += pieces.all;
        sum.kept += pieces.kept;
    }
    return {sum.all / samples, sum.kept / samples};
}

ExpectedMesh mesh_of_pieces(double background_tets, const Pieces& mean, const PieceCounter& counter)
{
    return {background_tets, background_tets * mean.all, background_tets * mean.kept, counter.stay() > 0};
}

ExpectedMesh mesh_of_sizes(const Volume& volume, const SizingField& field, const KeptMaterials& kept,
                           double background_tets, const Run& run)
{
    const PieceCounter counter(volume, kept, expected_points(field, volume));
    return mesh_of_pieces(background_tets, Sampling(field, volume, kept).mean_pieces(counter, run), counter);
}

}  // namespace

ExpectedMesh expected_mesh(const Volume& volume, const SizingField& field, const PipelineOptions& options,
                           const Run& run)
{
    const BackgroundRow& row = row_of(options.background.kind);
    const double tets = row.expected_tets(field, options.background, run);
    if (!row.uniform_size)
        return mesh_of_sizes(volume, field, options.kept, tets, run);
    return mesh_of_sizes(volume, constant_sizing(field.grid, row.uniform_size(field, options.background)), options.kept,
                         tets, run);
}

ExpectedMesh expected_mesh(const Volume& volume, const TetMesh& background, const KeptMaterials& kept, const Run& run)
{
    Array<double> points(volume.material_count(), 0);
    for (size_t p = 0; p < background.points.size(); ++p) {
        run.check_at(p);
        points[volume.material_at(background.points[p])] += 1;
    }
    const PieceCounter counter(volume, kept, points);
    return mesh_of_pieces(static_cast<double>(background.tets.size()), mean_pieces(background, counter), counter);
}

}  // namespace cleft
