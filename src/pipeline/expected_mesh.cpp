// Looks at tetrahedra of the wanted sizes at random places: how many materials do their corners have?
#include "pipeline/expected_mesh.hpp"

#include "background/charge.hpp"
#include "background/random.hpp"

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

// The expected share of points that are the only ones of their label.
double lone_share(const SizingField& field, const Volume& volume)
{
    std::vector<double> points(static_cast<size_t>(volume.material_count()), 0);
    const double voxel = kParticleDensity[3] * field.grid.spacing.prod();
    for (int64_t v = 0; v < field.grid.size(); ++v)
        points[static_cast<size_t>(volume.voxel_material(v))] +=
            voxel / std::pow(static_cast<double>(field.h[static_cast<size_t>(v)]), 3);
    double lone = 0, all = 0;
    for (const double n : points) {
        lone += 1 - std::exp(-n);
        all += n;
    }
    return lone / all;
}

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

// What one sample stands for, in tetrahedra over those of the background.
struct Pieces {
    double all = 0, kept = 0;
};

class Sampler
{
public:
    Sampler(const SizingField& field, const Volume& volume, const std::vector<char>& keep)
        : field_(field), volume_(volume), keep_(keep)
    {
        stay_ = std::clamp((lone_share(field, volume) - kNoneStay) / (kAllStay - kNoneStay), 0.0, 1.0);
    }

    bool is_bound() const { return stay_ > 0; }

    Pieces at(int64_t voxel, uint64_t sample) const
    {
        const int64_t row = field_.grid.dims[0], rows = field_.grid.dims[1];
        Vec3 place(static_cast<double>(voxel % row), static_cast<double>(voxel / row % rows),
                   static_cast<double>(voxel / row / rows));
        for (int axis = 0; axis < 3; ++axis)
            place[axis] += unit_random(sample, 3 + static_cast<uint64_t>(axis));
        const Vec3 x = place.cwiseProduct(field_.grid.spacing);
        std::array<Material, 4> materials{};
        double kept = 0;
        const std::array<Vec3, 4> corners = corners_around(x, field_.at(x), sample);
        for (size_t i = 0; i < 4; ++i) {
            materials[i] = volume_.material_at(corners[i]);
            kept += keep_.empty() || keep_[static_cast<size_t>(materials[i])] != 0 ? 0.25 : 0;
        }
        std::sort(materials.begin(), materials.end());
        const auto different = static_cast<size_t>(std::unique(materials.begin(), materials.end()) - materials.begin());
        const double pieces = (1 - stay_) * kSnapped[different - 1] + stay_ * kWhole[different - 1];
        return {pieces, pieces * kept};
    }

private:
    const SizingField& field_;
    const Volume& volume_;
    const std::vector<char>& keep_;
    double stay_;  // the part of the cuts that snapping cannot take away
};

}  // namespace

ExpectedMesh expected_mesh(const SizingField& field, const Volume& volume, const std::vector<char>& keep,
                           const Run& run)
{
    const double background = expected_background_tets(field);
    const Sampler sampler(field, volume, keep);
    double whole = 0;
    for (const float h : field.h)
        whole += 1 / std::pow(static_cast<double>(h), 3);
    Pieces sum;
    uint64_t samples = 0;
    double passed = 0;
    for (int64_t v = 0; v < field.grid.size(); ++v) {
        if (v % (1 << 20) == 0)
            run.check();
        passed += kSamples / whole / std::pow(static_cast<double>(field.h[static_cast<size_t>(v)]), 3);
        for (; static_cast<double>(samples) + 0.5 < passed; ++samples) {
            const Pieces pieces = sampler.at(v, samples);
            sum.all += pieces.all;
            sum.kept += pieces.kept;
        }
    }
    const double each = background / static_cast<double>(std::max<uint64_t>(samples, 1));
    return {each * sum.all, each * sum.kept, sampler.is_bound()};
}

}  // namespace cleft
