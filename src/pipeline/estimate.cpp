// Looks at tetrahedra of the wanted sizes at random places, or at those of a background: how many materials do their
// corners have?
#include "pipeline/estimate.hpp"

#include "background/charge.hpp"
#include "background/random.hpp"
#include "pipeline/number_search.hpp"

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
constexpr std::array<double, 4> kSnapped = {1.03, 1.28, 1.63, 1.63}, kWhole = {1, 6, 12, 24};
// The share of points that are the only one of their label from which on all pieces may stay, and up to which none do.
constexpr double kAllStay = 0.35, kNoneStay = 0.05;

constexpr int kSamples = 5000;

// What one tetrahedron of the background becomes.
struct Pieces {
    double all = 0, kept = 0;
};

class Cutter
{
public:
    // `points`: how many points the background has in each material.
    Cutter(const Volume& volume, const std::vector<char>& keep, const std::vector<double>& points)
        : volume_(volume), keep_(keep)
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
        double kept = 0;
        for (size_t i = 0; i < 4; ++i) {
            materials[i] = volume_.material_at(corners[i]);
            kept += keep_.empty() || keep_[static_cast<size_t>(materials[i])] != 0 ? 0.25 : 0;
        }
        std::sort(materials.begin(), materials.end());
        const auto different = static_cast<size_t>(std::unique(materials.begin(), materials.end()) - materials.begin());
        const double all = (1 - stay_) * kSnapped[different - 1] + stay_ * kWhole[different - 1];
        return {all, all * kept};
    }

private:
    const Volume& volume_;
    const std::vector<char>& keep_;
    double stay_ = 0;
};

// The corners of a regular tetrahedron around x, turned at random.
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

// A place in a voxel.
Vec3 place_in(int64_t voxel, const Grid& grid, uint64_t sample)
{
    const int64_t row = grid.dims[0], rows = grid.dims[1];
    Vec3 place(static_cast<double>(voxel % row), static_cast<double>(voxel / row % rows),
               static_cast<double>(voxel / row / rows));
    for (int axis = 0; axis < 3; ++axis)
        place[axis] += unit_random(sample, 3 + static_cast<uint64_t>(axis));
    return place.cwiseProduct(grid.spacing);
}

double density(const SizingField& field, int64_t voxel)
{
    return 1 / std::pow(static_cast<double>(field.h[static_cast<size_t>(voxel)]), 3);
}

std::vector<double> expected_points(const SizingField& field, const Volume& volume)
{
    std::vector<double> points(static_cast<size_t>(volume.material_count()), 0);
    const double charge = kParticleDensity[3] * field.grid.spacing.prod();
    for (int64_t v = 0; v < field.grid.size(); ++v)
        points[static_cast<size_t>(volume.voxel_material(v))] += charge * density(field, v);
    return points;
}

// Tetrahedra of the sizes of a field at random places (the same ones each time), more where they are smaller.
Pieces mean_pieces(const SizingField& field, const Cutter& cutter, const Run& run)
{
    double whole = 0;
    for (int64_t v = 0; v < field.grid.size(); ++v)
        whole += density(field, v);
    Pieces sum;
    uint64_t samples = 0;
    double passed = 0;
    for (int64_t v = 0; v < field.grid.size(); ++v) {
        run.check_at(v, 1 << 20);
        passed += kSamples / whole * density(field, v);
        for (; static_cast<double>(samples) + 0.5 < passed; ++samples) {
            const Vec3 x = place_in(v, field.grid, samples);
            const Pieces pieces = cutter.pieces(corners_around(x, field.at(x), samples));
            sum.all += pieces.all;
            sum.kept += pieces.kept;
        }
    }
    const double each = 1 / static_cast<double>(std::max<uint64_t>(samples, 1));
    return {each * sum.all, each * sum.kept};
}

// The same of tetrahedra that are there.
Pieces mean_pieces(const TetMesh& background, const Cutter& cutter)
{
    const size_t count = background.tets.size(), step = std::max<size_t>(1, count / kSamples);
    Pieces sum;
    double samples = 0;
    for (size_t t = 0; t < count; t += step, ++samples) {
        std::array<Vec3, 4> corners;
        for (size_t i = 0; i < 4; ++i)
            corners[i] = background.points[static_cast<size_t>(background.tets[t][i])];
        const Pieces pieces = cutter.pieces(corners);
        sum.all += pieces.all;
        sum.kept += pieces.kept;
    }
    return {sum.all / samples, sum.kept / samples};
}

// What real volumes took, rounded up: for the program, a voxel and a tetrahedron. Many labels have tables of theirs.
double peak_bytes(const Volume& volume, const Estimate& estimate)
{
    constexpr double kProgram = 3e7, kVoxel = 12, kTet = 200, kTetOfManyLabels = 420;
    return kProgram + kVoxel * static_cast<double>(volume.grid().size()) +
           (estimate.is_bound ? kTetOfManyLabels : kTet) * estimate.whole_tets;
}

// `wanted`: the number of tetrahedra that the sizes are searched for; 0: none.
Estimate estimate_of(const Volume& volume, double background_tets, const Pieces& mean, const Cutter& cutter,
                     double wanted = 0)
{
    Estimate out;
    if (wanted > 0 && mean.kept > 0)
        background_tets = wanted / mean.kept;
    out.background_tets = background_tets;
    out.whole_tets = background_tets * mean.all;
    out.tets = background_tets * mean.kept;
    out.is_bound = cutter.stay() > 0;
    out.peak_bytes = peak_bytes(volume, out);
    return out;
}

}  // namespace

Estimate estimate_from_sizing(const Volume& volume, SizingField field, const PipelineOptions& options, const Run& run)
{
    fit_to_number(field, volume, options, run);
    const BackgroundOptions& background = options.background;
    const BackgroundRow& row = row_of(background.kind);
    const double tets = row.expected_tets(field, background, run);
    if (row.uniform_size)
        field = constant_sizing(field.grid, row.uniform_size(field, background));
    const Cutter cutter(volume, options.keep, expected_points(field, volume));
    return estimate_of(volume, tets, mean_pieces(field, cutter, run), cutter, static_cast<double>(options.tets));
}

Estimate estimate_from_background(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                  const Run& run)
{
    std::vector<double> points(static_cast<size_t>(volume.material_count()), 0);
    for (size_t p = 0; p < background.points.size(); ++p) {
        run.check_at(p);
        points[static_cast<size_t>(volume.material_at(background.points[p]))] += 1;
    }
    const Cutter cutter(volume, options.keep, points);
    return estimate_of(volume, static_cast<double>(background.tets.size()), mean_pieces(background, cutter), cutter);
}

}  // namespace cleft
