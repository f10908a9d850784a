// What the ranks of a run of the command have to agree on: whether all could do a step.
#pragma once

#include <mpi.h>

#include <functional>
#include <string>
#include <vector>

namespace cleft_mpi_cli
{

class Ranks
{
public:
    // MPI runs while it lives.
    Ranks(int* argc, char*** argv);
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int rank() const { return rank_; }
    int count() const { return count_; }
    // One of them prints.
    bool is_first() const { return rank_ == 0; }

    // Runs step() on all ranks. If it throws a Failure on some, all throw that of one: of a rank that
    // a signal has reached, else that of the least exit code, and of equal ones that of the first rank.
    void together(const std::function<void()>& step) const;
    // The texts of all ranks, in their order: on the first rank. The others get none.
    std::vector<std::string> gather(const std::string& text) const;
    // Ends all ranks, where one cannot wait for the others.
    [[noreturn]] static void end_all(int exit_code);

private:
    int rank_ = 0, count_ = 1;
};

}  // namespace cleft_mpi_cli
