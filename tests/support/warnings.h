/* The warnings of a context, for tests of what is reported. */
#ifndef CLEFT_TESTS_WARNINGS_H
#define CLEFT_TESTS_WARNINGS_H

#include "support/capi.h"

#include <stdio.h>
#include <string.h>

typedef struct {
    int count;
    char all[4096]; /* the sentences, one a line */
} warnings;

static inline void keep_warning(int32_t level, const char* sentence, void* user)
{
    warnings* reported = (warnings*)user;
    if (level != CLEFT_LOG_WARNING)
        return;
    const size_t used = strlen(reported->all);
    snprintf(reported->all + used, sizeof reported->all - used, "%s\n", sentence);
    ++reported->count;
}

/* A context whose warnings are kept. */
static inline cleft_context* listening_context(warnings* reported)
{
    cleft_context* context = new_context();
    memset(reported, 0, sizeof *reported);
    assert_ok(context, cleft_context_set_log(context, keep_warning, reported));
    return context;
}

/* Asserts that there was one warning, or none for NULL, and that it says this; and forgets it. */
static inline void assert_reported(warnings* reported, const char* words)
{
    if (reported->count != (words ? 1 : 0) || (words && !strstr(reported->all, words)))
        fail_msg("expected: %s; reported %d: %s", words ? words : "nothing", reported->count, reported->all);
    memset(reported, 0, sizeof *reported);
}

#endif
