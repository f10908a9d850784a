// Where the interfaces to C end: which status an exception becomes. The core and the file component share the rule.
#pragma once

#include "base/error.hpp"

#include <new>
#include <stdexcept>

namespace cleft
{

// Runs `body`. If that throws, the answer is failed(status, sentence), which must not throw.
// Want of memory comes first and builds no string, for a string could fail again.
template <class Body, class Failed>
cleft_status status_of(const Body& body, const Failed& failed) noexcept
{
    constexpr const char* kNoMemory = "there is not enough memory";
    try {
        body();
        return CLEFT_OK;
    } catch (const std::bad_alloc&) {
        return failed(CLEFT_ERROR_OUT_OF_MEMORY, kNoMemory);
    } catch (const Error& error) {
        return failed(error.status(), error.what());
    } catch (const std::length_error&) {  // a container asked for more than the address space
        return failed(CLEFT_ERROR_OUT_OF_MEMORY, kNoMemory);
    } catch (const std::exception& error) {
        return failed(CLEFT_ERROR_INTERNAL, error.what());
    } catch (...) {
        // A callback written in C++ may throw anything, and nothing may unwind through the frames of a C caller.
        return failed(CLEFT_ERROR_INTERNAL, "an unknown exception was thrown");
    }
}

}  // namespace cleft
