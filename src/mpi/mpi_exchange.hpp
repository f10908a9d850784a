// Messages by MPI, on a copy of the caller's communicator.
#pragma once

#include "parts/exchange.hpp"

#include <mpi.h>

#include <cstdint>
#include <vector>

namespace cleft::mpi
{

class MpiExchange
{
public:
    // All ranks of the communicator make it and end it. Throws Error.
    explicit MpiExchange(MPI_Comm comm);
    ~MpiExchange();
    MpiExchange(const MpiExchange&) = delete;
    MpiExchange& operator=(const MpiExchange&) = delete;

    int32_t rank() const { return rank_; }
    int32_t ranks() const { return ranks_; }

    // The functions of cleft_exchange. False: the ranks cannot reach each other.
    bool numbers(const int64_t* send, int64_t* receive);
    bool bytes(const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes);

    // It must outlive the result.
    Messenger messenger();

private:
    MPI_Comm comm_ = MPI_COMM_NULL;
    int rank_ = 0, ranks_ = 1;
    std::vector<MPI_Request> requests_;  // of the message that is under way
};

}  // namespace cleft::mpi
