// Groups by key: the values of each key in the order of the items, for every number of threads and of keys.
#include "base/counting_sort.hpp"

#include "support/cmocka.hpp"
#include "support/runs.hpp"

using namespace cleft;
using namespace cleft_test;

namespace
{

using Sorted = Groups<uint32_t, int32_t>;

// Item i gives i % 4 values, to keys that go to and fro.
Sorted sorted(int64_t items, int64_t keys, int threads)
{
    return group_by_key<uint32_t, int32_t>(with_threads(threads), items, keys, [&](int64_t item, const auto& give) {
        for (int64_t k = 0; k < item % 4; ++k)
            give((item * 37 + k * 11) % keys, static_cast<int32_t>(4 * item + k));
    });
}

// The same without any sorting.
Sorted expected(int64_t items, int64_t keys)
{
    Array<Array<int32_t>> lists(keys);
    for (int64_t item = 0; item < items; ++item)
        for (int64_t k = 0; k < item % 4; ++k)
            lists[(item * 37 + k * 11) % keys].push_back(static_cast<int32_t>(4 * item + k));
    Sorted out;
    out.start.push_back(0);
    for (const Array<int32_t>& list : lists) {
        out.values.insert(out.values.end(), list.begin(), list.end());
        out.start.push_back(static_cast<uint32_t>(out.values.size()));
    }
    return out;
}

void values_keep_the_order_of_items(void**)
{
    for (const int64_t items : {0, 1, 2, 5, 1000, 70000})
        for (const int64_t keys : {1, 7, 500, 40000}) {
            const Sorted wanted = expected(items, keys);
            for (const int threads : {1, 2, 3, 8, 1000}) {
                const Sorted found = sorted(items, keys, threads);
                assert_true(found.start == wanted.start);
                assert_true(found.values == wanted.values);
            }
        }
}

void without_keys_there_is_nothing(void**)
{
    const Sorted found = group_by_key<uint32_t, int32_t>(with_threads(4), 100, 0, [](int64_t, const auto&) {});
    assert_int_equal(found.start.size(), 1);
    assert_true(found.values.empty());
}

void tables_take_two_entries_an_item_at_most(void**)
{
    constexpr int64_t kItems = 1000;
    for (const int64_t keys : {1, 100, 999, 2001, 5000}) {
        const int64_t parts = chunk_count(kItems, items_of_part(with_threads(64), kItems, keys));
        assert_true((parts - 1) * keys <= 2 * kItems);
        assert_true(parts <= 64);
    }
    assert_int_equal(items_of_part(with_threads(1), kItems, 1), kItems);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(values_keep_the_order_of_items),
        cmocka_unit_test(without_keys_there_is_nothing),
        cmocka_unit_test(tables_take_two_entries_an_item_at_most),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
