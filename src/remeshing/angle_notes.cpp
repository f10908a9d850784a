// Summarizes the angles of a mesh. The known qualities tell which tetrahedra can matter, so few angles are computed.
#include "remeshing/angle_notes.hpp"

#include "base/degrees.hpp"
#include "mesh/quality.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// What is usable, good, and what users ask for (decision 18).
constexpr size_t kCounts = 5;
constexpr double kCountBelow[kCounts] = {10, 15, 20, 25, 30};

struct AngleSummary {
    double least = 180, greatest = 0;
    int64_t below[kCounts] = {};
    int64_t tets = 0;
    // No angle of a tetrahedron of this quality can change the summary any more.
    double of_no_interest = 2;

    void add(const LocalMesh& mesh, int32_t t)
    {
        ++tets;
        if (mesh.quality(t) > of_no_interest)
            return;
        const Tet& v = mesh.tet(t);
        const auto angles = dihedral_angles(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        least = std::min(least, *low);
        greatest = std::max(greatest, *high);
        for (size_t i = 0; i < kCounts; ++i)
            below[i] += *low < kCountBelow[i];
        // The quality is at most the sine of every angle.
        const double nearest =
            std::max({kCountBelow[kCounts - 1], std::min(least, 90.0), 180 - std::max(greatest, 90.0)});
        // The factor covers the rounding of both sines, so that no tetrahedron at a limit is missed.
        of_no_interest = sine_of(nearest) * (1 + 1e-12);
    }
};

}  // namespace

void note_angles(const LocalMesh& mesh, const std::string& prefix, const std::string& when, const Run& run)
{
    if (!run.metrics)
        return;
    AngleSummary summary;
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        if (mesh.alive(t)) {
            run.check_at(t);
            summary.add(mesh, t);
        }
    const auto note = [&](const char* name, double value) { run.note(prefix + "." + name + "_" + when, value); };
    note("tets", static_cast<double>(summary.tets));
    note("min_angle", summary.least);
    note("max_angle", summary.greatest);
    note("below_10", static_cast<double>(summary.below[0]));
    note("below_15", static_cast<double>(summary.below[1]));
    note("below_20", static_cast<double>(summary.below[2]));
    note("below_25", static_cast<double>(summary.below[3]));
    note("below_30", static_cast<double>(summary.below[4]));
}

}  // namespace cleft
