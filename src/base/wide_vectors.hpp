// CLEFT_WIDE_VECTORS marks a function of vectorized loops to be compiled for processors with wider vectors as well, and
// chosen among when the library is loaded: the same operations (nothing is contracted), so the same results. Not with
// sanitizers, which start after such functions are resolved.
#pragma once

#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && defined(__gnu_linux__) && \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CLEFT_WIDE_VECTORS __attribute__((target_clones("avx2", "default")))
#else
#define CLEFT_WIDE_VECTORS
#endif

// What such a function calls has to be part of it: a call would lead to code for the narrow vectors.
#if defined(__GNUC__)
#define CLEFT_ALWAYS_INLINE inline __attribute__((always_inline))
#else
#define CLEFT_ALWAYS_INLINE inline
#endif

// Two pointers that do not overlap.
#if defined(_MSC_VER)
#define CLEFT_RESTRICT __restrict
#else
#define CLEFT_RESTRICT __restrict__
#endif
