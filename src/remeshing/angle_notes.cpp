// Summarizes the angles of a mesh. The known qualities tell which tetrahedra can matter, so few angles are computed.
#include "remeshing/angle_notes.hpp"

#include "base/degrees.hpp"
#include "base/parallel.hpp"
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

    void add(const FixedArray<double, 6>& angles)
    {
        const auto [low, high] = std::minmax_element(angles.begin(), angles.end());
        least = std::min(least, *low);
        greatest = std::max(greatest, *high);
        for (size_t i = 0; i < kCounts; ++i)
            below[i] += *low < kCountBelow[i];
    }

    void join(const AngleSummary& other)
    {
        least = std::min(least, other.least);
        greatest = std::max(greatest, other.greatest);
        for (size_t i = 0; i < kCounts; ++i)
            below[i] += other.below[i];
        tets += other.tets;
    }

    // No angle of a tetrahedron of this quality can change the summary any more: the quality is at most the sine of
    // every angle.
    double of_no_interest() const
    {
        const double nearest =
            std::max({kCountBelow[kCounts - 1], std::min(least, 90.0), 180 - std::max(greatest, 90.0)});
        // The factor covers the rounding of both sines, so that no tetrahedron at a limit is missed.
        return sine_of(nearest) * (1 + 1e-12);
    }
};

FixedArray<double, 6> angles_of(const LocalMesh& mesh, int32_t t)
{
    const Tet& v = mesh.tet(t);
    return dihedral_angles(mesh.point(v[0]), mesh.point(v[1]), mesh.point(v[2]), mesh.point(v[3]));
}

AngleSummary summarize(const LocalMesh& mesh, const Run& run)
{
    constexpr int64_t kTetsAtOnce = 1 << 14;
    mesh.find_qualities(run);
    Array<AngleSummary> parts(chunk_count(mesh.slot_count(), kTetsAtOnce));
    // What one thread has met spares the others angles, sooner or later as they come. It spares only angles that change
    // nothing in the summary of all.
    std::atomic<double> of_no_interest{2};
    parallel_chunks(run, mesh.slot_count(), kTetsAtOnce, [&](int64_t chunk, int64_t begin, int64_t end) {
        AngleSummary part;
        double limit = of_no_interest;
        for (auto t = static_cast<int32_t>(begin); t < end; ++t) {
            part.tets += mesh.alive(t);
            if (!mesh.alive(t) || mesh.quality(t) > limit)
                continue;
            part.add(angles_of(mesh, t));
            limit = std::min(limit, part.of_no_interest());
        }
        parts[chunk] = part;
        if (limit < of_no_interest)
            of_no_interest = limit;
    });
    AngleSummary all;
    for (const AngleSummary& part : parts)
        all.join(part);
    return all;
}

}  // namespace

void note_angles(const LocalMesh& mesh, const std::string& prefix, const std::string& when, const Run& run)
{
    if (!run.metrics)
        return;
    const AngleSummary summary = summarize(mesh, run);
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
