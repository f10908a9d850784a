// What is kept comes back, in memory and on disk, and a field that is made again takes the room of the one before.
#include "blocks/block_sizes.hpp"
#include "parts/kept_bytes.hpp"
#include "support/cmocka.hpp"

#include <filesystem>

#include <sys/stat.h>

using namespace cleft;

namespace
{

constexpr int kRounds = 5;

// The bytes of the files that this process has open and that have no name.
int64_t size_of_scratch_files()
{
    int64_t sum = 0;
    for (const auto& entry : std::filesystem::directory_iterator("/proc/self/fd")) {
        std::error_code gone;  // that of the listing itself
        const std::string target = std::filesystem::read_symlink(entry.path(), gone).string();
        struct stat file {
        };
        if (target.find(".cleft-scratch-") != std::string::npos && stat(entry.path().c_str(), &file) == 0)
            sum += file.st_size;
    }
    return sum;
}

void check_kept(const std::string& scratch)
{
    KeptBytes kept(scratch);
    assert_int_equal(kept.is_on_disk(), !scratch.empty());
    assert_false(kept.has(7));
    assert_true(kept.get<int>(7).empty());
    kept.put(7, Array<int>{1, 2, 3, 4});
    kept.put(-2, Array<double>{0.5});
    kept.put(3, Array<int>());
    assert_false(kept.has(3));
    assert_true(kept.get<int>(7) == Array<int>({1, 2, 3, 4}));
    assert_true(kept.get<double>(-2) == Array<double>({0.5}));
    Array<int> out{9};
    kept.append(7, 1, 2, out);
    assert_true(out == Array<int>({9, 2, 3}));
    // Shorter and longer ones leave what is beside them as it is.
    for (const Array<int>& next : {Array<int>{5}, Array<int>{6, 7, 8, 9, 10, 11}}) {
        kept.put(7, next);
        assert_true(kept.get<int>(7) == next);
        assert_true(kept.get<double>(-2) == Array<double>({0.5}));
    }
    kept.clear();
    assert_false(kept.has(7));
    assert_true(kept.get<int>(7).empty());
}

void all_comes_back(void**)
{
    check_kept("");
    check_kept(".");
}

void a_field_takes_the_room_of_the_one_before(void**)
{
    Grid grid;
    grid.dims = {5, 4, 9};
    for (const char* scratch : {"", "."}) {
        const int64_t before = size_of_scratch_files();
        BlockField field(grid, 0.2, scratch);
        for (int round = 1; round <= kRounds; ++round) {
            field.clear();
            assert_int_equal(field.planes().count, 0);
            for (const Planes slab : {Planes{0, 4}, Planes{4, 4}, Planes{8, 1}}) {
                Array<float> h(slab.count * grid.plane_size());
                for (int64_t i = 0; i < h.count(); ++i)
                    h[i] = static_cast<float>(round * (slab.first * grid.plane_size() + i + 1));
                field.add(slab, h);
            }
            const Array<float> some = field.values({3, 6});
            assert_int_equal(some.count(), 6 * grid.plane_size());
            for (int64_t i = 0; i < some.count(); ++i)
                assert_true(some[i] == static_cast<float>(round * (3 * grid.plane_size() + i + 1)));
            assert_true(field.range().least == round);
            assert_true(field.range().greatest == round * static_cast<double>(grid.size()));
        }
        const int64_t whole = *scratch ? grid.size() * int64_t{sizeof(float)} : 0;
        assert_int_equal(size_of_scratch_files() - before, whole);
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(all_comes_back),
        cmocka_unit_test(a_field_takes_the_room_of_the_one_before),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
