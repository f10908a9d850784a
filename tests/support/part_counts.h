/* How much a part has, for tests of meshes in parts. */
#ifndef CLEFT_TESTS_PART_COUNTS_H
#define CLEFT_TESTS_PART_COUNTS_H

#include "cleft/cleft_parts.h"
#include "support/capi.h"

#include <string.h>

static inline cleft_part_counts counts_of(const cleft_part* part)
{
    cleft_part_counts counts;
    memset(&counts, 0, sizeof counts);
    counts.struct_size = sizeof counts;
    assert_int_equal(cleft_part_count(part, &counts), CLEFT_OK);
    return counts;
}

#endif
