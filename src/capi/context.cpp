// Contexts: what a caller sets for its calls, and what the last call left there. Also the few functions that need no
// handle.
#include "base/utf8.hpp"
#include "capi/firewall.hpp"

#include <algorithm>
#include <thread>

namespace cleft::capi
{

void set_message(Message* message, const char* sentence) noexcept
{
    // Entries without a context have nowhere to put one.
    if (!message)
        return;
    // Names of files and words of callers stand in sentences, which are text nevertheless. They are cut, not refused:
    // the beginning of a sentence names the fault.
    size_t size = 0;
    cleft::for_each_printable(sentence ? sentence : "", [&](std::string_view character) {
        const bool has_room = size + character.size() < message->size();
        if (has_room)
            size += character.copy(message->data() + size, character.size());
        return has_room;
    });
    (*message)[size] = '\0';
}

}  // namespace cleft::capi

using namespace cleft::capi;

const char* cleft_version(int32_t* major, int32_t* minor, int32_t* patch) noexcept
{
    // Each may be NULL: some callers compare one number, others print the text.
    if (major)
        *major = CLEFT_VERSION_MAJOR;
    if (minor)
        *minor = CLEFT_VERSION_MINOR;
    if (patch)
        *patch = CLEFT_VERSION_PATCH;
    return CLEFT_VERSION_STRING;
}

const char* cleft_status_string(cleft_status status) noexcept
{
    switch (status) {
#define CLEFT_STATUS_CASE(name, number, text) \
    case number:                              \
        return text;
        CLEFT_STATUS_LIST(CLEFT_STATUS_CASE)
#undef CLEFT_STATUS_CASE
        // A program may be newer than the library. NULL would crash the printf() that nearly every caller passes this
        // to.
        default:
            return "unknown status";
    }
}

// A function, not a macro: a program can run with another build of the library than it was compiled with.
int32_t cleft_has_tetgen(void) noexcept
{
#ifdef CLEFT_WITH_TETGEN
    return 1;
#else
    return 0;
#endif
}

cleft_status cleft_context_create(cleft_context** out) noexcept
{
    return guarded(nullptr, [&] {
        // First, since nothing would own a context that cannot be handed out.
        required(out, "out");
        *out = new cleft_context;
    });
}

void cleft_context_destroy(cleft_context* context) noexcept { destroy(context); }

const char* cleft_context_last_error(const cleft_context* context) noexcept
{
    // A caller that got CLEFT_ERROR_BUSY may ask for the sentence while the other thread still writes one.
    return is_sound(context) && !context->occupancy.is_others() ? context->message.data() : "";
}

cleft_status cleft_context_set_error(cleft_context* context, cleft_status status, const char* sentence) noexcept
{
    if (!is_sound(context))
        return status;
    const Entered entered(*context);
    if (!entered)
        return CLEFT_ERROR_BUSY;
    set_message(&context->message, sentence);
    return status;
}

cleft_status cleft_context_set_threads(cleft_context* context, int32_t threads) noexcept
{
    return guarded_call(context, [&](cleft_context& sound) {
        // The bound catches numbers that were never set.
        if (threads < 0 || threads > 1024)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT,
                               "threads is " + std::to_string(threads) + "; it must be 0 .. 1024");
        // 0 where the system does not say.
        const auto machine = static_cast<int32_t>(std::thread::hardware_concurrency());
        sound.threads = threads > 0 ? threads : std::max<int32_t>(1, machine);
    });
}

int32_t cleft_context_threads(const cleft_context* context) noexcept
{
    return is_sound(context) ? context->threads : 0;
}

cleft_status cleft_context_set_progress(cleft_context* context, cleft_progress_callback callback, void* user) noexcept
{
    return guarded_call(context, [&](cleft_context& sound) {
        sound.progress = callback;
        sound.progress_user = user;
    });
}

cleft_status cleft_context_set_log(cleft_context* context, cleft_log_callback callback, void* user) noexcept
{
    return guarded_call(context, [&](cleft_context& sound) {
        sound.log = callback;
        sound.log_user = user;
    });
}

cleft_status cleft_context_log(cleft_context* context, int32_t level, const char* sentence) noexcept
{
    return guarded_call(context, [&](cleft_context& sound) {
        required(sentence, "sentence");
        // Bindings turn the level into a value of an enumeration, which has no others.
        if (level < CLEFT_LOG_WARNING || level > CLEFT_LOG_DEBUG)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "level is " + std::to_string(level) + "; it must be 1 .. 3");
        say(sound, level, sentence);
    });
}

cleft_status cleft_context_cancel(cleft_context* context) noexcept
{
    // Not guarded_call(): the caller is another thread, or a callback, while the context is taken.
    return guarded(nullptr, [&] { checked(context, "context").cancel = true; });
}

int64_t cleft_context_metric_count(const cleft_context* context) noexcept
{
    // A callback may look at the metrics so far. Another thread would read a list that grows.
    const bool readable = is_sound(context) && !context->occupancy.is_others();
    return readable ? static_cast<int64_t>(context->metrics.items.size()) : 0;
}

cleft_status cleft_context_metric(const cleft_context* context, int64_t index, const char** name,
                                  double* value) noexcept
{
    return guarded(nullptr, [&] {
        if (checked(context, "context").occupancy.is_others())
            throw cleft::Error(CLEFT_ERROR_BUSY, "another thread has the context");
        const auto& items = context->metrics.items;
        if (index < 0 || index >= static_cast<int64_t>(items.size()))
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there is no such metric");
        required(name, "name");
        required(value, "value");
        *name = items[index].first.c_str();
        *value = items[index].second;
    });
}

cleft_status cleft_context_clear_metrics(cleft_context* context) noexcept
{
    return guarded_call(context, [](cleft_context& sound) { sound.metrics.items.clear(); });
}
