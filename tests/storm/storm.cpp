// storm N [--seed S]: N random volumes through the C interface, seeds S, S + 1, ... Each must end in a mesh that the
// checker finds sound, or in a status that the interface documents. `storm 1 --seed S` runs one again and describes it.
// storm --seeds S...: these seeds, each of which once failed.
// storm --parts ...: the same with volumes that several ranks mesh block by block, and that one call meshes too.
#include "storm/trial.hpp"

#include <sys/time.h>
#include <unistd.h>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <vector>

namespace
{

// Of the processor, for one volume that takes a few at most: what takes longer does not end.
constexpr int kMostSeconds = STORM_SECONDS;
// Of a busy machine: the seconds that pass for one of the processor.
constexpr int kWaitingShare = 4;

char running[64];  // for the signal handler, which may not allocate

void tell_of_the_end(int signal)
{
    const char* const why = signal == SIGPROF || signal == SIGALRM ? " did not end\n" : " crashed\n";
    const ssize_t reported =
        write(STDOUT_FILENO, running, std::strlen(running)) + write(STDOUT_FILENO, why, std::strlen(why));
    _exit(reported > 0 ? 2 : 3);
}

void watch_from_now()
{
    const itimerval most = {{0, 0}, {kMostSeconds, 0}};
    setitimer(ITIMER_PROF, &most, nullptr);
    // Ranks that wait for each other take no time of the processor.
    alarm(kWaitingShare * kMostSeconds);
}

std::vector<unsigned long long> seeds_of(int argc, char** argv)
{
    std::vector<unsigned long long> seeds;
    if (argc > 2 && !std::strcmp(argv[1], "--seeds")) {
        for (int i = 2; i < argc; ++i)
            seeds.push_back(std::strtoull(argv[i], nullptr, 10));
        return seeds;
    }
    const long count = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 0;
    const bool has_seed = argc == 4 && !std::strcmp(argv[2], "--seed");
    const unsigned long long first = has_seed ? std::strtoull(argv[3], nullptr, 10) : 1;
    if (argc == 2 || has_seed)
        for (long i = 0; i < count; ++i)
            seeds.push_back(first + static_cast<unsigned long long>(i));
    return seeds;
}

}  // namespace

int main(int argc, char** argv)
{
    const bool in_parts = argc > 1 && !std::strcmp(argv[1], "--parts");
    argc -= in_parts;
    argv += in_parts;
    const std::vector<unsigned long long> seeds = seeds_of(argc, argv);
    if (seeds.empty()) {
        std::fprintf(stderr, "usage: storm [--parts] N [--seed S], or storm [--parts] --seeds S...\n");
        return 64;
    }
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGPROF, SIGALRM})
        std::signal(signal, tell_of_the_end);
    size_t faults = 0;
    std::map<cleft_status, long> ends;
    for (const unsigned long long seed : seeds) {
        std::snprintf(running, sizeof running, "seed %llu", seed);
        watch_from_now();
        const storm::Case drawn = in_parts ? storm::random_parts_case(seed) : storm::random_case(seed);
        if (seeds.size() == 1)
            std::printf("%s: %s\n", running, drawn.text.c_str());
        std::fflush(stdout);
        const storm::Outcome outcome = storm::run(drawn);
        ++ends[outcome.status];
        if (!outcome.fault.empty() || seeds.size() == 1)
            std::printf("%s: %s\n  status %d, %lld tetrahedra %s\n  %s\n", running, drawn.text.c_str(), outcome.status,
                        static_cast<long long>(outcome.tets), outcome.sentence.c_str(), outcome.fault.c_str());
        faults += !outcome.fault.empty();
        std::fflush(stdout);
    }
    for (const auto& [status, times] : ends)
        std::printf("%6ld x %s\n", times, cleft_status_string(status));
    std::printf("%zu passed, %zu failed\n", seeds.size() - faults, faults);
    return faults == 0 ? 0 : 1;
}
