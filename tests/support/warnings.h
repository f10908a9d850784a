/* The warnings of a context, for tests of what is told. */
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
    warnings* told = (warnings*)user;
    if (level != CLEFT_LOG_WARNING)
        return;
    const size_t used = strlen(told->all);
    snprintf(told->all + used, sizeof told->all - used, "%s\n", sentence);
    ++told->count;
}

/* A context whose warnings are kept. */
static inline cleft_context* listening_context(warnings* told)
{
    cleft_context* context = new_context();
    memset(told, 0, sizeof *told);
    assert_ok(context, cleft_context_set_log(context, keep_warning, told));
    return context;
}

/* Asserts that there was one warning, or none for NULL, and that it says this; and forgets it. */
static inline void assert_told(warnings* told, const char* words)
{
    if (told->count != (words ? 1 : 0) || (words && !strstr(told->all, words)))
        fail_msg("expected: %s; told %d: %s", words ? words : "nothing", told->count, told->all);
    memset(told, 0, sizeof *told);
}

#endif
