/*
 * The first part of cleft.hpp: errors, views, owners of handles, contexts and options. Include cleft.hpp.
 */
#ifndef CLEFT_CONTEXT_HPP
#define CLEFT_CONTEXT_HPP

#include "cleft/cleft.h"

#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace cleft
{
inline namespace cpp  // apart from the names within the library, which may be linked statically
{

class Error : public std::runtime_error
{
public:
    Error(cleft_status status, const std::string& sentence)
        : std::runtime_error(sentence.empty() ? cleft_status_string(status) : sentence), status_(status)
    {
    }
    /** One of the codes of cleft_status.h, never CLEFT_OK. */
    cleft_status status() const noexcept { return status_; }

private:
    cleft_status status_;
};

/** Throws for a function without a context, which stores no sentence. */
inline void check(cleft_status status)
{
    if (status != CLEFT_OK)
        throw Error(status, "");
}

/** An array that another object owns. */
template <class T>
class View
{
public:
    View(const T* data, int64_t size) : data_(data), size_(static_cast<std::size_t>(size)) {}
    const T* data() const noexcept { return data_; }
    std::size_t size() const noexcept { return size_; }
    bool empty() const noexcept { return size_ == 0; }
    const T* begin() const noexcept { return data_; }
    const T* end() const noexcept { return data_ + size_; }
    const T& operator[](std::size_t i) const noexcept { return data_[i]; }
    std::vector<T> copy() const { return std::vector<T>(begin(), end()); }

private:
    const T* data_;
    std::size_t size_;
};

/** The base of all classes below: the owner of a handle of C. */
template <class T, class Destroy>
class Owner
{
public:
    /** Takes ownership of a handle that a function of C made. */
    explicit Owner(T* owned) : handle_(owned) {}
    T* get() const noexcept { return handle_.get(); }
    /** Gives up ownership: the caller must destroy the handle. */
    T* release() noexcept { return handle_.release(); }

private:
    std::unique_ptr<T, Destroy> handle_;
};

#define CLEFT_CPP_DESTROY(name)                                                                  \
    struct Destroy_##name {                                                                      \
        void operator()(cleft_##name* handle) const noexcept { cleft_##name##_destroy(handle); } \
    };
CLEFT_CPP_DESTROY(context)
CLEFT_CPP_DESTROY(options)
CLEFT_CPP_DESTROY(volume)
CLEFT_CPP_DESTROY(sizing)
CLEFT_CPP_DESTROY(mesh)
CLEFT_CPP_DESTROY(surface)
CLEFT_CPP_DESTROY(report)
#undef CLEFT_CPP_DESTROY

/** Returns false to cancel the call. */
using Progress = std::function<bool(double fraction, const char* stage)>;
using Log = std::function<void(int32_t level, const char* sentence)>;

class Context : public Owner<cleft_context, Destroy_context>
{
public:
    Context() : Owner(make()), callbacks_(new Callbacks) {}

    void set_threads(int32_t threads) { check(cleft_context_set_threads(get(), threads)); }
    int32_t threads() const noexcept { return cleft_context_threads(get()); }
    /** An empty function removes the callback. */
    void set_progress(Progress progress)
    {
        check(cleft_context_set_progress(get(), progress ? on_progress : nullptr, callbacks_.get()));
        callbacks_->progress = std::move(progress);
    }
    void set_log(Log log)
    {
        check(cleft_context_set_log(get(), log ? on_log : nullptr, callbacks_.get()));
        callbacks_->log = std::move(log);
    }
    /** Asks the running call to stop. Any thread may call it. */
    void cancel() noexcept { cleft_context_cancel(get()); }

    std::vector<std::pair<std::string, double>> metrics() const
    {
        std::vector<std::pair<std::string, double>> all;
        for (int64_t i = 0; i < cleft_context_metric_count(get()); ++i) {
            const char* name = nullptr;
            double value = 0;
            cleft::check(cleft_context_metric(get(), i, &name, &value));
            all.emplace_back(name, value);
        }
        return all;
    }

    /** Throws the exception of a callback, or an Error if the status of a call on this context is not CLEFT_OK. */
    void check(cleft_status status) const
    {
        std::exception_ptr thrown;
        if (callbacks_)  // not after a move
            std::swap(thrown, callbacks_->thrown);
        if (thrown)
            std::rethrow_exception(thrown);
        if (status != CLEFT_OK)
            throw Error(status, status == CLEFT_ERROR_BUSY ? "" : cleft_context_last_error(get()));
    }

private:
    struct Callbacks {
        Progress progress;
        Log log;
        std::exception_ptr thrown;
    };

    static cleft_context* make()
    {
        cleft_context* made = nullptr;
        cleft::check(cleft_context_create(&made));
        return made;
    }
    static int on_progress(double fraction, const char* stage, void* user) noexcept
    {
        Callbacks& to = *static_cast<Callbacks*>(user);
        try {
            return to.thrown || !to.progress(fraction, stage);
        } catch (...) {
            to.thrown = std::current_exception();
            return 1;
        }
    }
    static void on_log(int32_t level, const char* sentence, void* user) noexcept
    {
        Callbacks& to = *static_cast<Callbacks*>(user);
        try {
            if (!to.thrown)
                to.log(level, sentence);
        } catch (...) {
            to.thrown = std::current_exception();
        }
    }

    std::unique_ptr<Callbacks> callbacks_;  // stays in its place when this is moved
};

/** Owns the handle that a function of C makes. The last argument of that function is where the handle goes. */
template <class Owned, class T, class Make>
Owned made(const Context& context, const Make& make)
{
    T* out = nullptr;
    const cleft_status status = make(&out);
    Owned owned(out);
    context.check(status);
    return owned;
}

class Options : public Owner<cleft_options, Destroy_options>
{
public:
    Options() : Owner(make()) {}

    Options& set_integer(cleft_option key, int64_t value)
    {
        return checked(cleft_options_set_integer(get(), key, value));
    }
    Options& set_real(cleft_option key, double value) { return checked(cleft_options_set_real(get(), key, value)); }
    /** Sets an option by its name: set("size_min", "0.5"). */
    Options& set(const std::string& name, const std::string& value)
    {
        return checked(cleft_options_set_text(get(), name.c_str(), value.c_str()));
    }
    Options& set_label_size(int32_t label, double size)
    {
        return checked(cleft_options_set_label_size(get(), label, size));
    }
    Options& set_strip(const std::vector<int32_t>& labels)
    {
        return checked(cleft_options_set_strip(get(), labels.data(), static_cast<int64_t>(labels.size())));
    }
    Options& set_only(const std::vector<int32_t>& labels)
    {
        return checked(cleft_options_set_only(get(), labels.data(), static_cast<int64_t>(labels.size())));
    }
    int64_t get_integer(cleft_option key) const
    {
        int64_t value = 0;
        check(cleft_options_get_integer(get(), key, &value));
        return value;
    }
    double get_real(cleft_option key) const
    {
        double value = 0;
        check(cleft_options_get_real(get(), key, &value));
        return value;
    }

private:
    static cleft_options* make()
    {
        cleft_options* made = nullptr;
        check(cleft_options_create(&made));
        return made;
    }
    Options& checked(cleft_status status)
    {
        if (status != CLEFT_OK)
            throw Error(status, cleft_options_last_error(get()));
        return *this;
    }
};

}  // namespace cpp
}  // namespace cleft

#endif
