// One case of the storm, done through the C interface alone and judged.
#pragma once

#include "storm/random_case.hpp"

#include <string>

namespace storm
{

// What became of a case: a mesh or a documented status, or a fault ("" if there was none).
struct Outcome {
    cleft_status status = CLEFT_OK;
    int64_t tets = 0;
    std::string sentence;
    std::string fault;
};

Outcome run(const Case& drawn);

}  // namespace storm
