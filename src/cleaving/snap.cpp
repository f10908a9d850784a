// Visits the vertices next to interfaces, in an order and several passes.
#include "cleaving/snap.hpp"

#include "base/per_worker.hpp"
#include "base/stage.hpp"
#include "base/visit_levels.hpp"
#include "cleaving/snap_order.hpp"
#include "cleaving/snap_visit.hpp"

namespace cleft
{

namespace
{

// A snap moves the cuts of its neighbours, which then may snap too. Later passes visit only what has changed.
constexpr int kPasses = 3;

// By visit: whether it is the last one of a material all of whose vertices are visited. It must know what all of these
// have become, since the last vertex that carries a material may not snap.
Array<uint8_t> last_of_their_material(const SnapState& state, const Array<int32_t>& order)
{
    Array<int64_t> left(state.vertices_of.size());
    for (size_t m = 0; m < left.size(); ++m)
        left[m] = state.vertices_of[m];
    Array<uint8_t> is_last(order.size(), 0);
    for (size_t i = 0; i < order.size(); ++i) {
        const MaterialSet& own = state.c.materials_of(order[i]);
        is_last[i] = own.size() == 1 && --left[own[0]] == 0;
    }
    return is_last;
}

// A visit changes what is at its vertex, and sees the vertices next to it.
VisitLevels levels_of(const SnapState& state, const Array<int32_t>& order, const Run& run)
{
    const Array<uint8_t> is_last = last_of_their_material(state, order);
    Array<int32_t> level_of_material(state.vertices_of.size(), 0);
    VisitLevels levels(state.c.tets.count(), run);
    for (size_t i = 0; i < order.size(); ++i) {
        run.check_at(i, 1 << 12);
        const int32_t v = order[i];
        int32_t& of_material = level_of_material[state.c.materials_of(v)[0]];
        const int32_t level = levels.add(state.tets_of.at(v), is_last[i] ? of_material : 0);
        of_material = std::max(of_material, level + 1);
    }
    return levels;
}

}  // namespace

SnapCounts snap_vertices(Centres& c, Snap rule, const Array<int32_t>& held, const Run& run)
{
    if (rule == Snap::none)
        return {};
    SnapState state(c, rule, held, run);
    PerWorker<SnapVisitor> visitors(run, state);
    // Safe alphas are measured once, before anything moves, so a second pass with them would prove nothing.
    const int passes = rule == Snap::quality ? kPasses : 1;
    Steps steps(run, Array<Step>(passes, {nullptr, 1}));
    for (int pass = 0; pass < passes; ++pass) {
        const Array<int32_t> order = vertices_to_visit(state, kSnapReach, run);
        levels_of(state, order, run).visit_all(steps.next(), [&](int worker, int32_t i) {
            visitors[worker].visit(order[i]);
        });
    }
    SnapCounts counts;
    for (const SnapVisitor& visitor : visitors) {
        counts.moved += visitor.counts().moved;
        counts.stayed += visitor.counts().stayed;
    }
    return counts;
}

}  // namespace cleft
