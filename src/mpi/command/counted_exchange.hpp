// An exchange that counts what this rank sends to others, by the work that the library does meanwhile.
#pragma once

#include "cleft/cleft_mpi.h"
#include "cli/session.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace cleft_mpi_cli
{

struct Sent {
    std::string work;      // in words, as progress names it; "" before the first
    int64_t messages = 0;  // to one rank each, of one number or more
    int64_t bytes = 0;
};

// Of all ranks of the run. All make it and end it. It points to itself.
class CountedExchange
{
public:
    explicit CountedExchange(const cleft_cli::Session& session);
    ~CountedExchange() { cleft_mpi_exchange_close(&inner_); }
    CountedExchange(const CountedExchange&) = delete;
    CountedExchange& operator=(const CountedExchange&) = delete;

    // For the library.
    cleft_exchange exchange() const;
    // In the order in which the works began.
    const std::vector<Sent>& sent() const { return sent_; }

private:
    static int send_numbers(const int64_t* send, int64_t* receive, void* user);
    static int send_bytes(const void* send, const int64_t* send_sizes, void* receive, const int64_t* receive_sizes,
                          void* user);
    void count(int64_t messages, int64_t bytes);

    const cleft_cli::Session& session_;
    cleft_exchange inner_{};
    std::vector<Sent> sent_;
};

}  // namespace cleft_mpi_cli
