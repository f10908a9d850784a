// What is done again and again while something fails.
#pragma once

#include "cleft/cleft.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace faults
{

// What works take: made anew for each trial, with nothing failing.
struct Bench {
    cleft_context* context = nullptr;
    cleft_options* options = nullptr;
    cleft_volume* volume = nullptr;
    cleft_sizing* sizing = nullptr;
    cleft_mesh* background = nullptr;
    cleft_mesh* mesh = nullptr;
    uint64_t digest = 0;  // of what the work made

    explicit Bench(int32_t threads);
    ~Bench();
    Bench(const Bench&) = delete;
    Bench& operator=(const Bench&) = delete;
};

struct Work {
    std::string name;
    // Allocates nothing itself, and destroys all that it makes but what is in the bench. The first failure ends it.
    std::function<cleft_status(Bench&)> run;
    std::vector<std::string> outputs = {};  // names in the folder of outputs
    int32_t threads = 1;
    bool ours_alone = false;  // a library below does not bear it that its own allocations fail
    int64_t step = 1;         // with --all: from one call that fails to the next
};

// Of the core; of the file component, with files that lie in `inputs` and such as are written to `outputs`.
std::vector<Work> core_works();
std::vector<Work> file_works(const std::filesystem::path& inputs, const std::filesystem::path& outputs);

}  // namespace faults
