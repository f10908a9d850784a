// What is kept comes back, in memory and on disk, and a field that is made again takes the room of the one before.
#include "blocks/block_sizes.hpp"
#include "blocks/block_store.hpp"
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

// Two blocks are in memory at a time: all come back as they were left, whether they were read or changed last.
void blocks_come_back_as_they_were_left(void**)
{
    constexpr int32_t kFirst = 3, kCount = 5;
    for (const char* scratch : {"", "."}) {
        BlockStore store(kFirst, kCount, scratch);
        for (int32_t b = kFirst; b < kFirst + kCount; ++b)
            store.at(b).mesh.points = {Vec3(b, 0, 0)};
        for (int32_t b = kFirst; b < kFirst + kCount; ++b)
            assert_true(store.read(b).mesh.points == Array<Vec3>({Vec3(b, 0, 0)}));
        // Read and then changed, changed and then read, while it stays in memory.
        store.read(kFirst);
        store.at(kFirst).mesh.points.push_back(Vec3(0, 1, 0));
        store.at(kFirst + 1).mesh.points.push_back(Vec3(0, 0, 1));
        store.read(kFirst + 1);
        for (int32_t b = kFirst + 2; b < kFirst + kCount; ++b)
            assert_int_equal(store.read(b).mesh.points.count(), 1);
        assert_true(store.read(kFirst).mesh.points == Array<Vec3>({Vec3(kFirst, 0, 0), Vec3(0, 1, 0)}));
        assert_true(store.read(kFirst + 1).mesh.points == Array<Vec3>({Vec3(kFirst + 1, 0, 0), Vec3(0, 0, 1)}));
        // What was given away is gone.
        store.at(kFirst).mesh = LabelledMesh();
        store.read(kFirst + 2);
        store.read(kFirst + 3);
        assert_true(store.read(kFirst).mesh.points.empty());
    }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(all_comes_back),
        cmocka_unit_test(a_field_takes_the_room_of_the_one_before),
        cmocka_unit_test(blocks_come_back_as_they_were_left),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
