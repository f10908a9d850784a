/* Contexts, statuses, versions and metrics. */
#include "support/capi.h"

#include <stdio.h>
#include <string.h>

static void version_is_that_of_the_header(void** state)
{
    int32_t major = -1, minor = -1, patch = -1;
    (void)state;
    assert_string_equal(cleft_version(&major, &minor, &patch), CLEFT_VERSION_STRING);
    assert_int_equal(major, CLEFT_VERSION_MAJOR);
    assert_int_equal(minor, CLEFT_VERSION_MINOR);
    assert_int_equal(patch, CLEFT_VERSION_PATCH);
    assert_non_null(cleft_version(NULL, NULL, NULL));
}

static void every_status_has_its_own_text_and_number(void** state)
{
    static const struct {
        cleft_status status;
        const char* text;
    } all[] = {
#define ROW(name, number, text) {CLEFT_##name, text},
        CLEFT_STATUS_LIST(ROW)
#undef ROW
    };
    const size_t n = sizeof all / sizeof all[0];
    (void)state;
    for (size_t i = 0; i < n; ++i) {
        assert_string_equal(cleft_status_string(all[i].status), all[i].text);
        for (size_t j = 0; j < i; ++j)
            assert_int_not_equal(all[i].status, all[j].status);
    }
    assert_string_equal(cleft_status_string(12345), "unknown status");
    assert_int_equal(CLEFT_OK, 0);
    assert_int_equal(CLEFT_ERROR_CANCELLED, -3); /* numbers are part of the ABI */
    assert_int_equal(CLEFT_ERROR_HANDLE, -15);
}

static void threads_are_checked_and_zero_means_the_machine(void** state)
{
    cleft_context* context = new_context();
    (void)state;
    assert_int_equal(cleft_context_threads(context), 1);
    assert_ok(context, cleft_context_set_threads(context, 7));
    assert_int_equal(cleft_context_threads(context), 7);
    assert_ok(context, cleft_context_set_threads(context, 0));
    assert_true(cleft_context_threads(context) >= 1);
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_context_set_threads(context, -1));
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_context_set_threads(context, 1025));
    assert_non_null(strstr(cleft_context_last_error(context), "1025"));
    cleft_context_destroy(context);
}

static void a_long_sentence_is_cut_not_lost(void** state)
{
    cleft_context* context = new_context();
    char sentence[5000];
    (void)state;
    memset(sentence, 'a', sizeof sentence);
    sentence[sizeof sentence - 1] = '\0';
    assert_int_equal(cleft_context_set_error(context, CLEFT_ERROR_FILE, sentence), CLEFT_ERROR_FILE);
    assert_true(strlen(cleft_context_last_error(context)) >= 1000);
    assert_memory_equal(cleft_context_last_error(context), sentence, 1000);
    cleft_context_destroy(context);
}

/* Two bytes each, at odd and at even places: one of the two would be cut in its middle. */
static void a_long_sentence_ends_with_a_whole_character(void** state)
{
    (void)state;
    for (size_t shift = 0; shift < 2; ++shift) {
        cleft_context* context = new_context();
        char sentence[5001] = "a";
        for (size_t i = shift; i + 1 < sizeof sentence - 1; i += 2)
            memcpy(sentence + i, "\xc3\xa9", 2);
        assert_int_equal(cleft_context_set_error(context, CLEFT_ERROR_FILE, sentence), CLEFT_ERROR_FILE);
        const char* kept = cleft_context_last_error(context);
        assert_true(strlen(kept) >= 1000);
        assert_memory_equal(kept + strlen(kept) - 2, "\xc3\xa9", 2);
        cleft_context_destroy(context);
    }
}

typedef struct heard {
    int32_t level;
    char sentence[32];
} heard;

static void hear(int32_t level, const char* sentence, void* user)
{
    heard* last = user;
    last->level = level;
    snprintf(last->sentence, sizeof last->sentence, "%s", sentence);
}

/* Names of files are bytes. A sentence is text, on its way to the caller by the log, too. */
static void sentences_are_text(void** state)
{
    cleft_context* context = new_context();
    heard last = {0, ""};
    const char* given = "g\x92 \xc3\xa9 \n\x1b[2m \xed\xa0\x80 \xc3";
    const char* kept = "g? \xc3\xa9 ??[2m ??? ?";
    (void)state;
    assert_int_equal(cleft_context_set_error(context, CLEFT_ERROR_FILE, given), CLEFT_ERROR_FILE);
    assert_string_equal(cleft_context_last_error(context), kept);
    assert_ok(context, cleft_context_set_log(context, hear, &last));
    assert_ok(context, cleft_context_log(context, CLEFT_LOG_INFO, given));
    assert_string_equal(last.sentence, kept);
    cleft_context_destroy(context);
}

static void components_reach_the_log(void** state)
{
    cleft_context* context = new_context();
    heard last = {0, ""};
    (void)state;
    assert_ok(context, cleft_context_log(context, CLEFT_LOG_WARNING, "nobody listens"));
    assert_ok(context, cleft_context_set_log(context, hear, &last));
    assert_ok(context, cleft_context_log(context, CLEFT_LOG_INFO, "one sentence"));
    assert_int_equal(last.level, CLEFT_LOG_INFO);
    assert_string_equal(last.sentence, "one sentence");
    assert_fails(context, CLEFT_ERROR_ARGUMENT, cleft_context_log(context, 0, "no such level"));
    assert_fails(context, CLEFT_ERROR_NULL, cleft_context_log(context, CLEFT_LOG_INFO, NULL));
    assert_int_equal(cleft_context_log(NULL, CLEFT_LOG_INFO, "no context"), CLEFT_ERROR_NULL);
    assert_string_equal(last.sentence, "one sentence");
    cleft_context_destroy(context);
}

static void null_and_foreign_handles_are_statuses(void** state)
{
    cleft_context* context = new_context();
    cleft_options* options = NULL;
    cleft_sizing* sizing = (cleft_sizing*)1;
    double value = 0;
    const char* name = NULL;
    (void)state;
    cleft_context_destroy(NULL);
    assert_int_equal(cleft_context_create(NULL), CLEFT_ERROR_NULL);
    assert_string_equal(cleft_context_last_error(NULL), "");
    assert_int_equal(cleft_context_set_threads(NULL, 1), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_context_cancel(NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_context_metric_count(NULL), 0);
    assert_int_equal(cleft_context_metric(context, 0, &name, &value), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    /* a handle of another kind */
    assert_int_equal(cleft_context_set_threads((cleft_context*)(void*)options, 2), CLEFT_ERROR_HANDLE);
    assert_fails(context, CLEFT_ERROR_HANDLE,
                 cleft_sizing_create(context, (const cleft_volume*)(void*)options, NULL, &sizing));
    assert_null(sizing); /* outputs are NULL on failure */
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(version_is_that_of_the_header),
        cmocka_unit_test(every_status_has_its_own_text_and_number),
        cmocka_unit_test(threads_are_checked_and_zero_means_the_machine),
        cmocka_unit_test(a_long_sentence_is_cut_not_lost),
        cmocka_unit_test(a_long_sentence_ends_with_a_whole_character),
        cmocka_unit_test(sentences_are_text),
        cmocka_unit_test(components_reach_the_log),
        cmocka_unit_test(null_and_foreign_handles_are_statuses),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
