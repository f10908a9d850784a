// Which call has a context: one at a time, and none from within a callback of another.
#pragma once

#include <atomic>
#include <thread>

namespace cleft::capi
{

class Occupancy
{
public:
    // Takes the context for a call on this thread. False if another thread has it, or if this one is in a callback.
    // A component that has taken it may take it again, for the calls that its own call is made of.
    // Never waits: a callback that called back would wait for itself, and a program that shares a context by mistake
    // learns so.
    bool enter() noexcept
    {
        auto caller = std::thread::id();
        if (caller_.compare_exchange_strong(caller, std::this_thread::get_id())) {
            depth_ = 1;
            return true;
        }
        if (caller != std::this_thread::get_id() || in_callback_)
            return false;
        ++depth_;
        return true;
    }

    void leave() noexcept
    {
        if (--depth_ == 0)
            caller_ = std::thread::id();
    }

    // Is the call that entered last a call of the user's, not one of a component?
    bool is_outermost() const noexcept { return depth_ == 1; }

    // Does a call on another thread have it?
    bool is_others() const noexcept
    {
        const auto caller = caller_.load();
        return caller != std::thread::id() && caller != std::this_thread::get_id();
    }

    // While a callback runs. Only on the thread that has the context.
    class Callback
    {
    public:
        // Restores what was before instead of clearing it, so that callbacks may nest.
        explicit Callback(Occupancy& of) noexcept : of_(of), before_(of.in_callback_) { of_.in_callback_ = true; }
        Callback(const Callback&) = delete;
        Callback& operator=(const Callback&) = delete;
        ~Callback() { of_.in_callback_ = before_; }

    private:
        Occupancy& of_;
        bool before_;
    };

private:
    // The default id is that of no thread, which stands for a context that is free.
    std::atomic<std::thread::id> caller_{std::thread::id()};
    int depth_ = 0;  // this and the next of the caller's thread alone
    bool in_callback_ = false;
};

}  // namespace cleft::capi
