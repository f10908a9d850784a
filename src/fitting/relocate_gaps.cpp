// Moves points in unresolved gaps onto a true interface. Off it, they would pull the points around along when fitted.
#include "fitting/relocate_gaps.hpp"

#include "remeshing/smoothing.hpp"
#include "volume/tie.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace cleft
{

namespace
{

// The first bounds how far a point is taken from its place, so that its tetrahedra can follow. The shares are tried in
// turn: each is a compromise between the right place and the shapes.
constexpr double kReachOfGap = 0.5;                 // how far to the nearest interface, in edge lengths
constexpr double kShares[] = {1, 0.5, 0.25, 0};     // of the way to the tie
constexpr double kPartShares[] = {0.6, 0.3, 0.15};  // of the way to the interface
// With this power, a label of a thousand times as many voxels counts as twice as far away.
constexpr double kSizeCounts = 0.1;  // power of the voxels of a label by which a distance counts
// Rounds end when no point moves. The limit is for points that keep each other from their places.
constexpr int kGapRounds = 10;  // a point that is in the way may have moved on

// Where a point may go.
struct Interface {
    MaterialSet pair;
    Vec3 x;
    double cost;
};

class GapRelocator
{
public:
    GapRelocator(LocalMesh& mesh, const Volume& volume, double floor)
        : mesh_(mesh), volume_(volume), voxels_(volume.voxel_counts()), floor_(floor)
    {
    }

    // A point of two materials where a third one wins.
    bool is_inside_another(int32_t v)
    {
        star_.load(mesh_, v);
        const auto materials = materials_of(star_.tets(), mesh_.materials());
        return materials && materials->size() == 2 && disjoint(*materials, MaterialSet(winner(mesh_.point(v))));
    }

    // Moves the point onto an interface, and one of three materials or more also towards their tie, as far as may be.
    // False if another round may bring it further.
    bool relocate(int32_t v)
    {
        star_.load(mesh_, v);
        const auto materials = materials_of(star_.tets(), mesh_.materials());
        if (!materials)
            return true;
        const Vec3 from = mesh_.point(v);
        const Vec3 way = way_to_tie(from, *materials, mesh_.frozen(v));
        least_ = std::min(floor_, star_.worst_at(from, -1));
        for (const double share : kShares)
            if (move_to_interface(v, from + share * way, *materials))
                return way.isZero(0) || share == 0;
        move_nearer(v, from);
        return false;
    }

    int64_t moves() const { return moves_; }

private:
    Material winner(const Vec3& x)
    {
        volume_.sample(x, samples_);
        return samples_.material[samples_.best()];
    }

    // A first step; none for a point that is halfway across the gap.
    Vec3 way_to_tie(const Vec3& x, const MaterialSet& materials, unsigned frozen)
    {
        const auto to = materials.size() > 2 ? step_to_tie(volume_, x, materials, frozen, samples_) : std::nullopt;
        if (!to)
            return Vec3(0, 0, 0);
        const double reach = kReachOfGap * star_.reach(x);
        const Vec3 way = *to - x;
        return std::min(1.0, reach / way.norm()) * way;
    }

    bool move_to_interface(int32_t v, const Vec3& near, const MaterialSet& materials)
    {
        find_interfaces(near, materials, mesh_.frozen(v));
        for (const Interface& there : interfaces_) {
            const auto project = [&](Vec3& x) { return project_to(there.pair, x, mesh_.frozen(v)); };
            const Place place = smoother_.climb(star_, there.x, least_, free_axes(mesh_.frozen(v)), project);
            if (place.worst >= least_) {
                move(v, place.x);
                return true;
            }
        }
        return false;
    }

    // Part of the way to the interfaces that were found last.
    void move_nearer(int32_t v, const Vec3& from)
    {
        for (const double share : kPartShares)
            for (const Interface& there : interfaces_) {
                const Vec3 x = from + share * (there.x - from);
                if (star_.worst_at(x, least_) > least_)
                    return move(v, x);
            }
    }

    void move(int32_t v, const Vec3& x)
    {
        mesh_.move(v, x);
        ++moves_;
    }

    bool project_to(const MaterialSet& pair, Vec3& x, unsigned frozen)
    {
        const auto tie = project_to_tie(volume_, x, x, pair, frozen, kReachOfGap * star_.reach(x), samples_);
        x = tie.value_or(x);
        return tie.has_value();
    }

    // Where the material that wins at x ties with each of the others, the nearest first; of two about as near that with
    // the smaller label, which has less to lose.
    void find_interfaces(const Vec3& x, const MaterialSet& materials, unsigned frozen)
    {
        interfaces_.clear();
        const Material first = winner(x);
        for (const Material second : materials) {
            if (second == first)
                continue;
            MaterialSet pair(first);
            pair.unite(MaterialSet(second));
            const auto voxels = static_cast<double>(voxels_[second]);
            Vec3 tie = x;
            if (project_to(pair, tie, frozen))
                interfaces_.push_back({pair, tie, (tie - x).norm() * std::pow(voxels, kSizeCounts)});
        }
        // Of equal costs the lesser material stays first, as MaterialSet lists them.
        std::stable_sort(interfaces_.begin(), interfaces_.end(),
                         [](const Interface& a, const Interface& b) { return a.cost < b.cost; });
    }

    LocalMesh& mesh_;
    const Volume& volume_;
    const Array<int64_t> voxels_;  // of each material
    const double floor_;
    TetStar star_;
    Samples samples_;
    Smoother smoother_;
    Array<Interface> interfaces_;
    int64_t moves_ = 0;
    double least_ = 0;  // quality that must be left around the point
};

// Adds the points of two materials next to them that lie inside another.
void add_points_of_patch(const LocalMesh& mesh, GapRelocator& relocator, Array<int32_t>& without_tie, const Run& run)
{
    Array<uint8_t> seen(mesh.point_count(), 0);
    for (const int32_t v : without_tie)
        seen[v] = 1;
    for (size_t i = 0; i < without_tie.size(); ++i) {
        run.check_at(i, 1 << 8);
        for (const int32_t t : mesh.star(without_tie[i]))
            for (const int32_t w : mesh.tet(t))
                if (!std::exchange(seen[w], uint8_t{1}) && relocator.is_inside_another(w))
                    without_tie.push_back(w);
    }
}

}  // namespace

Array<int32_t> relocate_gaps(LocalMesh& mesh, const Volume& volume, double floor, Array<int32_t> without_tie,
                             const Run& run)
{
    GapRelocator relocator(mesh, volume, floor);
    add_points_of_patch(mesh, relocator, without_tie, run);
    Array<int32_t> left = without_tie;
    int64_t moves = -1;
    for (int round = 0; round < kGapRounds && relocator.moves() != moves; ++round) {
        moves = relocator.moves();
        size_t kept = 0;
        for (size_t i = 0; i < left.size(); ++i) {
            run.check_at(i, 1 << 8);
            if (!relocator.relocate(left[i]))
                left[kept++] = left[i];
        }
        left.resize(kept);
    }
    return without_tie;
}

}  // namespace cleft
