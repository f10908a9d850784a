// The values of a loop, each once and sorted, are the same for any number of threads and any cut.
#include "base/sorted_set.hpp"

#include "support/cmocka.hpp"

#include <set>

using namespace cleft;

namespace
{

void each_value_comes_once_and_sorted(void**)
{
    const auto value = [](int64_t i) { return static_cast<int32_t>(i * 7919 % 997 / 3); };
    for (const int64_t n : {0, 1, 10, 5000}) {
        std::set<int32_t> wanted;
        for (int64_t i = 0; i < n; ++i)
            wanted.insert(value(i));
        for (const int threads : {1, 3})
            for (const int64_t grain : {1, 64, 1700, 10000}) {
                Run run;
                run.threads = threads;
                const auto found = sorted_set<int32_t>(run, n, grain, [&](int64_t begin, int64_t end, auto& values) {
                    for (int64_t i = begin; i < end; ++i)
                        values.push_back(value(i));
                });
                assert_true(found == Array<int32_t>(wanted.begin(), wanted.end()));
            }
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(each_value_comes_once_and_sorted)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
