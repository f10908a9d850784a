// Items that arrive in runs come in order, in memory and from disk, however many there are.
#include "parts/sorted_runs.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"

using namespace cleft;
using namespace cleft_test;

namespace
{

struct Item {
    int64_t number;
    double place;
    bool operator<(const Item& o) const { return number < o.number; }
};

Array<int64_t> numbers_in(const SortedRuns<Item>& runs)
{
    Array<int64_t> numbers;
    runs.visit_all([&](const Item& item) {
        assert_true(item.place == 0.5 * static_cast<double>(item.number));
        numbers.push_back(item.number);
    });
    return numbers;
}

void check_runs(const std::string& scratch, const Array<int64_t>& sizes, int64_t range)
{
    SortedRuns<Item> runs(scratch);
    Array<int64_t> expected;
    Random random(1 + static_cast<uint64_t>(range));
    for (const int64_t size : sizes) {
        Array<Item> items;
        for (int64_t i = 0; i < size; ++i) {
            const auto number = static_cast<int64_t>(random.unit() * static_cast<double>(range));
            items.push_back({number, 0.5 * static_cast<double>(number)});
            expected.push_back(number);
        }
        runs.add(std::move(items));
    }
    std::sort(expected.begin(), expected.end());
    expected.erase(std::unique(expected.begin(), expected.end()), expected.end());
    assert_true(numbers_in(runs) == expected);
    assert_true(numbers_in(runs) == expected);  // once more, from the start
}

void items_of_all_runs_come_in_order(void**)
{
    for (const std::string scratch : {"", "."}) {
        check_runs(scratch, {}, 1);
        check_runs(scratch, {0, 0}, 1);
        check_runs(scratch, {1, 0, 1}, 1);
        check_runs(scratch, {3, 2000, 0, 7000, 1}, 100);      // most of them many times
        check_runs(scratch, {2048, 2049, 4096}, 1000000000);  // runs that end with what is read at once, and beyond it
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {cmocka_unit_test(items_of_all_runs_come_in_order)};
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
