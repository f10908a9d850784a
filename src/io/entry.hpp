// The wrapper of every entry: no exception leaves the component, every failure leaves its sentence on the context, and
// what the entry works with lives until it ends.
#pragma once

#include "base/status_of.hpp"
#include "cleft/cleft.h"

#include <initializer_list>
#include <string>

namespace cleft::io
{

// Runs `body` and turns what it throws into a status, with a sentence on the context unless that is null.
template <class Body>
cleft_status guarded(cleft_context* context, const Body& body) noexcept
{
    // The status is returned even where no context can keep the sentence.
    return status_of(body, [context](cleft_status status, const char* sentence) noexcept {
        return cleft_context_set_error(context, status, sentence);
    });
}

// One call of the context, which works with `handles` (or null).
template <class Body>
cleft_status entry(cleft_context* context, std::initializer_list<const void*> handles, const Body& body) noexcept
{
    // Other threads get CLEFT_ERROR_BUSY from now on, and the handles live on even if a callback
    // destroys them.
    const cleft_status status = cleft_context_begin(context, handles.begin(), static_cast<int64_t>(handles.size()));
    if (status != CLEFT_OK)
        return status;
    const cleft_status result = guarded(context, body);
    // Also after a failure, as guarded() does not throw.
    cleft_context_end(context);
    return result;
}

// The pointer, or Error(CLEFT_ERROR_NULL) with the name of the argument.
template <class T>
T* required(T* pointer, const char* argument)
{
    if (!pointer)
        throw Error(CLEFT_ERROR_NULL, std::string(argument) + " is NULL");
    return pointer;
}

// An entry that makes something: *out is NULL unless all went well.
template <class T, class Body>
cleft_status entry_making(cleft_context* context, T** out, std::initializer_list<const void*> handles,
                          const Body& body) noexcept
{
    if (out)
        *out = nullptr;
    return entry(context, handles, [&] {
        required(out, "out");
        body();
    });
}

// A call into the core that failed, with the core's sentence (or, if it left none, the status) behind `what`.
// Not a std::string: made as an argument, it could fail between the call and whoever owns what the call made, for the
// order of arguments is the compiler's.
inline void check(cleft_context* context, cleft_status status, const char* what = "")
{
    if (status == CLEFT_OK)
        return;
    const std::string sentence = cleft_context_last_error(context);
    throw Error(status, std::string(what) + (sentence.empty() ? cleft_status_string(status) : sentence));
}

}  // namespace cleft::io
