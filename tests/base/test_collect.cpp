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

void lists_of_parts_are_joined(void**)
{
    struct Part {
        Array<int64_t> numbers;
        Array<char> letters;
    };
    const auto all = [] { return Array<Part>{{{1, 2}, {'a'}}, {}, {{3}, {'b', 'c'}}, {{}, {'d'}}}; };
    for (const int threads : {1, 3}) {
        Run run;
        run.threads = threads;
        Array<Part> parts = all();
        assert_true(joined<int64_t>(run, parts, &Part::numbers) == (Array<int64_t>{1, 2, 3}));
        assert_true(joined<char>(run, parts, &Part::letters) == (Array<char>{'a', 'b', 'c', 'd'}));
        assert_true(joined<char>(run, parts, &Part::letters).empty());
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(items_keep_their_order), cmocka_unit_test(lists_of_parts_are_joined)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
