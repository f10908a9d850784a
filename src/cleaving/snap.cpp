// Visits the vertices next to interfaces one by one, and gives each the best of a few changes that would snap it.
#include "cleaving/snap.hpp"

#include "base/stage.hpp"
#include "cleaving/pinch.hpp"
#include "cleaving/snap_order.hpp"
#include "cleaving/star.hpp"

#include <limits>

namespace cleft
{

namespace
{

// Half, as in the paper: then the balls around two vertices do not overlap. A larger reach would let both ends of an
// edge claim its cut.
constexpr double kSnapReach = 0.5;  // how far a cut may be to be snapped to, in shortest edges at the vertex
// An interface is then off its tie by as much. A larger share would misplace it further; a smaller one would leave thin
// pieces at vertices that walls hold.
constexpr double kStay = 0.2;  // how close a cut must be to be taken over in place, in its edge
// The background is not warped below 13.3 or above 163.5 degrees, unless it gets better: tetrahedra between vertices
// that all snapped are in the mesh as they are, and this keeps them within the bound of isosurface stuffing.
constexpr double kLeastQuality = 0.23;
// A snap moves the cuts of its neighbours, which then may snap too. Later passes visit only what has changed.
constexpr int kPasses = 3;
// With n cuts a visit makes up to 2 n - 1 attempts. The nearest cuts leave the thinnest pieces, so they matter most.
constexpr size_t kMostCuts = 6;  // at one vertex, nearest first
// More than four have no tie, so the vertex goes to a cut or stays. So many materials meet in noise only, and
// MaterialSet holds 15.
constexpr int kMostMaterials = 10;  // at one vertex
// A greater cost would keep bad angles to save thin parts. A smaller one would break parts for a small gain.
constexpr double kPinchCost = 500;  // a pinched interface is as bad as a tetrahedron of 1.5 degrees

struct NearCut {
    double distance;
    Vec3 x;
    int32_t edge, other;  // the end that is not the vertex
};

// A choice among the near cuts: the one at `last` alone, or all from the nearest up to it.
// One cut leads to an interface; several lead to the line or the point where their interfaces meet.
struct Choice {
    size_t first, last;
};

class Snapper
{
public:
    Snapper(Centres& c, Snap rule, const Run& run)
        : c_(c),
          rule_(rule),
          run_(run),
          star_(c, run),
          pinch_(c),
          touched_(c.points.size(), 1),
          vertices_of_(c.volume.material_count(), 0)
    {
        for (const MaterialSet& m : c.materials)
            ++vertices_of_[m[0]];
        if (rule == Snap::safe)
            find_safe_reach();
    }

    SnapCounts run()
    {
        // Safe alphas are measured once, before anything moves, so a second pass with them would prove nothing.
        const int passes = rule_ == Snap::quality ? kPasses : 1;
        Steps steps(run_, Array<Step>(passes, {nullptr, 1}));
        for (int pass = 0; pass < passes; ++pass) {
            const Array<int32_t> order = vertices_to_visit(c_, kSnapReach, touched_, run_);
            steps.next().for_each(order.count(), [&](int64_t i) { visit(order[i]); });
        }
        return counts_;
    }

private:
    void gather(int32_t v)
    {
        star_.gather(v);
        near_.clear();
        for (const int32_t e : star_.edges()) {
            const CutEdge& edge = c_.edges[e];
            const Vec3 x = c_.cut_point(edge);
            const double distance = (x - c_.point(v)).norm();
            if (distance <= reach(e))
                near_.push_back({distance, x, e, edge.lower == v ? edge.upper : edge.lower});
        }
        std::sort(near_.begin(), near_.end(), [](const NearCut& a, const NearCut& b) {
            // Equal distances go by number. The order of attempts decides between equal costs, so it must be the same
            // in every run.
            return a.distance != b.distance ? a.distance < b.distance : a.edge < b.edge;
        });
        if (near_.size() > kMostCuts)
            near_.resize(kMostCuts);
    }

    // How far along an edge at the vertex a cut may be to be snapped to.
    double reach(int32_t edge) const
    {
        if (rule_ != Snap::safe)
            return kSnapReach * star_.shortest_edge();
        return safe_reach_[edge][c_.edges[edge].upper == star_.vertex()];
    }

    // The paper's alpha, half of the shortest edge or altitude, does not see two opposite edges whose four ends move
    // towards each other: half of their distance, too, must be left. On a body-centred cubic lattice that makes 0.25 of
    // a long edge and 0.41 of a short one, the alphas of Labelle and Shewchuk. All is measured before anything moves.
    void find_safe_reach()
    {
        safe_reach_.resize(c_.edges.size());
        for (int32_t v = 0; v < static_cast<int32_t>(c_.points.size()); ++v) {
            run_.check_at(v, 1024);
            star_.gather(v);
            if (star_.edges().empty())
                continue;
            const double alpha = std::min(star_.shortest_edge(), star_.least_altitude());
            for (const int32_t e : star_.edges()) {
                const CutEdge& edge = c_.edges[e];
                const Vec3 direction = (c_.point(edge.upper) - c_.point(edge.lower)).normalized();
                safe_reach_[e][edge.upper == v] = kSnapReach * std::min(alpha, star_.width_along(direction));
            }
        }
    }

