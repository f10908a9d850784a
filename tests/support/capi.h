/* For tests of the C interface: CMocka, a context that fails the test with the library's own sentence, and a volume. */
#ifndef CLEFT_TESTS_CAPI_H
#define CLEFT_TESTS_CAPI_H

#include "cleft/cleft.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>

#include <cmocka.h>

/* Asserts success and shows the library's sentence if there was none. */
#define assert_ok(context, call)                                                                   \
    do {                                                                                           \
        const cleft_status status_ = (call);                                                       \
        if (status_ != CLEFT_OK)                                                                   \
            fail_msg("%s: status %d: %s", #call, (int)status_, cleft_context_last_error(context)); \
    } while (0)

/* Asserts a failure with this status and with some sentence on the context. */
#define assert_fails(context, expected, call)                      \
    do {                                                           \
        assert_int_equal((call), (expected));                      \
        assert_true(cleft_context_last_error(context)[0] != '\0'); \
    } while (0)

static inline cleft_context* new_context(void)
{
    cleft_context* context = NULL;
    assert_int_equal(cleft_context_create(&context), CLEFT_OK);
    assert_non_null(context);
    return context;
}

/* n^3 voxels: label 7 in a ball of radius 0.35 n about the middle, label -3 in the upper half of the rest, 1000 below.
 */
static inline int32_t* ball_labels(int n)
{
    int32_t* labels = (int32_t*)malloc(sizeof(int32_t) * (size_t)(n * n * n));
    const double r = 0.35 * n, c = 0.5 * n;
    for (int k = 0; k < n; ++k)
        for (int j = 0; j < n; ++j)
            for (int i = 0; i < n; ++i) {
                const double x = i + 0.5 - c, y = j + 0.5 - c, z = k + 0.5 - c;
                const int inside = x * x + y * y + z * z < r * r;
                labels[i + n * (j + n * k)] = inside ? 7 : (2 * k >= n ? -3 : 1000);
            }
    return labels;
}

static inline cleft_volume* ball_volume(cleft_context* context, int n)
{
    const int64_t dims[3] = {n, n, n};
    int32_t* labels = ball_labels(n);
    cleft_volume* volume = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, dims, NULL, NULL, &volume));
    free(labels);
    return volume;
}

#endif
