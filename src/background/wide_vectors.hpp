// Marks the few functions whose loops gain from wider vectors than every processor has.
#pragma once

// Compiled twice and chosen when the program starts: the same operations in the same order, so the same results. Not
// with sanitizers, which start after the functions are resolved.
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CLEFT_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define CLEFT_WIDE_VECTORS
#endif
