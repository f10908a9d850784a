/* What tests that write volumes share. */
#ifndef FOLDER_FIXTURE_H
#define FOLDER_FIXTURE_H

#include "folder.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

typedef struct fixture {
    cleft_context* context;
    char folder[FOLDER_NAME];
    char path[128], names[128];
} fixture;

static inline const char* path_of(fixture* f, const char* name)
{
    snprintf(f->path, sizeof f->path, "%s/%s", f->folder, name);
    return f->path;
}

static inline int set_up(void** state)
{
    fixture* f = calloc(1, sizeof *f);
    *state = f;
    return make_folder(f->folder, &f->context);
}

static inline int tear_down(void** state)
{
    fixture* f = *state;
    const int removed = remove_folder(f->folder);
    cleft_context_destroy(f->context);
    free(f);
    return removed;
}

static inline void write_file(const char* path, const void* head, size_t head_size, const void* data, size_t size)
{
    FILE* file = fopen(path, "wb");
    assert_non_null(file);
    fwrite(head, 1, head_size, file);
    fwrite(data, 1, size, file);
    fclose(file);
}

/* The path of a table of names with this text. */
static inline const char* written_names(fixture* f, const char* text)
{
    snprintf(f->names, sizeof f->names, "%s/names.txt", f->folder);
    write_file(f->names, text, strlen(text), "", 0);
    return f->names;
}

static inline void assert_refused(fixture* f, cleft_status status, cleft_status wanted, const char* words)
{
    assert_int_equal(status, wanted);
    if (!strstr(cleft_context_last_error(f->context), words))
        fail_msg("'%s' does not say '%s'", cleft_context_last_error(f->context), words);
}

#endif
