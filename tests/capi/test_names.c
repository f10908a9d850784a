/* Names of labels: in, out, and along with the labels that they belong to. */
#include "support/capi.h"

#include <string.h>

enum { N = 10 };

static void names_are_copied_replaced_and_taken_away(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    char name[] = "liver";
    (void)state;
    assert_string_equal(cleft_volume_label_name(volume, 7), "");
    assert_int_equal(cleft_volume_set_label_name(volume, 7, name), CLEFT_OK);
    name[0] = 'r';
    assert_string_equal(cleft_volume_label_name(volume, 7), "liver");
    assert_string_equal(cleft_volume_label_name(volume, -3), "");
    assert_int_equal(cleft_volume_set_label_name(volume, -3, "h\xC3\xA9mi, \xF0\x9F\xA6\xB4"), CLEFT_OK);
    assert_string_equal(cleft_volume_label_name(volume, -3), "h\xC3\xA9mi, \xF0\x9F\xA6\xB4");
    assert_string_equal(cleft_volume_label_name(volume, 7), "liver");
    assert_int_equal(cleft_volume_set_label_name(volume, 7, "kidney"), CLEFT_OK);
    assert_string_equal(cleft_volume_label_name(volume, 7), "kidney");
    assert_int_equal(cleft_volume_set_label_name(volume, 7, ""), CLEFT_OK);
    assert_string_equal(cleft_volume_label_name(volume, 7), "");
    assert_int_equal(cleft_volume_set_label_name(volume, -3, NULL), CLEFT_OK);
    assert_string_equal(cleft_volume_label_name(volume, -3), "");
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void what_is_no_name_is_refused(void** state)
{
    static const char* const bad[] = {
        "\xFF", "a\xC3",      "\xC0\xAF", "\xED\xA0\x80", "\xF5\x80\x80\x80", "\xE0\x80\x80",
        "\x80", "two\nlines", "a\ttab",   "\x7F",         "\xC2\x85 (U+0085)"};
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    (void)state;
    assert_int_equal(cleft_volume_set_label_name(volume, 1000, "bone"), CLEFT_OK);
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
        assert_int_equal(cleft_volume_set_label_name(volume, 1000, bad[i]), CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_volume_label_name(volume, 1000), "bone");
    assert_int_equal(cleft_volume_set_label_name(volume, 8, "none"), CLEFT_ERROR_ARGUMENT);
    assert_string_equal(cleft_volume_label_name(volume, 8), "");
    assert_int_equal(cleft_volume_set_label_name(NULL, 7, "none"), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_mesh_set_label_name(NULL, 7, "none"), CLEFT_ERROR_NULL);
    assert_string_equal(cleft_volume_label_name(NULL, 7), "");
    assert_string_equal(cleft_mesh_label_name(NULL, 7), "");
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void assert_names(const cleft_mesh* mesh, const char* minus3, const char* seven, const char* thousand)
{
    assert_string_equal(cleft_mesh_label_name(mesh, -3), minus3);
    assert_string_equal(cleft_mesh_label_name(mesh, 7), seven);
    assert_string_equal(cleft_mesh_label_name(mesh, 1000), thousand);
}

static void names_travel_from_the_volume_through_every_stage(void** state)
{
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, N);
    cleft_sizing* sizing = NULL;
    cleft_options* options = NULL;
    cleft_mesh *background = NULL, *cleaved = NULL, *improved = NULL, *stripped = NULL, *whole = NULL;
    const int32_t ball = 7, upper = -3;
    (void)state;
    assert_int_equal(cleft_volume_set_label_name(volume, 7, "ball"), CLEFT_OK);
    assert_int_equal(cleft_volume_set_label_name(volume, -3, "upper"), CLEFT_OK);
    assert_ok(context, cleft_sizing_create_constant(context, volume, 2, &sizing));
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE), CLEFT_OK);
    assert_ok(context, cleft_background_create(context, sizing, options, &background));
    assert_string_equal(cleft_mesh_label_name(background, 0), "");
    assert_ok(context, cleft_mesh_cleave(context, volume, background, options, &cleaved));
    assert_names(cleaved, "upper", "ball", "");

    /* a mesh's own names come first; those that it lacks are the volume's */
    assert_int_equal(cleft_mesh_set_label_name(cleaved, 7, "sphere"), CLEFT_OK);
    assert_int_equal(cleft_mesh_set_label_name(cleaved, -3, NULL), CLEFT_OK);
    assert_int_equal(cleft_mesh_set_label_name(cleaved, 1000, "lower"), CLEFT_OK);
    assert_int_equal(cleft_mesh_set_label_name(cleaved, 8, "none"), CLEFT_ERROR_ARGUMENT);
    assert_ok(context, cleft_mesh_improve(context, volume, cleaved, options, &improved));
    assert_names(improved, "upper", "sphere", "lower");

    assert_int_equal(cleft_options_set_strip(options, &ball, 1), CLEFT_OK);
    assert_ok(context, cleft_mesh_strip(context, improved, options, &stripped));
    assert_names(stripped, "upper", "", "lower");

    assert_int_equal(cleft_options_set_strip(options, &upper, 1), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, sizing, NULL, options, &whole));
    assert_names(whole, "", "ball", "");

    cleft_mesh_destroy(whole);
    cleft_mesh_destroy(stripped);
    cleft_mesh_destroy(improved);
    cleft_mesh_destroy(cleaved);
    cleft_mesh_destroy(background);
    cleft_sizing_destroy(sizing);
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void a_mesh_of_arrays_is_named_by_its_maker(void** state)
{
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    static const int32_t tet[] = {0, 1, 2, 3}, label = INT32_MIN;
    cleft_context* context = new_context();
    cleft_mesh* mesh = NULL;
    (void)state;
    assert_ok(context, cleft_mesh_create(context, 4, points, 1, tet, &label, 0, &mesh));
    assert_int_equal(cleft_mesh_set_label_name(mesh, INT32_MIN, "the least"), CLEFT_OK);
    assert_string_equal(cleft_mesh_label_name(mesh, INT32_MIN), "the least");
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_are_copied_replaced_and_taken_away),
        cmocka_unit_test(what_is_no_name_is_refused),
        cmocka_unit_test(names_travel_from_the_volume_through_every_stage),
        cmocka_unit_test(a_mesh_of_arrays_is_named_by_its_maker),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
