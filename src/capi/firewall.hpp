// The one wrapper that every entry of the C interface goes through: no exception leaves the library, and every failure
// becomes a status with a sentence on the context.
#pragma once

#include "base/run.hpp"
#include "capi/handles.hpp"
#include "capi/reporter.hpp"

#include <algorithm>
#include <new>
#include <string>

namespace cleft::capi
{

template <class Handle>
constexpr Mark mark_of();
template <>
constexpr Mark mark_of<cleft_context>()
{
    return Mark::context;
}
template <>
constexpr Mark mark_of<cleft_options>()
{
    return Mark::options;
}
template <>
constexpr Mark mark_of<cleft_volume>()
{
    return Mark::volume;
}
template <>
constexpr Mark mark_of<cleft_sizing>()
{
    return Mark::sizing;
}
template <>
constexpr Mark mark_of<cleft_mesh>()
{
    return Mark::mesh;
}
template <>
constexpr Mark mark_of<cleft_surface>()
{
    return Mark::surface;
}
template <>
constexpr Mark mark_of<cleft_report>()
{
    return Mark::report;
}

template <class Handle>
bool is_sound(const Handle* handle) noexcept
{
    return handle && handle->mark == mark_of<Handle>();
}

// Puts a sentence where its owner reads it (or nowhere, if null), cut to what fits.
void set_message(Message* message, const char* sentence) noexcept;

template <class Handle>
Message* message_of(Handle* handle) noexcept
{
    return is_sound(handle) ? &handle->message : nullptr;
}

// The handle, or an Error that names the argument.
template <class Handle>
Handle& checked(Handle* handle, const char* argument)
{
    if (!handle)
        throw Error(CLEFT_ERROR_NULL, std::string(argument) + " is NULL");
    if (handle->mark != mark_of<std::remove_const_t<Handle>>())
        throw Error(CLEFT_ERROR_HANDLE, std::string(argument) + " is a handle of another kind, or was destroyed");
    return *handle;
}

template <class T>
T* required(T* pointer, const char* argument)
{
    if (!pointer)
        throw Error(CLEFT_ERROR_NULL, std::string(argument) + " is NULL");
    return pointer;
}

template <class Handle>
void destroy(Handle* handle) noexcept
{
    if (!is_sound(handle))
        return;
    handle->mark = Mark::dead;
    delete handle;
}

// Runs `body` and turns what it throws into a status and a sentence.
template <class Body>
cleft_status guarded(Message* message, const Body& body) noexcept
{
    try {
        body();
        return CLEFT_OK;
    } catch (const std::bad_alloc&) {
        set_message(message, "there is not enough memory");
        return CLEFT_ERROR_OUT_OF_MEMORY;
    } catch (const Error& error) {
        set_message(message, error.what());
        return error.status();
    } catch (const std::length_error&) {  // a container asked for more than the address space
        set_message(message, "there is not enough memory");
        return CLEFT_ERROR_OUT_OF_MEMORY;
    } catch (const std::exception& error) {
        set_message(message, error.what());
        return CLEFT_ERROR_INTERNAL;
    } catch (...) {
        set_message(message, "an unknown exception was thrown");
        return CLEFT_ERROR_INTERNAL;
    }
}

// An entry that may run long: clears the last message and cancel request, and gives the body a Run.
template <class Body>
cleft_status guarded_run(cleft_context* context, const Body& body) noexcept
{
    if (!context)
        return CLEFT_ERROR_NULL;
    if (!is_sound(context))
        return CLEFT_ERROR_HANDLE;
    context->message[0] = '\0';
    context->cancel = false;
    Reporter reporter(*context);
    return guarded(&context->message, [&] {
        Run run;
        run.threads = context->threads;
        run.cancel = &context->cancel;
        run.metrics = &context->metrics;
        if (context->progress) {
            run.progress = [&](double fraction, const char* stage) { return reporter.report(fraction, stage); };
            run.repeat_progress = [&] { return reporter.repeat(); };
        }
        if (context->log)
            run.log = [context](int level, const std::string& sentence) {
                context->log(level, sentence.c_str(), context->log_user);
            };
        body(run);
    });
}

// An entry that makes a handle: *out is NULL unless all went well.
template <class Handle, class Make>
cleft_status guarded_create(cleft_context* context, Handle** out, const Make& make) noexcept
{
    if (out)
        *out = nullptr;
    return guarded_run(context, [&](const Run& run) {
        required(out, "out");
        *out = new Handle(make(run));
    });
}

}  // namespace cleft::capi
