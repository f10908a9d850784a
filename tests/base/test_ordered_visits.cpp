// Ordered visits: what they make is what the same visits make one after the other, for any number of threads.
#include "base/ordered_visits.hpp"

#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

constexpr int32_t kPoints = 400;

// A number that depends on i alone.
uint32_t scrambled(uint32_t i) { return (i * 2654435761u) ^ (i * 40503u >> 7); }

// Points in a ring with some chords: the points next to each.
using Graph = Array<Array<int32_t>>;

Graph ring_with_chords()
{
    Graph graph(kPoints);
    const auto join = [&](int32_t a, int32_t b) {
        graph[a].push_back(b);
        graph[b].push_back(a);
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
    for (const int32_t other : graph[point])
        sum = 31 * sum + value[other];
    value[point] = 17 * value[point] + sum;
}

// By visit.
class Done
{
public:
    explicit Done(int64_t count) : done_(to_size(count))
    {
        for (auto& one : done_)
            one = 0;
    }
    bool has(int64_t i) const { return done_[i] != 0; }
    void add(int64_t i) { assert_int_equal(done_[i]++, 0); }

private:
    Array<std::atomic<int>> done_;
};

// Those of the same point, and of points next to it, come before.
bool may_begin(const Graph& graph, const Array<int32_t>& order, int64_t i, const Done& done)
{
    for (int32_t j = 0; j < i; ++j)
        if (!done.has(j) &&
            (order[j] == order[i] || std::count(graph[order[i]].begin(), graph[order[i]].end(), order[j]) > 0))
            return false;
    return true;
}

void visits_make_what_they_make_in_their_order(void**)
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
        Array<uint64_t> value(start);
        Done done(order.count());
        visit_in_order(
            run, order.count(), [&](int32_t i) { return may_begin(graph, order, i, done); },
            [&](int worker, int32_t i) {
                assert_in_range(worker, 0, threads - 1);
                visit(graph, value, order[i]);
                done.add(i);
            });
        assert_true(value == wanted);
    }
}

// All visits are made, and made once, in orders of which threads can share little or nothing: each visit depends on one
// that another thread makes.
void visits_that_wait_for_one_another_are_made(void**)
{
    constexpr int64_t kVisits = 5000;
    for (const int32_t back : {1, 300, 1999}) {
        Run run;
        run.threads = 4;
        Done done(kVisits);
        Array<int32_t> steps(kVisits, 0);
        visit_in_order(
            run, kVisits, [&](int32_t i) { return i < back || done.has(i - back); },
            [&](int, int32_t i) {
                steps[i] = 1 + (i >= back ? steps[i - back] : 0);
                done.add(i);
            });
        for (int32_t i = 0; i < kVisits; ++i)
            assert_int_equal(steps[i], 1 + i / back);
    }
}

void no_visits_are_made_of_none(void**)
{
    for (const int threads : {1, 3}) {
        Run run;
        run.threads = threads;
        visit_in_order(
            run, 0, [](int32_t) { return true; }, [](int, int32_t) { fail(); });
    }
}

// An error or a cancel ends all of them.
void an_error_of_a_visit_is_thrown(void**)
{
    Run run;
    run.threads = 3;
    Done done(2000);
    bool is_caught = false;
    try {
        visit_in_order(
            run, 2000, [&](int32_t i) { return i == 0 || done.has(i - 1); },
            [&](int, int32_t i) {
                if (i == 700)
                    throw Error(CLEFT_ERROR_CANCELLED, "enough");
                assert_true(i < 700);
                done.add(i);
            });
    } catch (const Error&) {
        is_caught = true;
    }
    assert_true(is_caught);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(visits_make_what_they_make_in_their_order),
                                cmocka_unit_test(visits_that_wait_for_one_another_are_made),
                                cmocka_unit_test(no_visits_are_made_of_none),
                                cmocka_unit_test(an_error_of_a_visit_is_thrown)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
