// What it does to the mesh is noted and taken back if it does not lead to the place.
#include "fitting/room_maker.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Where moving the points around begins, of shape_quality: from less it hardly ever comes to enough.
constexpr double kLeastStart = 0.02;
constexpr int kRoundsAround = 3;
// A neighbour is in the way if it is nearer to the place than so much of its distance from the point.
constexpr double kBeside = 0.7;
// Of the worst quality, which a contraction may leave for the moves that follow.
constexpr double kContractedShare = 0.1;

}  // namespace

bool RoomMaker::settle(int32_t v, const Vec3& on_tie, double least, int worker, Array<int32_t>& unused)
{
    moves_.clear();
    star_.load(mesh_, v);
    if (star_.worst_at(on_tie, least) > least) {
        moves_.apply(mesh_, v, on_tie);
        return true;
    }
    return settle_here(v, on_tie, least) || settle_without_neighbour(v, on_tie, least, worker, unused);
}

void RoomMaker::add_touched_tets(int32_t v, const Vec3& on_tie, Array<int32_t>& tets) const
{
    Array<int32_t> touched = points_around(v);
    const int64_t count = touched.count();
    // A contraction makes the points around the one that goes neighbours of this one.
    for (int64_t i = 0; i < count; ++i)
        if (is_beside(touched[i], v, on_tie)) {
            const Array<int32_t> further = points_around(touched[i]);
            touched.insert(touched.end(), further.begin(), further.end());
        }
    for (const int32_t w : touched)
        tets.insert(tets.end(), mesh_.star(w).begin(), mesh_.star(w).end());
}

bool RoomMaker::settle_here(int32_t v, const Vec3& on_tie, double least)
{
    const Place place = climb(v, on_tie, least);
    if (!(place.worst > kLeastStart))
        return false;
    moves_.clear();
    moves_.apply(mesh_, v, place.x);
    if (place.worst >= least || make_room(v, least))
        return true;
    moves_.undo(mesh_);
    star_.load(mesh_, v);
    return false;
}

// Often the place is taken: a point of an interface lies there, which cleaving has snapped. The point takes it in.
bool RoomMaker::settle_without_neighbour(int32_t v, const Vec3& on_tie, double least, int worker,
                                         Array<int32_t>& unused)
{
    for (const int32_t w : points_around(v)) {
        if (!is_beside(w, v, on_tie))
            continue;
        const int32_t t = mesh_.tet_at(v, w);
        if (!contraction_.find(mesh_, t, mesh_.corner_of(t, w), mesh_.corner_of(t, v), cavity_, kContractedShare))
            continue;
        cavity_.apply_in_place(mesh_, worker);
        star_.load(mesh_, v);
        if (settle_here(v, on_tie, least)) {
            unused.assign(cavity_.old_tets.begin() + cavity_.created.count(), cavity_.old_tets.end());
            return true;
        }
        cavity_.undo_in_place(mesh_, worker);
        star_.load(mesh_, v);
    }
    return false;
}

bool RoomMaker::is_beside(int32_t w, int32_t v, const Vec3& on_tie) const
{
    return (mesh_.point(w) - on_tie).norm() <= kBeside * (mesh_.point(w) - mesh_.point(v)).norm();
}

// The star that is loaded is that of the point.
Place RoomMaker::climb(int32_t v, const Vec3& from, double least)
{
    constraint_.set(mesh_, star_.tets(), from, from, mesh_.frozen(v), star_.reach(from), 0);
    if (constraint_.fixed())
        return {from, star_.worst_at(from, -1)};
    return smoother_.climb(star_, from, least, constraint_.tangent(), [&](Vec3& x) { return constraint_.project(x); });
}

// The points around a point move on their ties until all tetrahedra are good enough.
bool RoomMaker::make_room(int32_t v, double least)
{
    const Array<int32_t> around = points_around(v);
    for (int round = 0; round < kRoundsAround; ++round) {
        for (const int32_t w : around) {
            star_.load(mesh_, w);
            const Vec3 from = mesh_.point(w);
            const double before = star_.worst_at(from, -1);
            if (before >= least)
                continue;
            const Place place = climb(w, from, least);
            if (place.worst > before)
                moves_.apply(mesh_, w, place.x);
        }
        if (is_good(v, least))
            return std::all_of(moves_.made.begin(), moves_.made.end(),
                               [&](const PointMove& m) { return is_good(m.point, least); });
    }
    return false;
}

bool RoomMaker::is_good(int32_t v, double least)
{
    star_.load(mesh_, v);
    return star_.worst_at(mesh_.point(v), -1) >= least;
}

Array<int32_t> RoomMaker::points_around(int32_t v) const
{
    Array<int32_t> points;
    for (const int32_t t : mesh_.star(v))
        for (const int32_t w : mesh_.tet(t))
            if (w != v)
                points.push_back(w);
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

}  // namespace cleft
