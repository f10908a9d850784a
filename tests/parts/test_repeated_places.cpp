// Two points at one place are found, in whatever parts they are.
#include "parts/repeated_places.hpp"
#include "ranks.h"
#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

struct Job {
    Array<Vec3> points;
    int64_t count;
    int found;
};

Messenger messenger_of(const cleft_exchange& e)
{
    return {e.rank, e.ranks, "",
            [e](const int64_t* send, int64_t* receive) { return e.numbers(send, receive, e.user) == 0; },
            [e](const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes) {
                return e.bytes(send, send_sizes, receive, receive_sizes, e.user) == 0;
            }};
}

void look(const cleft_exchange* exchange, void* user)
{
    Job& job = *static_cast<Job*>(user);
    Exchange messages(messenger_of(*exchange));
    job.found = has_repeated_places(job.points, job.count, messages) ? 1 : 0;
}

// What all ranks say.
bool are_repeated(Array<Job> jobs)
{
    const auto ranks = static_cast<int32_t>(jobs.count());
    ranks_run(ranks, look, jobs.data(), sizeof(Job));
    for (const Job& job : jobs)
        assert_int_equal(job.found, jobs[0].found);
    return jobs[0].found == 1;
}

void twins_are_found(void**)
{
    for (const int32_t ranks : {1, 2, 3, 8}) {
        Array<Job> jobs(to_size(ranks));
        for (int32_t r = 0; r < ranks; ++r) {
            for (int i = 0; i < 50; ++i)
                jobs[r].points.emplace_back(r, 0.1 * i, -i);
            jobs[r].count = 50;
            // Behind those that count, the points of others follow.
            jobs[r].points.emplace_back(0, 0, 0);
        }
        assert_false(are_repeated(jobs));
        for (int32_t r = 0; r < ranks; ++r) {
            Array<Job> with_twin = jobs;
            with_twin[r].points[20] = with_twin[0].points[30];
            assert_true(are_repeated(with_twin));
            // A zero has two signs.
            with_twin[r].points[20] = Vec3(-0.0, -0.0, -0.0);
            assert_true(are_repeated(with_twin));
        }
        jobs[ranks - 1].count = 0;
        assert_false(are_repeated(jobs));
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(twins_are_found)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
