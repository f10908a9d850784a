// Memory: three bytes a voxel for up to 256 labels, whatever their number, and none for a sample.
#include "volume/shapes.hpp"

#include <malloc.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "support/cmocka.hpp"

using namespace cleft;
using namespace cleft::test;

static std::atomic<int64_t> live{0}, peak{0}, calls{0};

static void* counted(size_t size)
{
    void* p = std::malloc(size);
    if (!p)
        throw std::bad_alloc();
    ++calls;
    const int64_t now = live += static_cast<int64_t>(malloc_usable_size(p));
    if (now > peak)
        peak = now;
    return p;
}

static void released(void* p)
{
    if (p)
        live -= static_cast<int64_t>(malloc_usable_size(p));
    std::free(p);
}

void* operator new(size_t size) { return counted(size); }
void* operator new[](size_t size) { return counted(size); }
void operator delete(void* p) noexcept { released(p); }
void operator delete[](void* p) noexcept { released(p); }
void operator delete(void* p, size_t) noexcept { released(p); }
void operator delete[](void* p, size_t) noexcept { released(p); }

struct Usage {
    double kept, peak;  // bytes a voxel
};

static Usage usage(const LabelImage& image)
{
    const int64_t before = live;
    peak = before;
    const Volume volume = volume_of(image);
    const auto voxels = static_cast<double>(image.grid.size());
    return {static_cast<double>(live - before) / voxels, static_cast<double>(peak - before) / voxels};
}

static void memory_does_not_grow_with_the_labels(void**)
{
    // Long along z: what the feedback keeps of the planes around the one it works on is a small part.
    const std::array<int32_t, 3> dims = {24, 24, 128};
    const Usage two = usage(noise_image(dims, 2)), many = usage(noise_image(dims, 250));
    const Usage wide = usage(noise_image(dims, 5000));
    assert_true(two.kept < 3.1 && two.peak < 5);
    assert_true(many.kept < 3.1 && many.peak < 5);
    assert_true(wide.kept < 4.4 && wide.peak < 9);
}

static void a_sample_allocates_nothing(void**)
{
    const Volume volume = volume_of(noise_image({12, 12, 12}, 300));
    Random random;
    Samples s;
    // The most materials that a point can see.
    s.value.reserve(216);
    s.material.reserve(216);
    s.gradient.reserve(216);
    const int64_t before = calls;
    double sum = 0;
    for (int p = 0; p < 1000; ++p) {
        const Vec3 x = random.in_box(volume.grid());
        volume.sample(x, s);
        volume.sample_gradient(x, s);
        sum += volume.material_at(x) + volume.single_material_near(x, 1);
    }
    assert_true(sum > 0);
    assert_int_equal(calls - before, 0);
}

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(memory_does_not_grow_with_the_labels),
        cmocka_unit_test(a_sample_allocates_nothing),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
