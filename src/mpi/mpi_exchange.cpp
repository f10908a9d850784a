// MPI counts the bytes of a message in an int: longer ones go in pieces.
#include "mpi/mpi_exchange.hpp"

#include "base/error.hpp"
#include "base/to_size.hpp"

#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstring>
#include <numeric>
#include <thread>

namespace cleft::mpi
{

namespace
{

// Below 2^31, and so much that a piece costs nothing beside its bytes.
constexpr int64_t kMostBytesAMessage = int64_t{1} << 30;

bool has_worked(int result) { return result == MPI_SUCCESS; }

// Waiting in MPI takes a whole core. A rank that waits for one that works must not take it from that one's threads.
class Patience
{
public:
    void wait()
    {
        if (++waits_ <= kImmediate) {
            sched_yield();
            return;
        }
        std::this_thread::sleep_for(pause_);
        pause_ = std::min(2 * pause_, kLongestPause);
    }

private:
    // Ranks that work alike are here within some microseconds of each other.
    static constexpr int kImmediate = 200;
    static constexpr std::chrono::microseconds kLongestPause{1000};
    int waits_ = 0;
    std::chrono::microseconds pause_{10};
};

}  // namespace

MpiExchange::MpiExchange(MPI_Comm comm)
{
    int has_begun = 0, has_ended = 0;
    if (!has_worked(MPI_Initialized(&has_begun)) || !has_begun || !has_worked(MPI_Finalized(&has_ended)) || has_ended)
        throw Error(CLEFT_ERROR_ARGUMENT, "MPI is not running: MPI_Init() comes before, MPI_Finalize() after");
    if (comm == MPI_COMM_NULL)
        throw Error(CLEFT_ERROR_ARGUMENT, "the communicator is MPI_COMM_NULL");
    // Failures of the copy itself go where the caller's go.
    if (!has_worked(MPI_Comm_dup(comm, &comm_)))
        throw Error(CLEFT_ERROR_EXCHANGE, "MPI cannot copy the communicator");
    if (!has_worked(MPI_Comm_set_errhandler(comm_, MPI_ERRORS_RETURN)) || !has_worked(MPI_Comm_rank(comm_, &rank_)) ||
        !has_worked(MPI_Comm_size(comm_, &ranks_))) {
        MPI_Comm_free(&comm_);
        throw Error(CLEFT_ERROR_EXCHANGE, "MPI cannot tell the ranks of the communicator");
    }
    // Most messages then need no memory when others wait for them already.
    requests_.reserve(to_size(2 * ranks_));
}

MpiExchange::~MpiExchange() { MPI_Comm_free(&comm_); }

Messenger MpiExchange::messenger()
{
    return {rank_, ranks_, "", [this](const int64_t* send, int64_t* receive) { return numbers(send, receive); },
            [this](const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes) {
                return bytes(send, send_sizes, receive, receive_sizes);
            }};
}

bool MpiExchange::numbers(const int64_t* send, int64_t* receive)
{
    MPI_Request request = MPI_REQUEST_NULL;
    if (!has_worked(MPI_Ialltoall(send, 1, MPI_INT64_T, receive, 1, MPI_INT64_T, comm_, &request)))
        return false;
    Patience patience;
    for (int is_done = 0;;) {
        if (!has_worked(MPI_Test(&request, &is_done, MPI_STATUS_IGNORE)))
            return false;
        if (is_done)
            return true;
        patience.wait();
    }
}

bool MpiExchange::bytes(const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes)
{
    const auto pieces = [&](const int64_t* sizes) {
        return std::accumulate(sizes, sizes + ranks_, size_t{0}, [](size_t sum, int64_t size) {
            return sum + to_size((size + kMostBytesAMessage - 1) / kMostBytesAMessage);
        });
    };
    requests_.clear();
    // Before the first message: with one under way there is no way back.
    requests_.reserve(pieces(send_sizes) + pieces(receive_sizes));
    // Messages of the same two ranks arrive in the order in which they were sent, so pieces need no numbers.
    const auto in_pieces = [&](char* begin, int64_t size, const auto& start) {
        bool worked = true;
        for (int64_t done = 0; done < size && worked; done += kMostBytesAMessage) {
            requests_.push_back(MPI_REQUEST_NULL);
            const auto piece = static_cast<int>(std::min(kMostBytesAMessage, size - done));
            worked = has_worked(start(begin + done, piece, &requests_.back()));
        }
        return worked;
    };
    char* to = static_cast<char*>(receive);
    char* own = to;
    for (int r = 0; r < ranks_; to += receive_sizes[r++]) {
        if (r == rank_)
            own = to;
        else if (!in_pieces(to, receive_sizes[r], [&](char* at, int count, MPI_Request* request) {
                     return MPI_Irecv(at, count, MPI_BYTE, r, 0, comm_, request);
                 }))
            return false;
    }
    char* from = static_cast<char*>(const_cast<void*>(send));  // MPI only reads it
    for (int r = 0; r < ranks_; from += send_sizes[r++]) {
        if (r != rank_) {
            if (!in_pieces(from, send_sizes[r], [&](char* at, int count, MPI_Request* request) {
                    return MPI_Isend(at, count, MPI_BYTE, r, 0, comm_, request);
                }))
                return false;
        } else if (send_sizes[r] > 0) {
            std::memcpy(own, from, to_size(send_sizes[r]));
        }
    }
    // All ranks are here: whoever sends bytes has told their numbers before.
    return has_worked(MPI_Waitall(static_cast<int>(requests_.size()), requests_.data(), MPI_STATUSES_IGNORE));
}

}  // namespace cleft::mpi
