/* Structs are distinguished by struct_size: too small a number is refused, never passed over. */
#include "support/capi.h"

#include <string.h>

static const double kPoints[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
static const int32_t kTet[] = {0, 1, 2, 3};

static cleft_mesh* one_tet(cleft_context* context)
{
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_create(context, 4, kPoints, 1, kTet, NULL, 0, &mesh));
    return mesh;
}

static cleft_status quality_with(cleft_context* context, const cleft_mesh* mesh, uint32_t size, cleft_quality* out)
{
    memset(out, 0x55, sizeof *out);
    out->struct_size = size;
    return cleft_mesh_quality(context, mesh, out);
}

static void too_small_or_unset_is_refused_and_nothing_is_written(void** state)
{
    static const uint32_t bad[] = {0, 1, 4, 8, sizeof(cleft_quality) - 1, 0x55555555, UINT32_MAX};
    cleft_context* context = new_context();
    cleft_mesh* mesh = one_tet(context);
    (void)state;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        cleft_quality got, kept;
        memset(&kept, 0x55, sizeof kept);
        kept.struct_size = bad[i];
        assert_fails(context, CLEFT_ERROR_ARGUMENT, quality_with(context, mesh, bad[i], &got));
        assert_non_null(strstr(cleft_context_last_error(context), "cleft_quality"));
        assert_memory_equal(&got, &kept, sizeof got);
    }
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

static void every_struct_that_comes_out_is_checked(void** state)
{
    cleft_context* context = new_context();
    cleft_mesh* mesh = one_tet(context);
    const int64_t dims[3] = {1, 1, 1};
    const uint8_t voxel = 0;
    cleft_volume* volume = NULL;
    cleft_report* report = NULL;
    cleft_validation validation = {0};
    cleft_option_description option = {0};
    cleft_label_report row = {0};
    (void)state;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, &voxel, dims, NULL, NULL, &volume));
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_mesh_validate(context, mesh, 0, &validation));
    assert_non_null(strstr(cleft_context_last_error(context), "cleft_validation"));
    assert_int_equal(cleft_option_info(0, &option), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_report_label(report, 0, &row), CLEFT_ERROR_ARGUMENT);
    validation.struct_size = sizeof validation;
    option.struct_size = sizeof option;
    row.struct_size = sizeof row;
    assert_ok(context, cleft_mesh_validate(context, mesh, 0, &validation));
    assert_int_equal(cleft_option_info(0, &option), CLEFT_OK);
    assert_int_equal(cleft_report_label(report, 0, &row), CLEFT_OK);
    option.struct_size = offsetof(cleft_option_description, group) - 1;
    row.struct_size = offsetof(cleft_label_report, large_components_broken) - 1;
    assert_int_equal(cleft_option_info(0, &option), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_report_label(report, 0, &row), CLEFT_ERROR_ARGUMENT);
    cleft_report_destroy(report);
    cleft_volume_destroy(volume);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

/* A program that was compiled before a struct grew, or after it grew further. */
static void a_struct_is_filled_as_far_as_both_know_it(void** state)
{
    struct {
        cleft_validation known;
        int64_t later;
    } newer;
    cleft_context* context = new_context();
    cleft_mesh* mesh = one_tet(context);
    cleft_validation older;
    (void)state;
    memset(&older, 0x55, sizeof older);
    older.struct_size = offsetof(cleft_validation, interface_triangles);
    assert_ok(context, cleft_mesh_validate(context, mesh, 0, &older));
    assert_int_equal(older.struct_size, offsetof(cleft_validation, interface_triangles));
    assert_int_equal(older.valid, 1);
    assert_true(older.box_volume == 1);
    assert_int_equal(older.interface_triangles, 0x5555555555555555);
    memset(&newer, 0x55, sizeof newer);
    newer.known.struct_size = sizeof newer;
    assert_ok(context, cleft_mesh_validate(context, mesh, 0, &newer.known));
    assert_int_equal(newer.known.struct_size, sizeof newer);
    assert_int_equal(newer.known.hull_triangles, 4);
    assert_int_equal(newer.later, 0x5555555555555555);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(too_small_or_unset_is_refused_and_nothing_is_written),
        cmocka_unit_test(every_struct_that_comes_out_is_checked),
        cmocka_unit_test(a_struct_is_filled_as_far_as_both_know_it),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
