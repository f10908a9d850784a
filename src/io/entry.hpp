// The wrapper of every entry: no exception leaves the component, and every failure leaves its sentence on the context.
#pragma once

#include "base/error.hpp"

#include <new>
#include <string>

namespace cleft::io
{

template <class Body>
cleft_status entry(cleft_context* context, const Body& body) noexcept
{
    const auto failed = [context](cleft_status status, const char* sentence) {
        cleft_context_set_error(context, status, sentence);
        return status;
    };
    try {
        body();
        return CLEFT_OK;
    } catch (const std::bad_alloc&) {
        return failed(CLEFT_ERROR_OUT_OF_MEMORY, "out of memory");
    } catch (const Error& error) {
        return failed(error.status(), error.what());
    } catch (const std::exception& error) {
        return failed(CLEFT_ERROR_INTERNAL, error.what());
    } catch (...) {
        return failed(CLEFT_ERROR_INTERNAL, "an unknown exception");
    }
}

// A call into the core that failed, with the core's sentence behind `what` (which may be empty).
inline void check(cleft_context* context, cleft_status status, const std::string& what = "")
{
    if (status != CLEFT_OK)
        throw Error(status, what + cleft_context_last_error(context));
}

template <class T>
T* required(T* pointer, const char* argument)
{
    if (!pointer)
        throw Error(CLEFT_ERROR_NULL, std::string(argument) + " is NULL");
    return pointer;
}

}  // namespace cleft::io
