// Visits by levels: what they make is what the same visits make one after the other, for any number of threads.
#include "base/visit_levels.hpp"

#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

constexpr int32_t kPoints = 400;

// A number that depends on i alone.
uint32_t scrambled(uint32_t i) { return (i * 2654435761u) ^ (i * 40503u >> 7); }

// Points in a ring with some chords: the points next to each, and the edges at each.
struct Graph {
    Array<Array<int32_t>> next, edges_at;
    int32_t edges = 0;
};

Graph ring_with_chords()
{
    Graph graph{Array<Array<int32_t>>(kPoints), Array<Array<int32_t>>(kPoints)};
    const auto join = [&](int32_t a, int32_t b) {
        graph.next[a].push_back(b);
        graph.next[b].push_back(a);
        graph.edges_at[a].push_back(graph.edges);
        graph.edges_at[b].push_back(graph.edges++);
    };
    for (int32_t a = 0; a < kPoints; ++a) {
        join(a, (a + 1) % kPoints);
        if (a % 3 == 0)
            join(a, static_cast<int32_t>(scrambled(static_cast<uint32_t>(a)) % kPoints));
    }
    return graph;
}

Array<int32_t> order_of_visits()
{
    Array<int32_t> order;
    for (uint32_t i = 0; i < 3 * kPoints; ++i)
        order.push_back(static_cast<int32_t>(scrambled(i + 17) % kPoints));
    return order;
}

// Any other order of two visits that touch gives other values.
void visit(const Graph& graph, Array<uint64_t>& value, int32_t point)
{
    uint64_t sum = 0;
    for (const int32_t other : graph.next[point])
        sum = 31 * sum + value[other];
    value[point] = 17 * value[point] + sum;
}

void visits_by_levels_are_visits_in_order(void**)
{
    const Graph graph = ring_with_chords();
    const auto order = order_of_visits();
    Array<uint64_t> start(kPoints);
    for (int32_t i = 0; i < kPoints; ++i)
        start[i] = scrambled(static_cast<uint32_t>(i));
    Array<uint64_t> wanted(start);
    for (const int32_t point : order)
        visit(graph, wanted, point);

    for (const int threads : {1, 2, 5}) {
        Run run;
        run.threads = threads;
        VisitLevels levels(graph.edges, run);
        int32_t greatest = 0;
        for (const int32_t point : order)
            greatest = std::max(greatest, levels.add(graph.edges_at[point]));
        // Far fewer levels than visits, or nothing would be gained.
        assert_true(threads == 1 || (greatest > 0 && greatest < order.count() / 10));
        Array<uint64_t> value(start);
        levels.visit_all(run, [&](int worker, int32_t i) {
            assert_in_range(worker, 0, threads - 1);
            visit(graph, value, order[i]);
        });
        assert_true(value == wanted);
    }
}

void a_visit_has_at_least_the_level_asked_for(void**)
{
    Run run;
    run.threads = 2;
    VisitLevels levels(2, run);
    const std::array<int32_t, 1> first{0}, second{1};
    assert_int_equal(levels.add(first), 0);
    assert_int_equal(levels.add(second, 5), 5);
    assert_int_equal(levels.add(std::array<int32_t, 2>{0, 1}), 6);
    assert_int_equal(levels.add(first), 7);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(visits_by_levels_are_visits_in_order),
                                cmocka_unit_test(a_visit_has_at_least_the_level_asked_for)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
