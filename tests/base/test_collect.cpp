// Lists of chunks joined in order, whatever the number of threads.
#include "base/collect.hpp"

#include "support/cmocka.hpp"

using namespace cleft;

namespace
{

void items_keep_their_order(void**)
{
    constexpr int64_t kItems = 10000, kGrain = 37;
    Array<int64_t> wanted;
    for (int64_t i = 0; i < kItems; ++i)
        wanted.insert(wanted.end(), to_size(i % 3), i);
    for (const int threads : {1, 2, 3, 8}) {
        Run run;
        run.threads = threads;
        const auto found = collect<int64_t>(run, kItems, kGrain, [](int64_t begin, int64_t end, Array<int64_t>& list) {
            for (int64_t i = begin; i < end; ++i)
                list.insert(list.end(), to_size(i % 3), i);
        });
        assert_true(found == wanted);
    }
    assert_true(collect<int>(Run{}, 0, kGrain, [](int64_t, int64_t, Array<int>&) { fail(); }).empty());
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(items_keep_their_order)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
