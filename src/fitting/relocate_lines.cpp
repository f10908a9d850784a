// Moves points of lines back onto their tie, in a fixed order, as far as the tetrahedra around allow.
#include "fitting/relocate_lines.hpp"

#include "base/collect.hpp"
#include "base/per_worker.hpp"
#include "fitting/room_maker.hpp"
#include "remeshing/claimed_visits.hpp"
#include "remeshing/ordered_points.hpp"
#include "remeshing/smoothing.hpp"
#include "volume/tie.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

namespace cleft
{

namespace
{

// Smaller moves are not worth their price, in lengths of the edges around.
// A smaller step would move nearly every point of a line, for less than half a hundredth of an edge.
constexpr double kLeastStep = 5e-3;
// Of the way to the tie, as far as the shapes allow. Less than an eighth would hardly bring the point nearer.
constexpr double kStepShares[] = {1, 0.5, 0.25, 0.125};
constexpr int kLineRounds = 3;  // a point that is in the way may have moved on
// Points that a thread looks at. The number changes the time alone.
constexpr int64_t kLinePointsAtOnce = 1 << 14;

class LineRelocator
{
public:
    LineRelocator(LocalMesh& mesh, const Volume& volume, double floor)
        : mesh_(mesh), volume_(volume), floor_(floor), room_(mesh, volume)
    {
    }

    enum class Found : uint8_t { on_tie, off_tie, without_tie };

    // Brings the point nearer to its tie. No other changes.
    Found relocate(int32_t v)
    {
        Vec3 on_tie;
        const Found found = find_tie(v, false, on_tie);
        return found == Found::off_tie ? move_towards(v, on_tie) : found;
    }
    // Where the tie is, if the point is off it. `looks_around`: also seeks further for it. Changes nothing.
    Found find_tie(int32_t v, bool looks_around, Vec3& on_tie)
    {
        star_.load(mesh_, v);
        if (star_.empty())  // another point has taken it in
            return Found::on_tie;
        const auto materials = materials_of(star_.tets(), mesh_.materials());
        if (!materials)
            return Found::without_tie;
        const Vec3& from = mesh_.point(v);
        const double reach = star_.reach(from);
        const auto found = tie_near(from, *materials, mesh_.frozen(v), reach, looks_around);
        if (!found)
            return Found::without_tie;
        on_tie = *found;
        return (on_tie - from).norm() < kLeastStep * reach ? Found::on_tie : Found::off_tie;
    }
    // Brings the point onto its tie, or nearer. May move the points around, and contract edges: see
    // RoomMaker::settle().
    Found settle(int32_t v, const Vec3& on_tie, int worker, Array<int32_t>& unused)
    {
        star_.load(mesh_, v);
        const double least = std::min(floor_, star_.worst_at(mesh_.point(v), -1));
        return room_.settle(v, on_tie, least, worker, unused) ? Found::on_tie : move_towards(v, on_tie);
    }
    RoomMaker& room() { return room_; }

private:
    // The star that is loaded is that of the point.
    Found move_towards(int32_t v, const Vec3& on_tie)
    {
        const Vec3 from = mesh_.point(v);
        const double least = std::min(floor_, star_.worst_at(from, -1));
        // Each needs one look at the star, and what is left comes in the next round.
        for (const double share : kStepShares) {
            const Vec3 x = from + share * (on_tie - from);
            if (star_.worst_at(x, least) > least) {
                mesh_.move(v, x);
                return share == 1 ? Found::on_tie : Found::off_tie;
            }
        }
        return Found::off_tie;
    }

    std::optional<Vec3> tie_near(const Vec3& x, const MaterialSet& materials, uint8_t frozen, double reach,
                                 bool looks_around)
    {
        const auto near = project_to_tie(volume_, x, x, materials, frozen, reach, samples_);
        if (near || !looks_around)
            return near;
        const auto start = place_of_all(x, materials, frozen, reach);
        return start ? project_to_tie(volume_, x, *start, materials, frozen, reach, samples_) : std::nullopt;
    }

    // Of the places up to two voxels from x, that where the least of the materials has the greatest share.
    std::optional<Vec3> place_of_all(const Vec3& x, const MaterialSet& materials, uint8_t frozen, double reach)
    {
        const Mat3 free = free_axes(frozen) * volume_.grid().spacing.asDiagonal();
        double best = 0;
        std::optional<Vec3> place;
        for (int step = 0; step < 2 * 27; ++step) {
            const Vec3 way(step % 3 - 1, step / 3 % 3 - 1, step / 9 % 3 - 1);
            const int radius = 1 + step / 27;
            const Vec3 to = free * (radius / std::max(1.0, way.norm()) * way);
            if (to.norm() > reach)
                continue;
            if (const double share = least_share(x + to, materials); share > best) {
                best = share;
                place = x + to;
            }
        }
        return place;
    }

