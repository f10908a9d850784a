// Sets that several threads join: those that one thread would have made, named by their least members.
#include "base/disjoint_sets.hpp"
#include "base/parallel.hpp"

#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

void joins_of_threads_make_the_same_sets(void**)
{
    constexpr int32_t kNumbers = 30000, kStep = 6;
    for (const int threads : {1, 2, 8}) {
        Run run;
        run.threads = threads;
        DisjointSets sets(kNumbers);
        // Chains of numbers with one remainder, joined from both ends and in between.
        parallel_for(run, kNumbers - kStep, 10, [&](int64_t begin, int64_t end) {
            for (auto i = static_cast<int32_t>(begin); i < end; ++i) {
                sets.join(i, i + kStep);
                sets.join(kNumbers - 1 - i, kNumbers - 1 - i - kStep);
            }
        });
        const Array<int32_t> least = sets.take();
        for (int32_t i = 0; i < kNumbers; ++i)
            assert_int_equal(least[i], i % kStep);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(joins_of_threads_make_the_same_sets)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
