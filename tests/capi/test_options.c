/* The table of options and the handle of options. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

static void the_table_is_sound(void** state)
{
    (void)state;
    const int32_t count = cleft_option_count();
    assert_true(count >= 15);
    for (int32_t i = 0; i < count; ++i) {
        cleft_option_description row = {.struct_size = sizeof row};
        assert_int_equal(cleft_option_info(i, &row), CLEFT_OK);
        assert_true(row.key > 0);
        assert_true(strlen(row.name) > 0 && strlen(row.text) > 5);
        assert_true(row.least <= row.value && row.value <= row.greatest);
        assert_int_equal(strlen(row.choices) > 0, row.type == CLEFT_OPTION_TYPE_CHOICE);
        assert_true(strlen(row.group) > 0 && strlen(row.calls) > 0);
        for (int32_t j = 0; j < i; ++j) {
            cleft_option_description other = {.struct_size = sizeof other};
            assert_int_equal(cleft_option_info(j, &other), CLEFT_OK);
            assert_int_not_equal(row.key, other.key);
            assert_string_not_equal(row.name, other.name);
        }
    }
    cleft_option_description row = {.struct_size = sizeof row};
    assert_int_equal(cleft_option_info(-1, &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_option_info(count, &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_option_info(0, NULL), CLEFT_ERROR_NULL);
    row.struct_size = 4; /* a caller of another age */
    assert_int_equal(cleft_option_info(0, &row), CLEFT_ERROR_ARGUMENT);
}

static void every_option_starts_at_its_default_and_keeps_its_range(void** state)
{
    cleft_options* options = NULL;
    (void)state;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    for (int32_t i = 0; i < cleft_option_count(); ++i) {
        cleft_option_description row = {.struct_size = sizeof row};
        double value = NAN;
        assert_int_equal(cleft_option_info(i, &row), CLEFT_OK);
        assert_int_equal(cleft_options_get_real(options, row.key, &value), CLEFT_OK);
        assert_true(value == row.value);
        if (row.type == CLEFT_OPTION_TYPE_REAL) {
            assert_int_equal(cleft_options_set_real(options, row.key, row.least), CLEFT_OK);
            assert_int_equal(cleft_options_set_real(options, row.key, row.least - 1), CLEFT_ERROR_OPTION);
            assert_non_null(strstr(cleft_options_last_error(options), row.name));
            assert_int_equal(cleft_options_set_real(options, row.key, NAN), CLEFT_ERROR_NOT_FINITE);
            assert_int_equal(cleft_options_set_real(options, row.key, INFINITY), CLEFT_ERROR_NOT_FINITE);
            assert_int_equal(cleft_options_set_integer(options, row.key, 1), CLEFT_ERROR_OPTION);
        } else {
            const int is_refused = row.key == CLEFT_OPTION_DELAUNAY && cleft_has_tetgen() == 0;
            assert_int_equal(cleft_options_set_integer(options, row.key, (int64_t)row.greatest),
                             is_refused ? CLEFT_ERROR_UNSUPPORTED : CLEFT_OK);
            assert_int_equal(cleft_options_set_integer(options, row.key, (int64_t)row.greatest + 2),
                             CLEFT_ERROR_OPTION);
            assert_int_equal(cleft_options_set_integer(options, row.key, (int64_t)row.least - 1), CLEFT_ERROR_OPTION);
            assert_int_equal(cleft_options_get_real(options, row.key, &value), CLEFT_OK);
            /* A refused value changes nothing. */
            assert_true(value == (is_refused ? row.value : row.greatest));
            assert_int_equal(cleft_options_set_real(options, row.key, 1), CLEFT_ERROR_OPTION);
        }
    }
    cleft_options_destroy(options);
}

static void text_sets_numbers_choices_and_flags(void** state)
{
    cleft_options* options = NULL;
    int64_t whole = -1;
    double real = -1;
    (void)state;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "feature-scale", "0.25"), CLEFT_OK);
    assert_int_equal(cleft_options_get_real(options, CLEFT_OPTION_FEATURE_SCALE, &real), CLEFT_OK);
    assert_true(real == 0.25);
    assert_int_equal(cleft_options_set_text(options, "feature_scale", "5e-1"), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "snap", "safe"), CLEFT_OK);
    assert_int_equal(cleft_options_get_integer(options, CLEFT_OPTION_SNAP, &whole), CLEFT_OK);
    assert_int_equal(whole, CLEFT_SNAP_SAFE);
    assert_int_equal(cleft_options_set_text(options, "snap", "none"), CLEFT_OK);
    assert_int_equal(cleft_options_get_integer(options, CLEFT_OPTION_SNAP, &whole), CLEFT_OK);
    assert_int_equal(whole, CLEFT_SNAP_NONE);
    assert_int_equal(cleft_options_set_text(options, "strict", "true"), CLEFT_OK);
    assert_int_equal(cleft_options_get_integer(options, CLEFT_OPTION_STRICT, &whole), CLEFT_OK);
    assert_int_equal(whole, 1);
    assert_int_equal(cleft_options_set_text(options, "snap", "saf"), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_text(options, "snap", "safe|none"), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_text(options, "snap", ""), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_text(options, "steps", "3.5"), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_text(options, "steps", "3x"), CLEFT_ERROR_OPTION);
    assert_int_equal(cleft_options_set_text(options, "size", "nan"), CLEFT_ERROR_NOT_FINITE);
    assert_int_equal(cleft_options_set_text(options, "colour", "1"), CLEFT_ERROR_OPTION);
    assert_non_null(strstr(cleft_options_last_error(options), "colour"));
    assert_int_equal(cleft_options_set_text(options, NULL, "1"), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_options_set_text(options, "size", NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_options_set_text(NULL, "size", "1"), CLEFT_ERROR_NULL);
    cleft_options_destroy(options);
}

static void lists_are_checked(void** state)
{
    cleft_options* options = NULL;
    const int32_t labels[2] = {1, 2};
    (void)state;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(options, labels, 2), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(options, NULL, 0), CLEFT_OK);
    assert_int_equal(cleft_options_set_strip(options, NULL, 1), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_options_set_only(options, labels, -1), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_options_set_label_size(options, 5, -1), CLEFT_ERROR_OPTION);
    assert_string_equal(cleft_options_last_error(options), "the size of label 5 is -1; it must not be negative");
    assert_int_equal(cleft_options_set_label_size(options, 5, NAN), CLEFT_ERROR_NOT_FINITE);
    assert_int_equal(cleft_options_set_label_size(options, 5, 2), CLEFT_OK);
    assert_int_equal(cleft_options_set_label_size(options, 5, 0), CLEFT_OK);
    cleft_options_destroy(options);
    cleft_options_destroy(NULL);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_table_is_sound),
        cmocka_unit_test(every_option_starts_at_its_default_and_keeps_its_range),
        cmocka_unit_test(text_sets_numbers_choices_and_flags),
        cmocka_unit_test(lists_are_checked),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
