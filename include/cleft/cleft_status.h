/* Status codes of libcleft. Part of cleft.h; do not include it alone. */
#ifndef CLEFT_STATUS_H
#define CLEFT_STATUS_H

#include <stdint.h>

/* The list of the enumeration, the texts and the bindings: X(NAME, NUMBER, TEXT). Numbers are never reused. */
#define CLEFT_STATUS_LIST(X)                                                     \
    X(OK, 0, "success")                                                          \
    X(ERROR_INTERNAL, -1, "internal error")                                      \
    X(ERROR_OUT_OF_MEMORY, -2, "out of memory")                                  \
    X(ERROR_CANCELLED, -3, "cancelled")                                          \
    X(ERROR_NULL, -4, "a required pointer is NULL")                              \
    X(ERROR_ARGUMENT, -5, "an argument is out of its range")                     \
    X(ERROR_NOT_FINITE, -6, "a number is NaN or infinite")                       \
    X(ERROR_TOO_LARGE, -7, "too large for 32-bit numbering")                     \
    X(ERROR_BUFFER, -8, "the buffer is too small")                               \
    X(ERROR_OPTION, -9, "unknown option, or a value out of its range")           \
    X(ERROR_UNSUPPORTED, -10, "not supported by this build or format")           \
    X(ERROR_INVALID_MESH, -11, "the mesh is not valid")                          \
    X(ERROR_LABEL_LOST, -12, "a label of the volume is not in the mesh")         \
    X(ERROR_FILE, -13, "a file cannot be read or written")                       \
    X(ERROR_FORMAT, -14, "the contents of a file break the rules of its format") \
    X(ERROR_HANDLE, -15, "a handle is of another kind")                          \
    X(ERROR_BUSY, -16, "the context is busy with another call")                  \
    X(ERROR_EXCHANGE, -17, "the ranks of a run cannot reach each other")

enum {
#define CLEFT_STATUS_ENUM(name, number, text) CLEFT_##name = (number),
    CLEFT_STATUS_LIST(CLEFT_STATUS_ENUM)
#undef CLEFT_STATUS_ENUM
        CLEFT_STATUS_RESERVED = -2147483647 - 1
};

/** The result of every function that can fail: CLEFT_OK (0) or one of the negative codes. \since 0.1 */
typedef int32_t cleft_status;

#endif
