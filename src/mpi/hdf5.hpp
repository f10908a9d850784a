// HDF5 without its messages on standard error: what fails throws a sentence.
#pragma once

#include <hdf5.h>

#include <utility>

namespace cleft::mpi
{

// While it lives, HDF5 prints nothing.
class QuietHdf5
{
public:
    QuietHdf5();
    ~QuietHdf5();
    QuietHdf5(const QuietHdf5&) = delete;
    QuietHdf5& operator=(const QuietHdf5&) = delete;

private:
    H5E_auto2_t function_ = nullptr;
    void* data_ = nullptr;
};

// Throws the reason that HDF5 gives for its last failure, as an Error(CLEFT_ERROR_FILE).
[[noreturn]] void throw_hdf5_failure();

// The answer of a call, which failed if it is negative.
template <class Answer>
Answer checked_hdf5(Answer answer)
{
    if (answer < 0)
        throw_hdf5_failure();
    return answer;
}

// Owns what a call of HDF5 opened.
class Hdf5Id
{
public:
    using Close = herr_t (*)(hid_t);
    // Throws if `id` is negative: the call has failed.
    Hdf5Id(hid_t id, Close close) : id_(checked_hdf5(id)), close_(close) {}
    Hdf5Id(Hdf5Id&& other) noexcept : id_(std::exchange(other.id_, -1)), close_(other.close_) {}
    ~Hdf5Id()
    {
        if (id_ >= 0)
            close_(id_);
    }
    Hdf5Id(const Hdf5Id&) = delete;
    Hdf5Id& operator=(const Hdf5Id&) = delete;
    operator hid_t() const { return id_; }
    // For files: what was written may fail to arrive here.
    void close() { checked_hdf5(close_(std::exchange(id_, -1))); }

private:
    hid_t id_;
    Close close_;
};

}  // namespace cleft::mpi
