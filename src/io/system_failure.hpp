// Failures that calls of the system and libraries in C report by errno. Lack of memory has a status of its own.
#pragma once

#include "base/error.hpp"

#include <cerrno>
#include <new>
#include <string>
#include <system_error>

namespace cleft::io
{

// `what` failed with `error` as errno.
[[noreturn]] inline void throw_system_failure(const std::string& what, int error)
{
    if (error == ENOMEM)
        throw std::bad_alloc();
    throw Error(CLEFT_ERROR_FILE, what + ": " + std::generic_category().message(error));
}

// A library that fails for want of memory says so in words of its own, or takes the file for damaged; but malloc leaves
// its mark. Call the first before the library, the second where it failed.
// errno is the calling thread's own, so that no other thread disturbs this.
inline void forget_want_of_memory() noexcept { errno = 0; }
inline void check_for_want_of_memory()
{
    if (errno == ENOMEM)
        throw std::bad_alloc();
}

}  // namespace cleft::io
