// Which visits of points wait for which.
#include "mesh/pending_visits.hpp"

#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

// A row of tetrahedra: each has four points in a row, so that points up to three apart are next to each other.
struct Strip {
    Array<Tet> tets;
    Array<Array<int32_t>> tets_at;

    explicit Strip(int32_t points) : tets_at(points)
    {
        for (int32_t t = 0; t + 3 < points; ++t) {
            tets.push_back({t, t + 1, t + 2, t + 3});
            for (int32_t v = t; v < t + 4; ++v)
                tets_at[v].push_back(t);
        }
    }
};

bool may_begin(const PendingVisits& pending, const Strip& strip, const Array<int32_t>& order, int64_t i)
{
    return pending.may_begin(i, strip.tets_at[order[i]], [&](int32_t t) -> const Tet& { return strip.tets[t]; });
}

void a_visit_waits_for_earlier_ones_next_to_it(void**)
{
    const Strip strip(10);
    const Array<int32_t> order{9, 4, 7, 0, 5};
    Run run;
    run.threads = 2;
    PendingVisits pending(run, 10, order.count(), [&](int64_t i) { return order[i]; });
    assert_true(may_begin(pending, strip, order, 0));   // the first one
    assert_true(may_begin(pending, strip, order, 1));   // 4 is five away from 9
    assert_false(may_begin(pending, strip, order, 2));  // 7 is next to 9 and 4
    assert_true(may_begin(pending, strip, order, 3));   // what is next to 0 is not visited
    assert_false(may_begin(pending, strip, order, 4));  // 5 is next to 4 and 7
    assert_false(pending.is_done(9));
    assert_true(pending.is_done(8));  // not visited
    pending.note_done(9);
    assert_true(pending.is_done(9));
    assert_false(may_begin(pending, strip, order, 2));
    pending.note_done(4);
    assert_true(may_begin(pending, strip, order, 2));
    assert_false(may_begin(pending, strip, order, 4));
    pending.note_done(7);
    assert_true(may_begin(pending, strip, order, 4));
}

void one_thread_keeps_nothing(void**)
{
    const Run run;
    PendingVisits pending(run, 10, 3, [](int64_t i) { return static_cast<int32_t>(i); });
    pending.note_done(2);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(a_visit_waits_for_earlier_ones_next_to_it),
                                cmocka_unit_test(one_thread_keeps_nothing)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
