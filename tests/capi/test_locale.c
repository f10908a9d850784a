/* Numbers in texts are in C notation whatever the locale of the program, here one that writes 0,5. */
#include "support/capi.h"

#include <locale.h>
#include <stdlib.h>
#include <string.h>

/* localedef has made the locale in LOCPATH. */
static int use_comma(void** state)
{
    (void)state;
    return setlocale(LC_ALL, "de_DE.UTF-8") ? 0 : -1;
}

static void options_are_read_in_c_notation(void** state)
{
    cleft_options* options = NULL;
    double value = 0;
    (void)state;
    assert_true(strtod("0,5", NULL) == 0.5);
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "gradation", "0.5"), CLEFT_OK);
    assert_int_equal(cleft_options_get_real(options, CLEFT_OPTION_GRADATION, &value), CLEFT_OK);
    assert_true(value == 0.5);
    assert_int_equal(cleft_options_set_text(options, "gradation", "+2.5e-1"), CLEFT_OK);
    assert_int_equal(cleft_options_get_real(options, CLEFT_OPTION_GRADATION, &value), CLEFT_OK);
    assert_true(value == 0.25);
    static const char* const kWrong[] = {"0,5", "0.5,", "", "+", "+-0.5", " 0.5", "0.5 ", "1e999"};
    for (size_t i = 0; i < sizeof kWrong / sizeof kWrong[0]; ++i)
        assert_int_equal(cleft_options_set_text(options, "gradation", kWrong[i]), CLEFT_ERROR_OPTION);
    cleft_options_destroy(options);
}

static void sentences_are_in_c_notation(void** state)
{
    cleft_context* context = new_context();
    cleft_options* options = NULL;
    cleft_sizing* sizing = NULL;
    cleft_volume* volume = ball_volume(context, 8);
    (void)state;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE_MIN, 2.5), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE_MAX, 1.5), CLEFT_OK);
    assert_fails(context, CLEFT_ERROR_OPTION, cleft_sizing_create(context, volume, options, &sizing));
    assert_non_null(strstr(cleft_context_last_error(context), "size_max is 1.5, less than size_min, 2.5"));
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(options_are_read_in_c_notation),
        cmocka_unit_test(sentences_are_in_c_notation),
    };
    return cmocka_run_group_tests(tests, use_comma, NULL);
}
