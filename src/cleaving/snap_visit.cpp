// Tries to snap a vertex to the cuts near it, and keeps what leaves the best shapes.
#include "cleaving/snap_visit.hpp"

#include "base/shared_access.hpp"

#include <limits>

namespace cleft
{

namespace
{

// An interface is then off its tie by as much. A larger share would misplace it further; a smaller one would leave thin
// pieces at vertices that walls hold.
constexpr double kStay = 0.2;  // how close a cut must be to be taken over in place, in its edge
// The background is not warped below 13.3 or above 163.5 degrees, unless it gets better: tetrahedra between vertices
// that all snapped are in the mesh as they are, and this keeps them within the bound of isosurface stuffing.
constexpr double kLeastQuality = 0.23;
// With n cuts a visit makes up to 2 n - 1 attempts. The nearest cuts leave the thinnest pieces, so they matter most.
constexpr size_t kMostCuts = 6;  // at one vertex, nearest first
// More than four have no tie, so the vertex goes to a cut or stays. So many materials meet in noise only, and
// MaterialSet holds 15.
constexpr int kMostMaterials = 10;  // at one vertex
// A greater cost would keep bad angles to save thin parts. A smaller one would break parts for a small gain.
constexpr double kPinchCost = 500;  // a pinched interface is as bad as a tetrahedron of 1.5 degrees

Array<std::atomic<int64_t>> vertices_of_materials(const Centres& c)
{
    Array<std::atomic<int64_t>> vertices_of(c.volume.material_count());
    for (auto& count : vertices_of)
        count = 0;
    for (const MaterialSet& m : c.materials)
        ++vertices_of[m[0]];
    return vertices_of;
}

}  // namespace

SnapState::SnapState(Centres& centres, Snap snap_rule, const Array<int32_t>& held_vertices, const Run& run)
    : c(centres),
      rule(snap_rule),
      held(held_vertices),
      tets_of(c, run),
      touched(c.points.size(), 1),
      vertices_of(vertices_of_materials(c))
{
    if (rule == Snap::safe)
        safe_reach = find_safe_reach(c, tets_of, run);
}

void SnapVisitor::visit(int32_t v)
{
    // First, because a snap below marks this vertex again.
    store_shared<uint8_t>(state_.touched[v], 0);
    gather(v);
    if (near_.empty() || state_.is_last_of_material(v))
        return;
    frozen_ = star_.frozen_axes();
    before_.save(c_, star_);
    measure_star(c_, star_, shape_before_);
    if (find_best())
        take_best();
}

void SnapVisitor::gather(int32_t v)
{
    star_.gather(v);
    near_.clear();
    for (const int32_t e : star_.edges()) {
        const CutEdge& edge = c_.edges[e];
        const Vec3 x = c_.cut_point(edge);
        const int32_t other = edge.lower == v ? edge.upper : edge.lower;
        const double distance = std::sqrt(c_.metrics.square_on_edge(v, other, x - c_.point(v)));
        if (distance <= reach(e))
            near_.push_back({distance, x, e, other});
    }
    std::sort(near_.begin(), near_.end(), [](const NearCut& a, const NearCut& b) {
        // Equal distances go by number. The order of attempts decides between equal costs, so it must be the same in
        // every run.
        return a.distance != b.distance ? a.distance < b.distance : a.edge < b.edge;
    });
    if (near_.size() > kMostCuts)
        near_.resize(kMostCuts);
}

// How far along an edge at the vertex a cut may be to be snapped to.
double SnapVisitor::reach(int32_t edge) const
{
    if (state_.rule != Snap::safe)
        return kSnapReach * star_.shortest_edge();
    return state_.safe_reach[edge][c_.edges[edge].upper == star_.vertex()];
}

bool SnapVisitor::find_best()
{
    // The paper's rule snaps whatever is within alpha. So there any finite cost counts as better.
    const bool by_quality = state_.rule == Snap::quality;
    best_shape_.cost = by_quality ? shape_before_.cost : std::numeric_limits<double>::infinity();
    tried_.clear();
    bool found = false;
    if (by_quality) {
        for (size_t i = 0; i < near_.size(); ++i) {
            found |= attempt({i, i});
            if (i > 0)
                found |= attempt({0, i});
        }
        return found;
    }
    found = attempt({0, near_.size() - 1});
    tried_.clear();  // of two materials the nearest cut alone may do where all did not
    return found || attempt({0, 0});
}

void SnapVisitor::take_best()
{
    CLEFT_ASSERT(std::isfinite(best_shape_.cost));  // all tetrahedra around are positive
    CLEFT_ASSERT(std::includes(best_.materials.begin(), best_.materials.end(), before_.materials.begin(),
                               before_.materials.end()));
    if (before_.materials.size() == 1) {
        CLEFT_ASSERT(state_.vertices_of[before_.materials[0]] > 1);
        --state_.vertices_of[before_.materials[0]];
    }
    keep_materials();
    best_.restore(c_, star_);
    ++(best_.x == before_.x ? counts_.stayed : counts_.moved);
    for (size_t i = 0; i < star_.parts().size(); ++i)
        if (star_.parts()[i].mixed >= 0)
            c_.fans[star_.parts()[i].mixed] = best_shape_.fans[i];
    mark_around();
}

// What other visits write here at the same time is the same: vertices of theirs are not next to this one.
void SnapVisitor::mark_around()
{
    for (const int32_t w : star_.link()) {
        store_shared<uint8_t>(state_.touched[w], 1);
        if (!best_is_sound_)
            store_shared<uint8_t>(c_.doubtful[w], 1);
    }
    store_shared<uint8_t>(state_.touched[star_.vertex()], 1);
    store_shared<uint8_t>(c_.doubtful[star_.vertex()], best_is_sound_ ? 0 : 1);
}

// Between two materials, a tetrahedron whose corners come to share both keeps the one that they shared before.
void SnapVisitor::keep_materials()
{
    if (best_.materials.size() != 2 || before_.materials.size() != 1)
        return;
    for (const CutStar::Part& part : star_.parts()) {
        const Tet& corners = c_.corners(part.tet);
        const auto will_have_both = [&](int32_t v) {
            return v == star_.vertex() || c_.materials_of(v) == best_.materials;
        };
        if (std::all_of(corners.begin(), corners.end(), will_have_both))
            c_.kept[part.tet] = static_cast<uint16_t>(before_.materials[0]);
    }
}

// Keeps the state in best_ if it is the best so far.
// Restores the vertex in any case. A set of materials is tried once, since it has one tie.
bool SnapVisitor::attempt(const Choice& choice)
{
    MaterialSet materials = before_.materials;
    Vec3 start(0, 0, 0);
    bool may_stay = true;
    for (size_t i = choice.first; i <= choice.last; ++i) {
        const NearCut& cut = near_[i];
        if (!materials.unite(c_.materials_of(cut.other)))
            return false;
        start += cut.x;
        may_stay &= (cut.x - before_.x).norm() <= kStay * (c_.point(cut.other) - before_.x).norm();
    }
    if (materials.size() > kMostMaterials || std::find(tried_.begin(), tried_.end(), materials) != tried_.end())
        return false;
    tried_.push_back(materials);
    start /= static_cast<double>(choice.last - choice.first + 1);
    const double most = c_.metrics.greatest_distance(star_.vertex(), kSnapReach * star_.shortest_edge());
    auto x = project_to_tie(c_.volume, before_.x, start, materials, frozen_, most, scratch_);
    // The cut was found on its edge, close to the tie of the two ends. It will do where Newton's steps do not
    // converge.
    if (!x && choice.first == choice.last && keeps_walls(near_[choice.first].x))
        x = near_[choice.first].x;
    if (!x && !may_stay)
        return false;
    const bool better = improves(x ? *x : before_.x, materials);
    before_.restore(c_, star_);
    return better;
}

bool SnapVisitor::keeps_walls(const Vec3& x) const
{
    for (int axis = 0; axis < 3; ++axis)
        if ((frozen_ >> axis & 1u) && x[axis] != before_.x[axis])
            return false;
    return true;
}

// Changes the vertex. If the star is the best so far, the state is kept in best_.
// Cheap tests come first: the background alone, then new cuts and fans, and last the surface of the star.
bool SnapVisitor::improves(const Vec3& x, const MaterialSet& materials)
{
    change_vertex(c_, star_, x, materials);
    measure_background(c_, star_, shape_);
    const bool warped =
        shape_.least_background < kLeastQuality && shape_.least_background < shape_before_.least_background;
    if (warped || !(shape_.cost < best_shape_.cost))
        return false;
    const bool moved = x != before_.x;
    if (moved) {
        c_.volume.sample(x, scratch_);
        c_.samples.set(star_.vertex(), arena_.add(scratch_));
    }
    place_cuts(c_, star_, scratch_);
    measure_fans(c_, star_, best_shape_.cost, shape_);
    using Finding = PinchCheck::Finding;
    Finding finding = Finding::unknown;
    if (shape_.cost < best_shape_.cost) {
        finding = pinch_.look(star_, before_.materials);
        shape_.cost += finding == Finding::pinched ? kPinchCost : 0;
    }
    const bool better = shape_.cost < best_shape_.cost;
    if (better) {
        best_is_sound_ = finding == Finding::sound;
        best_.save(c_, star_);
        std::swap(best_shape_, shape_);
    } else if (moved) {
        arena_.drop(c_.samples.of(star_.vertex()));
    }
    return better;
}

}  // namespace cleft
