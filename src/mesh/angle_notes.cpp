#include "mesh/angle_notes.hpp"

#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

constexpr double kCountBelow[] = {10, 15, 20, 25};

struct AngleSummary {
    double least = 180, greatest = 0;
    int64_t below[4] = {0, 0, 0, 0};

    void add(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d)
    {
        // No angle of the tetrahedron is nearer to 0 or 180 degrees than this; most need no closer look.
        const double bound = std::asin(std::clamp(least_sine(a, b, c, d), 0.0, 1.0)) * 180 / M_PI;
        if (bound >= kCountBelow[3] && bound >= least && 180 - bound <= greatest)
            return;
        const auto angles = dihedral_angles(a, b, c, d);
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        least = std::min(least, *low);
        greatest = std::max(greatest, *high);
        for (size_t i = 0; i < 4; ++i)
            below[i] += *low < kCountBelow[i];
    }
};

}  // namespace

void note_angles(const std::vector<Vec3>& points, const std::vector<Tet>& tets, const std::string& prefix,
                 const std::string& when, const Run& run)
{
    if (!run.metrics)
        return;
    AngleSummary summary;
    const auto point = [&](int32_t v) -> const Vec3& { return points[static_cast<size_t>(v)]; };
    for (const Tet& t : tets)
        summary.add(point(t[0]), point(t[1]), point(t[2]), point(t[3]));
    const auto note = [&](const char* name, double value) { run.note(prefix + "." + name + "_" + when, value); };
    note("tets", static_cast<double>(tets.size()));
    note("min_angle", summary.least);
    note("max_angle", summary.greatest);
    note("below_10", static_cast<double>(summary.below[0]));
    note("below_15", static_cast<double>(summary.below[1]));
    note("below_20", static_cast<double>(summary.below[2]));
    note("below_25", static_cast<double>(summary.below[3]));
}

}  // namespace cleft