    double least_share(const Vec3& x, const MaterialSet& materials)
    {
        volume_.sample(x, samples_);
        double least = INFINITY;
        for (const Material m : materials) {
            const int at = samples_.find(m);
            least = std::min(least, at < 0 ? 0 : samples_.value[at]);
        }
        return least;
    }

    LocalMesh& mesh_;
    const Volume& volume_;
    const double floor_;
    TetStar star_;
    RoomMaker room_;
    Samples samples_;
};

using Found = LineRelocator::Found;

// One round: what was found of each point.
Array<Found> relocated(const LocalMesh& mesh, const Array<int32_t>& points, PerWorker<LineRelocator>& relocators,
                       const Run& run)
{
    Array<Found> found(points.size(), Found::on_tie);
    visit_points_in_order(
        mesh, points.count(), [&](int64_t i) { return points[i]; }, run,
        [&](int worker, int64_t i) { found[i] = relocators[worker].relocate(points[i]); });
    return found;
}

// Rounds in which the mesh around the points changes as well.
class SettlingRounds
{
public:
    SettlingRounds(LocalMesh& mesh, PerWorker<LineRelocator>& relocators, const Run& run)
        : mesh_(mesh),
          relocators_(relocators),
          visits_(mesh, run),
          changed_(large_array<uint32_t>(run, mesh.slot_count())),
          tried_(large_array<uint32_t>(run, mesh.point_count()))
    {
    }

    // What was found of each point.
    Array<Found> settle(const Array<int32_t>& points, const Run& run)
    {
        Array<Found> found(points.size(), Found::off_tie);
        Array<Vec3> on_tie(points.size(), Vec3(0, 0, 0));
        Array<Array<int32_t>> unused(points.size());
        visits_.visit_all(
            run, points.count(),
            [&](int worker, int64_t i, Array<int32_t>& tets) {
                const int32_t v = points[i];
                found[i] = relocators_[worker].find_tie(v, true, on_tie[i]);
                if (found[i] != Found::off_tie)
                    return;
                relocators_[worker].room().add_touched_tets(v, on_tie[i], tets);
                if (!is_worth_trying(v, tets))
                    tets.clear();
            },
            [&](int worker, int64_t i) {
                const int32_t v = points[i];
                const Vec3 from = mesh_.point(v);
                found[i] = relocators_[worker].settle(v, on_tie[i], worker, unused[i]);
                tried_[v] = visits_.round();
                if (mesh_.point(v) != from)
                    note_move(v);
                for (const PointMove& move : relocators_[worker].room().moved())
                    note_move(move.point);
            },
            [&](int64_t i) {
                mesh_.release(unused[i], 0);
                unused[i] = {};
            });
        return found;
    }

private:
    // Something around has changed since nothing helped. Others change nothing around in the same round.
    bool is_worth_trying(int32_t v, const Array<int32_t>& touched) const
    {
        return tried_[v] == 0 ||
               std::any_of(touched.begin(), touched.end(), [&](int32_t t) { return changed_[t] >= tried_[v]; });
    }

    // The new tetrahedra of a contraction are at the point that has settled.
    void note_move(int32_t v)
    {
        for (const int32_t t : mesh_.star(v))
            changed_[t] = visits_.round();
    }

    LocalMesh& mesh_;
    PerWorker<LineRelocator>& relocators_;
    ClaimedVisits visits_;
    Array<uint32_t> changed_;  // by tetrahedron: in which round one of its corners moved last
    Array<uint32_t> tried_;    // by point: in which round it was to settle last; 0 if never
};

}  // namespace

LinePoints relocate_lines(LocalMesh& mesh, const Volume& volume, double floor, const Meetings& meetings, const Run& run,
                          bool looks_around)
{
    auto points =
        collect<int32_t>(run, mesh.point_count(), kLinePointsAtOnce, [&](int64_t begin, int64_t end, auto& list) {
            for (auto v = static_cast<int32_t>(begin); v < end; ++v)
                if (meetings[v] == Meeting::line && !mesh.is_settled(v))
                    list.push_back(v);
        });
    LinePoints out;
    PerWorker<LineRelocator> relocators(run, mesh, volume, floor);
    std::optional<SettlingRounds> settling;
    // Most points find their tie without a look around.
    const int first_around = looks_around ? 1 : kLineRounds;
    const int rounds = looks_around ? 1 + kLineRounds : kLineRounds;
    for (int round = 0; round < rounds; ++round) {
        const bool around = round >= first_around;
        if (around && !settling)
            settling.emplace(mesh, relocators, run);
        const Array<Found> found = around ? settling->settle(points, run) : relocated(mesh, points, relocators, run);
        Array<int32_t> left;
        for (int64_t i = 0; i < points.count(); ++i) {
            if (found[i] == Found::off_tie)
                left.push_back(points[i]);
            else if (found[i] == Found::without_tie)
                (around == looks_around ? out.without_tie : left).push_back(points[i]);
        }
        points.swap(left);
    }
    out.off = points.count();
    return out;
}

}  // namespace cleft
