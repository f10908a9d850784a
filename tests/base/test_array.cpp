// Arrays that any integer indexes, and assertions: on where the build asks for them, else without a trace.
#include "base/array.hpp"
#include "base/fixed_array.hpp"
#include "base/large_pages.hpp"
#include "support/cmocka.hpp"

#include <sys/wait.h>
#include <unistd.h>

#include <csignal>

using namespace cleft;

namespace
{

// Whether work() ends the process as a failed assertion does.
template <class Work>
bool is_ended_by(const Work& work)
{
    const pid_t child = fork();
    if (child == 0) {
        if (!freopen("/dev/null", "w", stderr))
            _exit(2);
        work();
        _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    return WIFSIGNALED(status) && WTERMSIG(status) == SIGABRT;
}

void any_integer_is_an_index(void**)
{
    Array<int> a(int64_t{5}, 7);
    a[int32_t{1}] = 1;
    a[int64_t{2}] = 2;
    a[size_t{3}] = 3;
    a[uint8_t{4}] = 4;
    const Array<int>& same = a;
    for (int32_t i = 1; i < 5; ++i)
        assert_int_equal(same[i], i);
    assert_int_equal(same[0], 7);
    assert_int_equal(a.count(), 5);
    a.resize(int32_t{2});
    a.assign(int64_t{3}, 9);
    assert_true(a == Array<int>({9, 9, 9}));
}

void arrays_and_vectors_move_into_each_other(void**)
{
    Array<double> a = large_array<double>(100, 0.5);
    const double* const data = a.data();
    std::vector<double> vector = std::move(a);
    assert_ptr_equal(vector.data(), data);
    a = std::move(vector);
    assert_ptr_equal(a.data(), data);
    // No reference to an Array is one to a temporary copy of a vector.
    static_assert(!std::is_convertible_v<const std::vector<double>&, const Array<double>&>);
    static_assert(std::is_convertible_v<const Array<double>&, const std::vector<double>&>);
}

void fixed_arrays_are_plain_values(void**)
{
    constexpr FixedArray<int32_t, 3> dims{2, 3, 4};
    static_assert(sizeof dims == 3 * sizeof(int32_t) && dims[int8_t{2}] == 4);
    const auto [x, y, z] = dims;
    assert_int_equal(100 * x + 10 * y + z, 234);
    FixedArray<int32_t, 3> other{};
    other = std::array<int32_t, 3>{2, 3, 4};
    assert_true(other == dims);
    other = {2, 3, 5};
    assert_true(dims < other);
}

void a_failed_assertion_ends_the_process(void**)
{
    int evaluated = 0;
    CLEFT_ASSERT(++evaluated > 0);
    Array<int> a(3);
    FixedArray<int, 3> b{};
    volatile int past = 3, before = -1;
#ifdef CLEFT_ASSERTIONS
    assert_int_equal(evaluated, 1);
    assert_true(is_ended_by([] { CLEFT_ASSERT(1 + 1 == 3); }));
    assert_true(is_ended_by([&] { a[past] = 1; }));
    assert_true(is_ended_by([&] { a[before] = 1; }));
    assert_true(is_ended_by([&] { b[past] = 1; }));
    assert_true(is_ended_by([&] { a.resize(before); }));
#else
    assert_int_equal(evaluated, 0);
    static_cast<void>(past + before + b[0]);
    assert_false(is_ended_by([] { CLEFT_ASSERT(1 + 1 == 3); }));
#endif
    assert_false(is_ended_by([&] { a[2] = 1; }));
}

// Values stay, and most additions find room where the array is.
void arrays_grow_by_a_part(void**)
{
    constexpr int kItems = 1 << 21, kMore = kItems / 10;
    Array<int> a = array_with_room(kItems, 3);
    const int* const place = a.data();
    for (int i = 0; i < kMore; ++i) {
        make_room(a);
        a.push_back(i);
    }
    assert_true(a.data() == place);
    make_room(a, kItems);
    assert_true(a.capacity() < 3 * kItems);
    a.resize(2 * kItems + kMore, 4);
    assert_int_equal(a[kItems - 1], 3);
    assert_int_equal(a[kItems + 5], 5);
    assert_int_equal(a[kItems + kMore], 4);
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(any_integer_is_an_index),
        cmocka_unit_test(arrays_grow_by_a_part),
        cmocka_unit_test(arrays_and_vectors_move_into_each_other),
        cmocka_unit_test(fixed_arrays_are_plain_values),
        cmocka_unit_test(a_failed_assertion_ends_the_process),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
