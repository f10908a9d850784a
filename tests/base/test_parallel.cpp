// Loops over threads: every item once, the error of the lowest chunk, and what a lack of memory does to either.
#include "base/parallel.hpp"

#include <cstdlib>
#include <mutex>
#include <new>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>

#include "support/cmocka.hpp"
#include "support/runs.hpp"

using namespace cleft;
using namespace cleft_test;

// How many allocations still succeed; below 0: all of them.
static std::atomic<int64_t> granted{-1};

void* operator new(size_t size)
{
    void* const block = granted.load() == 0 ? nullptr : std::malloc(size);
    if (!block)
        throw std::bad_alloc();
    if (granted.load() > 0)
        --granted;
    return block;
}
// Not inlined: the compiler would take new and free() for a pair that does not match.
[[gnu::noinline]] static void released(void* block) { std::free(block); }
void operator delete(void* block) noexcept { released(block); }
void operator delete(void* block, size_t) noexcept { released(block); }

namespace
{

constexpr int64_t kItems = 1000, kGrain = 7;

bool each_once(const Array<int>& visits)
{
    return std::all_of(visits.begin(), visits.end(), [](int count) { return count == 1; });
}

void every_item_is_visited_once(void**)
{
    for (const int threads : {1, 2, 5, 1000}) {
        Array<int> visits(kItems, 0);
        parallel_for(with_threads(threads), kItems, kGrain, [&](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i)
                ++visits[i];
        });
        assert_true(each_once(visits));
    }
    bool called = false;
    parallel_for(with_threads(4), 0, kGrain, [&](int64_t, int64_t) { called = true; });
    assert_false(called);
}

void the_error_of_the_lowest_chunk_is_thrown(void**)
{
    for (int repeat = 0; repeat < 20; ++repeat) {
        std::string message;
        try {
            parallel_chunks(with_threads(4), kItems, kGrain, [](int64_t chunk, int64_t, int64_t) {
                if (chunk >= 3)
                    throw std::runtime_error(std::to_string(chunk));
            });
        } catch (const std::runtime_error& error) {
            message = error.what();
        }
        assert_string_equal(message.c_str(), "3");
    }
}

// Either nothing is done and the caller learns of it, or the threads that there are do all of it.
void a_lack_of_memory_ends_nothing_halfway(void**)
{
    bool all_done = false;
    for (int64_t count = 0; !all_done; ++count) {
        Array<int> visits(kItems, 0);
        bool refused = false;
        granted = count;
        try {
            parallel_for(with_threads(4), kItems, kGrain, [&](int64_t begin, int64_t end) {
                for (int64_t i = begin; i < end; ++i)
                    ++visits[i];
            });
        } catch (const std::bad_alloc&) {
            refused = true;
        }
        all_done = granted > 0;
        granted = -1;
        assert_true(refused ? visits == Array<int>(kItems, 0) : each_once(visits));
    }
}

// All loops of a team have the same threads, until these are dismissed.
void a_team_keeps_its_threads(void**)
{
    Team team(4);
    Run run = with_threads(4);
    run.team = &team;
    std::mutex mutex;
    std::set<std::thread::id> ids;
    const auto check_loops = [&] {
        for (int loop = 0; loop < 200; ++loop) {
            Array<int> visits(kItems, 0);
            parallel_for(run, kItems, loop % 2 == 0 ? kGrain : kItems / 2, [&](int64_t begin, int64_t end) {
                for (int64_t i = begin; i < end; ++i)
                    ++visits[i];
                const std::lock_guard<std::mutex> lock(mutex);
                ids.insert(std::this_thread::get_id());
            });
            assert_true(each_once(visits));
        }
    };
    check_loops();
    assert_true(ids.size() <= 4);
    assert_int_equal(ids.count(std::this_thread::get_id()), 1);
    team.dismiss();
    check_loops();
    assert_true(ids.size() <= 7);
}

void a_loop_within_a_loop_of_the_same_team_is_done(void**)
{
    Team team(3);
    Run run = with_threads(3);
    run.team = &team;
    Array<int> visits(kItems, 0);
    parallel_for(run, kItems, kItems / 5, [&](int64_t begin, int64_t end) {
        parallel_for(run, end - begin, kGrain, [&](int64_t inner_begin, int64_t inner_end) {
            for (int64_t i = inner_begin; i < inner_end; ++i)
                ++visits[begin + i];
        });
    });
    assert_true(each_once(visits));
}

// A loop that threads can share adds the time of its thread, one of a single chunk does not.
void time_of_loops_of_several_chunks_is_counted(void**)
{
    std::atomic<int64_t> time{0};
    Run run = with_threads(1);
    run.loop_time = &time;
    const auto work = [](int64_t, int64_t) {
        const double begin = thread_cpu_seconds();
        while (thread_cpu_seconds() < begin + 1e-3)
            ;
    };
    parallel_for(run, 10, 10, work);
    assert_int_equal(time.load(), 0);
    parallel_for(run, 20, 1, work);
    assert_true(time.load() >= 20'000'000);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(every_item_is_visited_once),
                                cmocka_unit_test(the_error_of_the_lowest_chunk_is_thrown),
                                cmocka_unit_test(a_lack_of_memory_ends_nothing_halfway),
                                cmocka_unit_test(a_team_keeps_its_threads),
                                cmocka_unit_test(a_loop_within_a_loop_of_the_same_team_is_done),
                                cmocka_unit_test(time_of_loops_of_several_chunks_is_counted)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
