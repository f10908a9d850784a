// The one wrapper that every entry of the C interface goes through: no exception leaves the library, and every failure
// becomes a status with a sentence on the context.
#pragma once

#include "base/run.hpp"
#include "base/status_of.hpp"
#include "base/team.hpp"
#include "base/utf8.hpp"
#include "capi/handles.hpp"
#include "capi/reporter.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <string>

namespace cleft::capi
{

// For entries that return a value and no status: they answer 0, NULL or "" where the handle is not sound. A caller that
// knows handles only as pointers easily passes one of another kind.
template <class Handle>
bool is_sound(const Handle* handle) noexcept
{
    return handle && handle->mark == Handle::kMark;
}

// Puts a sentence where its owner reads it (or nowhere, if null), cut to what fits.
void set_message(Message* message, const char* sentence) noexcept;

inline Message* message_of(cleft_options* options) noexcept { return is_sound(options) ? &options->message : nullptr; }

// The handle, or an Error that names the argument.
// The sentence names the argument, since a call has several and a debugger shows only the status.
template <class Handle>
Handle& checked(Handle* handle, const char* argument)
{
    if (!handle)
        throw Error(CLEFT_ERROR_NULL, std::string(argument) + " is NULL");
    if (handle->mark != std::remove_const_t<Handle>::kMark)
        throw Error(CLEFT_ERROR_HANDLE, std::string(argument) + " is a handle of another kind");
    return *handle;
}

// The pointer, or an Error that names the argument.
template <class T>
T* required(T* pointer, const char* argument)
{
    if (!pointer)
        throw Error(CLEFT_ERROR_NULL, std::string(argument) + " is NULL");
    return pointer;
}

// Ends one ownership of a handle; the last one ends the handle.
template <class Handle>
void release(const Handle& handle) noexcept
{
    if (--handle.owners.count > 0)
        return;
    // Immutable handles are held as const, but their end is not a change that anyone could see. The mark makes a second
    // _destroy harmless while the memory is not used again.
    const_cast<Handle&>(handle).mark = Mark::dead;
    delete &handle;
}

// For the functions _destroy: NULL and handles of another kind are left alone, since there is no status to return.
template <class Handle>
void destroy(Handle* handle) noexcept
{
    if (is_sound(handle))
        release(*handle);
}

// Owns a handle while a call works with it: a callback may destroy it.
template <class Handle>
class Held
{
public:
    explicit Held(Handle& handle) noexcept : handle_(handle) { ++handle_.owners.count; }
    Held(const Held& other) noexcept : Held(other.handle_) {}
    Held& operator=(const Held&) = delete;
    ~Held() { release(handle_); }
    Handle& operator*() const noexcept { return handle_; }
    Handle* operator->() const noexcept { return &handle_; }

private:
    Handle& handle_;
};

// Checks a handle and owns it as long as the result lives: to the end of a call.
template <class Handle>
Held<const Handle> held(const Handle* handle, const char* argument)
{
    return Held<const Handle>(checked(handle, argument));
}

// The same for an argument that may be NULL.
template <class Handle>
std::optional<Held<const Handle>> held_if_any(const Handle* handle, const char* argument)
{
    return handle ? std::optional<Held<const Handle>>(held(handle, argument)) : std::nullopt;
}

// Runs `body` and turns what it throws into a status and a sentence.
template <class Body>
cleft_status guarded(Message* message, const Body& body) noexcept
{
    return status_of(body, [message](cleft_status status, const char* sentence) noexcept {
        set_message(message, sentence);
        return status;
    });
}

// Takes a context for a call, and gives it free again.
class Entered
{
public:
    explicit Entered(cleft_context& context) noexcept : context_(context), entered_(context.occupancy.enter()) {}
    Entered(const Entered&) = delete;
    Entered& operator=(const Entered&) = delete;
    ~Entered()
    {
        if (entered_)
            context_->occupancy.leave();
    }
    explicit operator bool() const noexcept { return entered_; }

private:
    Held<cleft_context> context_;
    bool entered_;
};

// An entry that needs the context to itself. CLEFT_ERROR_BUSY leaves no sentence: the context is another call's.
// A NULL or foreign context can keep no sentence, so the status alone must say which it is.
template <class Body>
cleft_status guarded_call(cleft_context* context, const Body& body) noexcept
{
    if (!context)
        return CLEFT_ERROR_NULL;
    if (!is_sound(context))
        return CLEFT_ERROR_HANDLE;
    const Entered entered(*context);
    return entered ? guarded(&context->message, [&] { body(*context); }) : CLEFT_ERROR_BUSY;
}

// Forgets what the call before left: its sentence, and requests to cancel it.
inline void begin(cleft_context& context) noexcept
{
    context.message[0] = '\0';
    // A user's cancel must also reach the later calls of a component, so only the outermost call forgets requests.
    if (context.occupancy.is_outermost()) {
        context.cancel = false;
        context.part_begin = 0;
        context.part_end = 1;
    }
}

// Hands a sentence to the caller's log, if there is one, as set_message() keeps it, but whole.
inline void say(cleft_context& context, int32_t level, const char* sentence)
{
    // While it runs, the context answers CLEFT_ERROR_BUSY: a call from within would change what the outer one works
    // with.
    const Occupancy::Callback callback(context.occupancy);
    if (context.log)
        context.log(level, printable(sentence).c_str(), context.log_user);
}

// An entry that may run long: clears the last message and cancel request, and gives the body a Run. `stage` is what
// progress calls the work until a stage within it has a name.
template <class Body>
cleft_status guarded_run(cleft_context* context, const char* stage, const Body& body) noexcept
{
    return guarded_call(context, [&](cleft_context& sound) {
        begin(sound);
        Reporter reporter(sound, stage);
        std::atomic<int64_t> loop_time{0};
        Team team(sound.threads);
        Run run;
        run.loop_time = &loop_time;
        run.threads = sound.threads;
        run.team = &team;
        run.cancel = &sound.cancel;
        run.metrics = &sound.metrics;
        // Stages ask whether there is a callback, and spend no time on progress that nobody sees.
        if (sound.progress) {
            run.progress = [&](double fraction, const char* stage) { return reporter.report(fraction, stage); };
            run.repeat_progress = [&] { return reporter.repeat(); };
        }
        if (sound.log)
            run.on_warning = [&sound](const std::string& sentence) { say(sound, CLEFT_LOG_WARNING, sentence.c_str()); };
        body(run);
    });
}

// An entry that makes a handle: *out is NULL unless all went well.
template <class Handle, class Make>
cleft_status guarded_create(cleft_context* context, Handle** out, const char* stage, const Make& make) noexcept
{
    // Even where all else fails: callers destroy *out in their cleanup without a look at the status.
    if (out)
        *out = nullptr;
    return guarded_run(context, stage, [&](const Run& run) {
        required(out, "out");
        auto made = std::make_unique<Handle>(make(run));
        // The last report may cancel. Then the handle goes with its owner, and *out is still NULL.
        run.report(1, nullptr);
        *out = made.release();
    });
}

}  // namespace cleft::capi
