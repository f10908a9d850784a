// Failures travel as an exit code, a status and a sentence.
#include "mpi/command/ranks.hpp"

#include "cli/exit_code.hpp"
#include "cli/interrupt.hpp"

#include <algorithm>
#include <climits>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>
#include <numeric>
#include <optional>

namespace cleft_mpi_cli
{
namespace
{

using cleft_cli::Failure;

struct Told {
    int exit_code;
    int status;
    bool is_reported;
    char sentence[2000];
};

// Not a Failure, so that it can be made without memory.
Told told(int exit_code, cleft_status status, const char* sentence)
{
    Told out{exit_code, status, true, ""};
    std::strncpy(out.sentence, sentence, sizeof out.sentence - 1);
    return out;
}

Told result_of(const std::function<void()>& step)
{
    try {
        step();
        return told(cleft_cli::EXIT_OK, CLEFT_OK, "");
    } catch (const Failure& failure) {
        Told out = told(failure.exit_code, failure.status, failure.what());
        out.is_reported = failure.is_reported;
        return out;
    } catch (const std::bad_alloc&) {
        return told(cleft_cli::EXIT_OUT_OF_MEMORY, CLEFT_ERROR_OUT_OF_MEMORY, "out of memory");
    } catch (const std::exception& other) {
        return told(cleft_cli::EXIT_MESHING_FAILED, CLEFT_ERROR_INTERNAL, other.what());
    }
}

// Of the failures of several ranks, the least is told. Codes of inputs are less than those of outputs, of which a rank
// that only hears of a failure may speak; and a rank that a signal has reached knows its number.
int order_of(const Told& result)
{
    constexpr int kNone = INT_MAX, kHeardOfCancel = INT_MAX - 1;
    if (result.exit_code == cleft_cli::EXIT_OK)
        return kNone;
    const bool hears = result.status == CLEFT_ERROR_CANCELLED && cleft_cli::interrupt_signal() == 0;
    return hears ? kHeardOfCancel : result.exit_code;
}

}  // namespace

Ranks::Ranks(int* argc, char*** argv)
{
    // A rank that ends before all have begun can leave mpirun waiting for the others: signals come afterwards.
    const cleft_cli::SignalsLater later;
    int provided = 0;
    // The library has threads, and only the first one of a rank sends messages.
    MPI_Init_thread(argc, argv, MPI_THREAD_FUNNELED, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    if (provided < MPI_THREAD_FUNNELED) {
        std::fputs("cleft-mpi: this MPI does not work beside threads\n", stderr);
        end_all(cleft_cli::EXIT_MESHING_FAILED);
    }
}

Ranks::~Ranks() { MPI_Finalize(); }

void Ranks::together(const std::function<void()>& step) const
{
    Told result = result_of(step);
    struct {
        int order, rank;
    } first{order_of(result), rank_};
    int failed = result.exit_code != cleft_cli::EXIT_OK ? 1 : 0, all_failed = 0;
    MPI_Allreduce(MPI_IN_PLACE, &first, 1, MPI_2INT, MPI_MINLOC, MPI_COMM_WORLD);
    MPI_Allreduce(&failed, &all_failed, 1, MPI_INT, MPI_SUM, MPI_COMM_WORLD);
    if (all_failed == 0)
        return;
    MPI_Bcast(&result, sizeof result, MPI_BYTE, first.rank, MPI_COMM_WORLD);
    // What all say, as of a file that is not there, or after the library has told all, needs no name. Mistakes of usage
    // are looked for by the first rank alone, and a signal is meant for all.
    const bool is_of_usage = first.rank == 0 && result.exit_code == cleft_cli::EXIT_USAGE;
    const bool is_of_one = all_failed < count_ && !is_of_usage && result.status != CLEFT_ERROR_CANCELLED;
    const std::string who = is_of_one ? "rank " + std::to_string(first.rank) + ": " : "";
    Failure failure(result.exit_code, result.status, who + result.sentence);
    failure.is_reported = result.is_reported;
    throw failure;
}

std::vector<std::string> Ranks::gather(const std::string& text) const
{
    const int size = static_cast<int>(text.size());
    std::vector<int> sizes(static_cast<std::size_t>(count_)), starts(sizes.size());
    MPI_Gather(&size, 1, MPI_INT, sizes.data(), 1, MPI_INT, 0, MPI_COMM_WORLD);
    std::exclusive_scan(sizes.begin(), sizes.end(), starts.begin(), 0);
    std::string all(is_first() ? static_cast<std::size_t>(starts.back() + sizes.back()) : 0, '\0');
    MPI_Gatherv(text.data(), size, MPI_CHAR, all.data(), sizes.data(), starts.data(), MPI_CHAR, 0, MPI_COMM_WORLD);
    std::vector<std::string> texts;
    for (std::size_t r = 0; is_first() && r < sizes.size(); ++r)
        texts.push_back(all.substr(static_cast<std::size_t>(starts[r]), static_cast<std::size_t>(sizes[r])));
    return texts;
}

void Ranks::end_all(int exit_code)
{
    MPI_Abort(MPI_COMM_WORLD, exit_code);
    std::abort();
}

}  // namespace cleft_mpi_cli