    void visit(int32_t v)
    {
        // First, because a snap below marks this vertex again.
        touched_[v] = 0;
        gather(v);
        if (near_.empty() || is_last_of_material())
            return;
        frozen_ = star_.frozen_axes();
        before_.save(c_, star_);
        measure_star(c_, star_, shape_before_);
        // The paper's rule snaps whatever is within alpha. So there any finite cost counts as better.
        best_shape_.cost = rule_ == Snap::quality ? shape_before_.cost : std::numeric_limits<double>::infinity();
        tried_.clear();
        bool found = false;
        if (rule_ == Snap::quality) {
            for (size_t i = 0; i < near_.size(); ++i) {
                found |= attempt({i, i});
                if (i > 0)
                    found |= attempt({0, i});
            }
        } else {
            found = attempt({0, near_.size() - 1});
            tried_.clear();  // of two materials the nearest cut alone may do where all did not
            found = found || attempt({0, 0});
        }
        if (found)
            take_best();
    }

    // Tetrahedra at a vertex of one material alone are of that material: a label that keeps such a vertex is not lost.
    bool is_last_of_material() const
    {
        const MaterialSet& own = c_.materials_of(star_.vertex());
        return own.size() == 1 && vertices_of_[own[0]] == 1;
    }

    void take_best()
    {
        CLEFT_ASSERT(std::isfinite(best_shape_.cost));  // all tetrahedra around are positive
        CLEFT_ASSERT(std::includes(best_.materials.begin(), best_.materials.end(), before_.materials.begin(),
                                   before_.materials.end()));
        if (before_.materials.size() == 1) {
            CLEFT_ASSERT(vertices_of_[before_.materials[0]] > 1);
            --vertices_of_[before_.materials[0]];
        }
        keep_materials();
        best_.restore(c_, star_);
        ++(best_.x == before_.x ? counts_.stayed : counts_.moved);
        for (size_t i = 0; i < star_.parts().size(); ++i)
            if (star_.parts()[i].mixed >= 0)
                c_.fans[star_.parts()[i].mixed] = best_shape_.fans[i];
        for (const int32_t w : star_.link()) {
            touched_[w] = 1;
            c_.doubtful[w] |= !best_is_sound_;
        }
        touched_[star_.vertex()] = 1;
        c_.doubtful[star_.vertex()] = !best_is_sound_;
    }

    // Between two materials, a tetrahedron whose corners come to share both keeps the one that they shared before.
    void keep_materials()
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
    bool attempt(const Choice& choice)
    {
        MaterialSet materials = before_.materials;
        Vec3 start(0, 0, 0);
        bool may_stay = true;
        for (size_t i = choice.first; i <= choice.last; ++i) {
            const NearCut& cut = near_[i];
            if (!materials.unite(c_.materials_of(cut.other)))
                return false;
            start += cut.x;
            may_stay &= cut.distance <= kStay * (c_.point(cut.other) - before_.x).norm();
        }
        if (materials.size() > kMostMaterials || std::find(tried_.begin(), tried_.end(), materials) != tried_.end())
            return false;
        tried_.push_back(materials);
        start /= static_cast<double>(choice.last - choice.first + 1);
        auto x = project_to_tie(c_.volume, before_.x, start, materials, frozen_, kSnapReach * star_.shortest_edge(),
                                scratch_);
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

    bool keeps_walls(const Vec3& x) const
    {
        for (int axis = 0; axis < 3; ++axis)
            if ((frozen_ >> axis & 1u) && x[axis] != before_.x[axis])
                return false;
        return true;
    }

    // Changes the vertex. If the star is the best so far, the state is kept in best_.
    // Cheap tests come first: the background alone, then new cuts and fans, and last the surface of the star.
    bool improves(const Vec3& x, const MaterialSet& materials)
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
            c_.samples.set(star_.vertex(), c_.samples.add(scratch_));
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
            c_.samples.drop(c_.samples.of(star_.vertex()));
        }
        return better;
    }

    Centres& c_;
    const Snap rule_;
    const Run& run_;
    CutStar star_;
    PinchCheck pinch_;
    Array<uint8_t> touched_;                   // by vertex: something in its star changed since its last visit
    Array<int64_t> vertices_of_;               // by material: how many carry it alone
    Array<FixedArray<double, 2>> safe_reach_;  // by edge: from its lower and its upper end; of Snap::safe
    SnapCounts counts_;

    // Of the vertex being visited.
    unsigned frozen_ = 0;
    Array<NearCut> near_;
    Array<MaterialSet> tried_;
    StarState before_, best_;
    StarShape shape_before_, best_shape_, shape_;
    bool best_is_sound_ = false;
    Samples scratch_;
};

}  // namespace

SnapCounts snap_vertices(Centres& c, Snap rule, const Run& run)
{
    if (rule == Snap::none)
        return {};
    return Snapper(c, rule, run).run();
}

}  // namespace cleft
