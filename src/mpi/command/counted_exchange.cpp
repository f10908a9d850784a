// Counts on the way to the exchange of MPI. What a rank keeps for itself is no message.
#include "mpi/command/counted_exchange.hpp"

#include <algorithm>

namespace cleft_mpi_cli
{

CountedExchange::CountedExchange(const cleft_cli::Session& session) : session_(session)
{
    inner_.struct_size = sizeof inner_;
    const cleft_status status = cleft_mpi_exchange_open(MPI_COMM_WORLD, &inner_);
    // Not for a signal: what is open is to be closed on all ranks.
    if (status != CLEFT_OK)
        session.check(status, cleft_cli::EXIT_MESHING_FAILED);
}

cleft_exchange CountedExchange::exchange() const
{
    cleft_exchange counted = inner_;
    counted.user = const_cast<CountedExchange*>(this);
    counted.numbers = send_numbers;
    counted.bytes = send_bytes;
    return counted;
}

int CountedExchange::send_numbers(const int64_t* send, int64_t* receive, void* user)
{
    auto& self = *static_cast<CountedExchange*>(user);
    const int64_t others = self.inner_.ranks - 1;
    self.count(others, others * int64_t{sizeof *send});
    return self.inner_.numbers(send, receive, self.inner_.user);
}

int CountedExchange::send_bytes(const void* send, const int64_t* send_sizes, void* receive,
                                const int64_t* receive_sizes, void* user)
{
    auto& self = *static_cast<CountedExchange*>(user);
    int64_t messages = 0, bytes = 0;
    for (int32_t r = 0; r < self.inner_.ranks; ++r) {
        if (r == self.inner_.rank || send_sizes[r] == 0)
            continue;
        ++messages;
        bytes += send_sizes[r];
    }
    self.count(messages, bytes);
    return self.inner_.bytes(send, send_sizes, receive, receive_sizes, self.inner_.user);
}

void CountedExchange::count(int64_t messages, int64_t bytes)
{
    const std::string& work = session_.work();
    auto found = std::find_if(sent_.begin(), sent_.end(), [&](const Sent& sent) { return sent.work == work; });
    if (found == sent_.end())
        found = sent_.insert(sent_.end(), Sent{work, 0, 0});
    found->messages += messages;
    found->bytes += bytes;
}

}  // namespace cleft_mpi_cli
