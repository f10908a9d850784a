// The structs of the C interfaces, which begin with struct_size and grow at their end: what an older or a newer program
// gives or takes is known by that number.
#pragma once

#include "base/error.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

namespace cleft
{

// Where a field of a struct ends.
#define CLEFT_END_OF(type, field) (offsetof(type, field) + sizeof(static_cast<type*>(nullptr)->field))

// The size that a struct had in the release that brought it, which stays when the struct grows: each has a
// specialization.
template <class Struct>
inline constexpr size_t kFirstSize = 0;

// No struct is as large as this: struct_size was not set.
// It catches a struct that was not initialised, whose size is whatever the stack held.
inline constexpr uint32_t kGreatestStructSize = 1U << 16;

template <class Struct>
void check_struct_size(const Struct& given, const char* name)
{
    static_assert(kFirstSize<Struct> > sizeof(uint32_t) && kFirstSize<Struct> <= sizeof(Struct),
                  "specialize kFirstSize with the last field that the struct had in its first release");
    if (given.struct_size < kFirstSize<Struct> || given.struct_size > kGreatestStructSize)
        throw Error(CLEFT_ERROR_ARGUMENT, "struct_size of the " + std::string(name) + " is " +
                                              std::to_string(given.struct_size) + "; set it to sizeof(" + name +
                                              "), which is " + std::to_string(sizeof(Struct)));
}

// What the caller asks for; fields that its version lacks are 0. Those that this version lacks must be 0.
template <class Struct>
Struct copy_in(const Struct& given, const char* name)
{
    check_struct_size(given, name);
    Struct out{};
    std::memcpy(&out, &given, std::min<size_t>(given.struct_size, sizeof out));
    // A newer program may leave new fields 0, and gets what it expects. If it sets one, ignoring it would be a silent
    // change of meaning.
    const char* bytes = reinterpret_cast<const char*>(&given);
    for (size_t i = sizeof out; i < given.struct_size; ++i)
        if (bytes[i] != 0)
            throw Error(CLEFT_ERROR_ARGUMENT, "the " + std::string(name) +
                                                  " has a field set that this version of the "
                                                  "library does not know");
    return out;
}

// Fills the caller's struct, whose size has been checked, as far as its version goes.
template <class Struct>
void copy_out(Struct row, Struct& out)
{
    row.struct_size = out.struct_size;
    std::memcpy(&out, &row, std::min<size_t>(out.struct_size, sizeof row));
}

}  // namespace cleft
