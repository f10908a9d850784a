// Visits the vertices next to interfaces, in an order and several passes.
#include "cleaving/snap.hpp"

#include "base/per_worker.hpp"
#include "base/stage.hpp"
#include "cleaving/snap_order.hpp"
#include "cleaving/snap_visit.hpp"
#include "mesh/pending_visits.hpp"

namespace cleft
{

namespace
{

// A snap moves the cuts of its neighbours, which then may snap too. Later passes visit only what has changed.
constexpr int kPasses = 3;

// The last vertex that carries a material alone may not snap. So where all of these are visited, the last one of the
// visits has to know what the others have become.
class VisitsOfMaterials
{
public:
    VisitsOfMaterials(const SnapState& state, const Array<int32_t>& order)
        : order_(order), visits_of_(state.vertices_of.size()), last_of_(order.size(), -1)
    {
        for (int32_t i = 0; i < order.count(); ++i)
            if (const MaterialSet& own = state.c.materials_of(order[i]); own.size() == 1)
                visits_of_[own[0]].push_back(i);
        for (int32_t m = 0; m < visits_of_.count(); ++m)
            if (!visits_of_[m].empty() && visits_of_[m].count() == state.vertices_of[m])
                last_of_[visits_of_[m].back()] = m;
    }

    // Whether those are done that visit i has to know of.
    bool may_begin(int32_t i, const PendingVisits& pending) const
    {
        if (last_of_[i] < 0)
            return true;
        const Array<int32_t>& visits = visits_of_[last_of_[i]];
        return std::all_of(visits.begin(), visits.end() - 1, [&](int32_t j) { return pending.is_done(order_[j]); });
    }

private:
    const Array<int32_t>& order_;
    Array<Array<int32_t>> visits_of_;  // by material: of vertices that carry it alone
    Array<int32_t> last_of_;           // by visit: the material whose last one it is, or -1
};

void visit_all(const SnapState& state, const Array<int32_t>& order, PerWorker<SnapVisitor>& visitors, const Run& run)
{
    PendingVisits pending(run, state.c.points.count(), order.count(), [&](int64_t i) { return order[i]; });
    const VisitsOfMaterials of_materials(state, order);
    const auto tet_of = [&](int32_t t) -> const Tet& { return state.c.tets[t]; };
    visit_in_order(
        run, order.count(),
        [&](int32_t i) {
            return pending.may_begin(i, state.tets_of.at(order[i]), tet_of) && of_materials.may_begin(i, pending);
        },
        [&](int worker, int32_t i) {
            visitors[worker].visit(order[i]);
            pending.note_done(order[i]);
        });
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
        visit_all(state, order, visitors, steps.next());
    }
    SnapCounts counts;
    for (const SnapVisitor& visitor : visitors) {
        counts.moved += visitor.counts().moved;
        counts.stayed += visitor.counts().stayed;
    }
    return counts;
}

}  // namespace cleft
