// Moves points of lines back onto their tie, in a fixed order, as far as the tetrahedra around allow.
#include "fitting/relocate_lines.hpp"

#include "base/collect.hpp"
#include "base/per_worker.hpp"
#include "fitting/room_maker.hpp"
#include "remeshing/point_levels.hpp"
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

    // `looks_around`: also seeks further for the tie, and moves the points around. Not for several threads then.
    Found relocate(int32_t v, bool looks_around)
    {
        star_.load(mesh_, v);
        const auto materials = materials_of(star_.tets(), mesh_.materials());
        if (!materials)
            return Found::without_tie;
        const Vec3 from = mesh_.point(v);
        const double reach = star_.reach(from);
        const auto on_tie = tie_near(from, *materials, mesh_.frozen(v), reach, looks_around);
        if (!on_tie)
            return Found::without_tie;
        if ((*on_tie - from).norm() < kLeastStep * reach)
            return Found::on_tie;
        const double least = std::min(floor_, star_.worst_at(from, -1));
        if (looks_around && room_.settle(v, *on_tie, least))
            return Found::on_tie;
        // Each needs one look at the star, and what is left comes in the next round.
        for (const double share : kStepShares) {
            const Vec3 x = from + share * (*on_tie - from);
            if (star_.worst_at(x, least) > least) {
                mesh_.move(v, x);
                return share == 1 ? Found::on_tie : Found::off_tie;
            }
        }
        return Found::off_tie;
    }

private:
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

}  // namespace

LinePoints relocate_lines(LocalMesh& mesh, const Volume& volume, double floor, const Meetings& meetings, const Run& run,
                          bool looks_around)
{
    using Found = LineRelocator::Found;
    auto points =
        collect<int32_t>(run, mesh.point_count(), kLinePointsAtOnce, [&](int64_t begin, int64_t end, auto& list) {
            for (auto v = static_cast<int32_t>(begin); v < end; ++v)
                if (meetings[v] == Meeting::line && !mesh.is_settled(v))
                    list.push_back(v);
        });
    LinePoints out;
    PerWorker<LineRelocator> relocators(run, mesh, volume, floor);
    // Most points find their tie without a look around.
    const int first_around = looks_around ? 1 : kLineRounds;
    const int rounds = looks_around ? 1 + kLineRounds : kLineRounds;
    for (int round = 0; round < rounds; ++round) {
        const bool around = round >= first_around;
        Array<Found> found(points.size(), Found::on_tie);
        const auto visit = [&](int worker, int64_t i) { found[i] = relocators[worker].relocate(points[i], around); };
        // Who makes room around a point moves others, and changes connections.
        if (around)
            run.for_each(points.count(), [&](int64_t i) { visit(0, i); });
        else
            levels_of_points(
                mesh, points.count(), [&](int64_t i) { return points[i]; }, run)
                .visit_all(run, visit);
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
