/* Volumes: labels, indicators, geometry. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

static void labels_come_out_as_they_went_in(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 12);
    int64_t dims[3] = {0, 0, 0}, counts[3] = {0, 0, 0};
    (void)state;
    assert_int_equal(cleft_volume_label_count(volume), 3);
    assert_int_equal(cleft_volume_labels(volume)[0], -3);
    assert_int_equal(cleft_volume_labels(volume)[1], 7);
    assert_int_equal(cleft_volume_labels(volume)[2], 1000);
    assert_ok(context, cleft_volume_dims(volume, dims));
    assert_int_equal(dims[2], 12);
    assert_ok(context, cleft_volume_copy_voxel_counts(volume, counts, 3));
    assert_int_equal(counts[0] + counts[1] + counts[2], 12 * 12 * 12);
    assert_int_equal(cleft_volume_copy_voxel_counts(volume, counts, 2), CLEFT_ERROR_BUFFER);
    assert_int_equal(cleft_volume_indicator_count(volume), 0);
    assert_int_equal(cleft_volume_indicator_count(NULL), 0);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void every_voxel_centre_keeps_its_label_in_any_world(void** state)
{
    /* a flipped, rotated and scaled world with its origin off zero */
    const double affine[12] = {0, -2, 0, 10, 0.5, 0, 0, -7, 0, 0, -3, 100};
    cleft_context* context = new_context();
    const int n = 10;
    const int64_t dims[3] = {n, n, n};
    int32_t* labels = ball_labels(n);
    cleft_volume* volume = NULL;
    double back[12];
    (void)state;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, affine, NULL, &volume));
    assert_ok(context, cleft_volume_affine(volume, back));
    assert_memory_equal(back, affine, sizeof affine);
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double x[3] = {-2.0 * j + 10, 0.5 * i - 7, -3.0 * k + 100};
                int32_t label = 0;
                assert_ok(context, cleft_volume_sample(volume, x, 1, &label));
                assert_int_equal(label, labels[i + n * (j + n * k)]);
            }
    cleft_volume_destroy(volume);
    free(labels);
    cleft_context_destroy(context);
}

static void all_five_types_give_the_same_volume(void** state)
{
    cleft_context* context = new_context();
    uint8_t u8[27];
    uint16_t u16[27];
    int16_t i16[27];
    uint32_t u32[27];
    int32_t i32[27];
    const void* voxels[5] = {u8, u16, i16, u32, i32};
    const cleft_type types[5] = {CLEFT_TYPE_UINT8, CLEFT_TYPE_UINT16, CLEFT_TYPE_INT16, CLEFT_TYPE_UINT32,
                                 CLEFT_TYPE_INT32};
    const int64_t dims[3] = {3, 3, 3};
    (void)state;
    for (int i = 0; i < 27; ++i) {
        u8[i] = (uint8_t)((i * 7) % 5 * 50);
        u16[i] = u8[i];
        i16[i] = u8[i];
        u32[i] = u8[i];
        i32[i] = u8[i];
    }
    for (int t = 0; t < 5; ++t) {
        cleft_volume* volume = NULL;
        assert_ok(context, cleft_volume_create_labels(context, types[t], voxels[t], dims, NULL, NULL, &volume));
        assert_int_equal(cleft_volume_label_count(volume), 5);
        for (int i = 0; i < 27; ++i) {
            const double x[3] = {i % 3 + 0.5, i / 3 % 3 + 0.5, i / 9 + 0.5};
            int32_t label = -1;
            assert_ok(context, cleft_volume_sample(volume, x, 1, &label));
            assert_int_equal(label, u8[i]);
        }
        cleft_volume_destroy(volume);
    }
    cleft_context_destroy(context);
}

static void signed_function_splits_at_zero(void** state)
{
    cleft_context* context = new_context();
    const int64_t dims[3] = {8, 8, 8};
    const int32_t names[2] = {10, 20};
    float f[512];
    const void* fields[1] = {f};
    cleft_volume* volume = NULL;
    const double out[3] = {1, 4, 4}, in[3] = {7, 4, 4};
    int32_t label = 0;
    (void)state;
    for (int i = 0; i < 512; ++i)
        f[i] = (float)(i % 8 - 3.6);
    assert_ok(context,
              cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, fields, 1, dims, NULL, names, &volume));
    assert_int_equal(cleft_volume_indicator_count(volume), 1);
    assert_int_equal(cleft_volume_label_count(volume), 2);
    assert_ok(context, cleft_volume_sample(volume, out, 1, &label));
    assert_int_equal(label, 10);
    assert_ok(context, cleft_volume_sample(volume, in, 1, &label));
    assert_int_equal(label, 20);
    cleft_volume_destroy(volume);
    f[77] = NAN;
    assert_fails(context, CLEFT_ERROR_NOT_FINITE,
                 cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, fields, 1, dims, NULL, names, &volume));
    assert_null(volume);
    cleft_context_destroy(context);
}

static void mistakes_are_named(void** state)
{
    cleft_context* context = new_context();
    const uint8_t one[8] = {0};
    const int64_t dims[3] = {2, 2, 2}, none[3] = {2, 0, 2}, huge[3] = {100000, 100000, 100000};
    const double flat[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0},
                 nan_affine[12] = {1, 0, 0, 0, 0, 1, 0, NAN, 0, 0, 1, 0};
    cleft_volume* volume = NULL;
    (void)state;
    assert_fails(context, CLEFT_ERROR_NULL,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, NULL, dims, NULL, NULL, &volume));
    assert_fails(context, CLEFT_ERROR_NULL,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, one, NULL, NULL, NULL, &volume));
    assert_fails(context, CLEFT_ERROR_NULL,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, one, dims, NULL, NULL, NULL));
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, one, none, NULL, NULL, &volume));
    assert_non_null(strstr(cleft_context_last_error(context), "along y is 0"));
    assert_fails(context, CLEFT_ERROR_TOO_LARGE,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, one, huge, NULL, NULL, &volume));
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_volume_create_labels(context, CLEFT_TYPE_FLOAT32, one, dims, NULL, NULL, &volume));
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, one, dims, flat, NULL, &volume));
    assert_fails(context, CLEFT_ERROR_NOT_FINITE,
                 cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, one, dims, nan_affine, NULL, &volume));
    assert_fails(context, CLEFT_ERROR_ARGUMENT,
                 cleft_volume_create_indicators(context, CLEFT_TYPE_FLOAT32, (const void* const[]){one}, 0, dims, NULL,
                                                NULL, &volume));
    assert_null(volume);
    cleft_volume_destroy(NULL);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(labels_come_out_as_they_went_in),
        cmocka_unit_test(every_voxel_centre_keeps_its_label_in_any_world),
        cmocka_unit_test(all_five_types_give_the_same_volume),
        cmocka_unit_test(signed_function_splits_at_zero),
        cmocka_unit_test(mistakes_are_named),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
