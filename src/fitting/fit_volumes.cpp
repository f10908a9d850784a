// The stage: points back onto their ties, then the heights of triangles, then rounds of moves.
#include "fitting/fit_volumes.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "fitting/heights.hpp"
#include "fitting/offsets.hpp"
#include "fitting/relocate_gaps.hpp"
#include "fitting/relocate_lines.hpp"
#include "fitting/volume_corrector.hpp"

#include <cmath>

namespace cleft
{

namespace
{

// Later rounds correct at neighbours what a point could not.
constexpr int kFitRounds = 3;
// More rounds while a label is off, see VolumeDeficits.
// With three rounds alone, sheets and tubes one voxel thick were up to 1.3 % too large: steps converge slowly there.
constexpr int kMostRounds = 8;
// A point that moves off its interface takes so much of the error that is allowed. Chords of a ball whose points move
// by so much are as far off inside as the points are outside.
constexpr double kShareOfError = 0.5;

// Points of interfaces that are off the tie go back to it. Returns those that have none; only user-supplied fields,
// which are exact, say that for sure.
Array<int32_t> relocate(LocalMesh& mesh, const Volume& volume, double floor, const Meetings& meetings, const Run& run)
{
    // Lines come first, because gaps are found from the points of lines that have no tie.
    const LinePoints lines = relocate_lines(mesh, volume, floor, meetings, run);
    run.note("fitting.off_lines", static_cast<double>(lines.off));
    if (volume.is_label_map())
        return {};
    const Array<int32_t> in_gaps = relocate_gaps(mesh, volume, floor, lines.without_tie, run);
    run.note("fitting.in_gaps", static_cast<double>(in_gaps.size()));
    return in_gaps;
}

}  // namespace

bool fit_volumes(LocalMesh& mesh, const Volume& volume, double least_angle, const Run& run, double surface_error,
                 const Array<double>* volumes)
{
    if (volume.material_count() < 2)
        return true;
    Stage stage(run, "fitting", {{"fitting: lines and gaps", 13}, {"fitting: heights", 24}, {"fitting: volumes", 63}});
    const Run of_places = stage.next();
    const double floor = sine_of(least_angle);
    // Fitting changes no connections, so meetings and triangles are found once.
    const Meetings meetings = find_meetings(mesh, of_places);
    const Array<int32_t> without_tie = relocate(mesh, volume, floor, meetings, of_places);
    const Run of_heights = stage.next();
    Array<InterfaceTriangle> triangles = find_triangles(mesh, meetings, of_heights);
    find_heights(mesh, volume, without_tie, triangles, of_heights);
    const Run of_volumes = stage.next();
    Array<FitPoint> points = find_points(mesh, without_tie, triangles, of_volumes);
    const TrianglesAt at = triangles_at(triangles, points, of_volumes);
    const Array<SharedArea> shared = find_shared_areas(triangles);
    const double most_moved = surface_error > 0 ? kShareOfError * surface_error : INFINITY;
    VolumeCorrector corrector(mesh, floor, most_moved);
    VolumeDeficits deficits(mesh, volume, volumes, of_volumes);
    int64_t held = 0;  // in the last round
    for (int round = 0; round < kMostRounds; ++round) {
        if (round >= kFitRounds && !deficits.is_any_off())
            break;
        of_volumes.report(static_cast<double>(round) / kMostRounds);
        if (round >= kFitRounds)
            deficits.widen();
        // Exact fields say where the surface is. Only voxels give a volume to compare with.
        if (volume.is_label_map())
            add_offsets(mesh, deficits, volume.grid().spacing, round == 0, shared, triangles, of_volumes);
        held = corrector.apply(find_residuals(mesh, triangles, at, points, of_volumes), points, deficits, of_volumes);
    }
    run.note("fitting.held", static_cast<double>(held));
    return !deficits.is_any_far_off();
}

bool fit_volumes(LabelledMesh& mesh, const Volume& volume, double least_angle, const Run& run)
{
    LocalMesh local(std::move(mesh), run);
    const bool is_met = fit_volumes(local, volume, least_angle, run);
    mesh = local.take(run);
    return is_met;
}

}  // namespace cleft
