// The rows of the table of options, which are made from options.toml, and how they are found.
#include "capi/option_table.hpp"

#include "volume/limits.hpp"

namespace cleft::capi
{

static_assert(kGreatestSize == 1e30, "sizes in options.toml end there");

const OptionRow kOptionTable[kOptionCount] = {
#define CLEFT_OPTION_ROW(...) {__VA_ARGS__},
#include "capi/options.inc"
#undef CLEFT_OPTION_ROW
};

// A search in some twenty rows costs nothing, and asks no order of the keys, which have gaps when options go.
int option_row(cleft_option key)
{
    for (size_t i = 0; i < kOptionCount; ++i)
        if (kOptionTable[i].key == key)
            return static_cast<int>(i);
    return -1;
}

int option_row(const char* name)
{
    for (size_t i = 0; i < kOptionCount; ++i) {
        const char* a = kOptionTable[i].name;
        const char* b = name;
        // Command lines write --size-min, programs size_min.
        while (*a && (*a == *b || (*a == '_' && *b == '-'))) {
            ++a;
            ++b;
        }
        if (!*a && !*b)
            return static_cast<int>(i);
    }
    return -1;
}

}  // namespace cleft::capi
