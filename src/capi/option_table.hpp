// The one table of options: C interface, command line, documents and bindings all read it.
#pragma once

#include "cleft/cleft.h"

#include <cstddef>

namespace cleft::capi
{

// Plain pointers and numbers, so that the table is made by the compiler and needs no initialisation when a library is
// loaded.
struct OptionRow {
    cleft_option key;
    int32_t type;
    const char* name;
    double value;
    double least;
    double greatest;
    const char* choices;
    const char* group;
    const char* calls;
    const char* text;
};

inline constexpr size_t kOptionCount = 0
#define CLEFT_OPTION_ROW(...) +1
#include "capi/options.inc"
#undef CLEFT_OPTION_ROW
    ;
extern const OptionRow kOptionTable[kOptionCount];

// The row of a key, or -1.
int option_row(cleft_option key);
// The row of a name ('-' and '_' are the same), or -1.
int option_row(const char* name);

}  // namespace cleft::capi
