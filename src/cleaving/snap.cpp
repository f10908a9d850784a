// Visits the vertices next to interfaces, in an order and several passes.
#include "cleaving/snap.hpp"

#include "base/per_worker.hpp"
#include "base/stage.hpp"
#include "cleaving/snap_order.hpp"
#include "cleaving/snap_visit.hpp"
#include "mesh/visit_numbers.hpp"

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
        : materials_(state.c.materials), order_(order), visits_of_(state.vertices_of.size())
    {
        for (int32_t i = 0; i < order.count(); ++i)
            if (const MaterialSet& own = state.c.materials_of(order[i]); own.size() == 1)
                visits_of_[own[0]].push_back(i);
        for (size_t m = 0; m < visits_of_.size(); ++m)
            if (visits_of_[m].count() < state.vertices_of[m])
                visits_of_[m].clear();
    }

    // Adds those that visit i depends on.
    void add_earlier(int64_t i, Array<int32_t>& earlier) const
    {
        const MaterialSet& own = materials_[order_[i]];
        const Array<int32_t>& visits = visits_of_[own[0]];
        if (own.size() == 1 && !visits.empty() && visits.back() == i)
            earlier.insert(earlier.end(), visits.begin(), visits.end() - 1);
    }

private:
    const Array<MaterialSet>& materials_;  // by vertex
    const Array<int32_t>& order_;
    Array<Array<int32_t>> visits_of_;  // by material; none where vertices are left that are not visited
};

OrderedVisits ordered_visits(const SnapState& state, const Array<int32_t>& order, const Run& run)
{
    const VisitNumbers numbers(run, state.c.points.count(), order.count(), [&](int64_t i) { return order[i]; });
    const VisitsOfMaterials of_materials(state, order);
    const auto tet_of = [&](int32_t t) -> const Tet& { return state.c.tets[t]; };
    return {order.count(),
            [&](int64_t i, Array<int32_t>& earlier) {
                numbers.add_earlier(i, state.tets_of.at(order[i]), tet_of, earlier);
                of_materials.add_earlier(i, earlier);
            },
            run};
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
        ordered_visits(state, order, run).visit_all(steps.next(), [&](int worker, int32_t i) {
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
