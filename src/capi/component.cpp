// For components that are built on this library: several calls as one call of a context.
#include "capi/firewall.hpp"

using namespace cleft::capi;

namespace
{

// Calls body(handle) with the handle's own type.
// Handles come as void*, in one list of any kind, so the mark alone says what they are.
template <class Body>
void with_handle(const void* handle, const Body& body)
{
    switch (*static_cast<const Mark*>(handle)) {
        case Mark::context:
            return body(*static_cast<const cleft_context*>(handle));
        case Mark::options:
            return body(*static_cast<const cleft_options*>(handle));
        case Mark::volume:
            return body(*static_cast<const cleft_volume*>(handle));
        case Mark::sizing:
            return body(*static_cast<const cleft_sizing*>(handle));
        case Mark::mesh:
            return body(*static_cast<const cleft_mesh*>(handle));
        case Mark::surface:
            return body(*static_cast<const cleft_surface*>(handle));
        case Mark::report:
            return body(*static_cast<const cleft_report*>(handle));
        case Mark::part:
            return body(*static_cast<const cleft_part*>(handle));
        case Mark::dead:
            break;
    }
    throw cleft::Error(CLEFT_ERROR_HANDLE, "one of the handles is not a handle of this library");
}

void keep(cleft::Array<const void*>& kept, const void* handle)
{
    with_handle(handle, [](const auto& of_kind) { ++of_kind.owners.count; });
    kept.push_back(handle);
}

void let_go(const cleft::Array<const void*>& kept) noexcept
{
    // No handle is dead here, since this list owns each; so with_handle() does not throw.
    for (const void* handle : kept)
        with_handle(handle, [](const auto& of_kind) { release(of_kind); });
}

}  // namespace

cleft_status cleft_context_begin(cleft_context* context, const void* const* handles, int64_t count) noexcept
{
    if (!context)
        return CLEFT_ERROR_NULL;
    if (!is_sound(context))
        return CLEFT_ERROR_HANDLE;
    // Not guarded_call(): the context stays taken when this function returns, until cleft_context_end().
    if (!context->occupancy.enter())
        return CLEFT_ERROR_BUSY;
    cleft::Array<const void*> kept;
    // The calls inside must not forget a cancel; they are not outermost, and so leave it.
    begin(*context);
    const cleft_status status = guarded(&context->message, [&] {
        kept.reserve(count + 1);
        // All memory is taken before anything is owned: push_back() below then cannot fail with owners counted.
        context->kept.reserve(context->kept.size() + 1);
        // A callback of the component may destroy the context too.
        keep(kept, context);
        for (int64_t i = 0; i < count; ++i)
            // Optional arguments are passed on as they are.
            if (handles[i])
                keep(kept, handles[i]);
    });
    if (status == CLEFT_OK) {
        context->kept.push_back(std::move(kept));
        return status;
    }
    context->occupancy.leave();
    let_go(kept);
    return status;
}

cleft_status cleft_context_report(cleft_context* context, double fraction, double end, const char* stage) noexcept
{
    return guarded_call(context, [&](cleft_context& sound) {
        required(stage, "stage");
        if (!(0 <= fraction && fraction <= end && end <= 1))
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "fraction and end must be in 0 .. 1, and fraction not above end");
        sound.part_begin = fraction;
        sound.part_end = end;
        bool cancel = sound.cancel;
        if (!cancel && sound.progress) {
            const Occupancy::Callback callback(sound.occupancy);
            cancel = sound.progress(fraction, stage, sound.progress_user) != 0;
        }
        if (cancel)
            throw cleft::Error(CLEFT_ERROR_CANCELLED, "the run was cancelled");
    });
}

void cleft_context_end(cleft_context* context) noexcept
{
    // A component calls this in its cleanup, whether its cleft_context_begin() succeeded or not.
    if (!is_sound(context) || context->occupancy.is_others() || context->kept.empty())
        return;
    // A call may begin within another one, so the lists are a stack.
    const cleft::Array<const void*> kept = std::move(context->kept.back());
    context->kept.pop_back();
    context->occupancy.leave();
    let_go(kept);
}
