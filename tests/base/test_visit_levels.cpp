// Visits by levels: what they make is what the same visits make one after the other, for any number of threads.
#include "base/visit_levels.hpp"

#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

constexpr int32_t kPlaces = 400;

// A number that depends on i alone.
uint32_t scrambled(uint32_t i) { return (i * 2654435761u) ^ (i * 40503u >> 7); }

// Places in a ring with some chords; the edges go both ways.
Array<Array<int32_t>> neighbours()
{
    Array<Array<int32_t>> next(kPlaces);
    const auto join = [&](int32_t a, int32_t b) {
        next[a].push_back(b);
        next[b].push_back(a);
    };
    for (int32_t a = 0; a < kPlaces; ++a) {
        join(a, (a + 1) % kPlaces);
        if (a % 3 == 0)
            join(a, static_cast<int32_t>(scrambled(static_cast<uint32_t>(a)) % kPlaces));
    }
    return next;
}

Array<int32_t> order_of_visits()
{
    Array<int32_t> order;
    for (uint32_t i = 0; i < 3 * kPlaces; ++i)
        order.push_back(static_cast<int32_t>(scrambled(i + 17) % kPlaces));
    return order;
}

// Any other order of two visits that touch gives other values.
void visit(const Array<Array<int32_t>>& next, Array<uint64_t>& value, int32_t place)
{
    uint64_t sum = 0;
    for (const int32_t other : next[place])
        sum = 31 * sum + value[other];
    value[place] = 17 * value[place] + sum;
}

void visits_by_levels_are_visits_in_order(void**)
{
    const auto next = neighbours();
    const auto order = order_of_visits();
    Array<uint64_t> start(kPlaces);
    for (int32_t i = 0; i < kPlaces; ++i)
        start[i] = scrambled(static_cast<uint32_t>(i));
    Array<uint64_t> wanted(start);
    for (const int32_t place : order)
        visit(next, wanted, place);

    VisitLevels levels(kPlaces);
    int32_t greatest = 0;
    for (const int32_t place : order)
        greatest = std::max(greatest, levels.add(next[place], std::array<int32_t, 1>{place}));
    // Far fewer levels than visits, or nothing would be gained.
    assert_true(greatest > 0 && greatest < order.count() / 10);
    for (const int threads : {1, 2, 5}) {
        Run run;
        run.threads = threads;
        Array<uint64_t> value(start);
        levels.visit_all(run, [&](int worker, int32_t i) {
            assert_in_range(worker, 0, threads - 1);
            visit(next, value, order[i]);
        });
        assert_true(value == wanted);
    }
}

void a_visit_has_at_least_the_level_asked_for(void**)
{
    VisitLevels levels(2);
    const std::array<int32_t, 1> first{0}, second{1};
    assert_int_equal(levels.add(first, first), 0);
    assert_int_equal(levels.add(second, second, 5), 5);
    assert_int_equal(levels.add(first, second), 6);
    assert_int_equal(levels.add(first, first), 1);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(visits_by_levels_are_visits_in_order),
                                cmocka_unit_test(a_visit_has_at_least_the_level_asked_for)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
