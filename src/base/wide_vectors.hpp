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
