// What all fuzz targets ask of the library: results that hold what they claim, failures with a status and a sentence.
#pragma once

#include "cleft/cleft.h"

#include <string>

namespace fuzz
{

// Reports a fault and ends the process, as a fuzzer wants it.
[[noreturn]] void fault(const std::string& sentence);
inline void expect(bool holds, const char* fault_if_not)
{
    if (!holds)
        fault(fault_if_not);
}

// One line of UTF-8 without control characters. A sentence is so, and is not empty.
bool is_line(const std::string& text);

// Options, for as long as it lives.
class Options
{
public:
    Options();
    ~Options();
    Options(const Options&) = delete;
    Options& operator=(const Options&) = delete;
    operator cleft_options*() const { return options_; }  // for the C interface

private:
    cleft_options* options_ = nullptr;
};

// A context, for as long as it lives; looks at each sentence that is logged.
class Context
{
public:
    Context();
    ~Context();
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
    operator cleft_context*() const { return context_; }  // for the C interface

    // True if the call went well; else it must have left one sentence and a status that a user can bring about.
    bool succeeded(cleft_status status) const;

private:
    cleft_context* context_ = nullptr;
};

// Looks at all that a volume or a mesh gives out. They come from a file: a mesh may be of any shape.
void judge_volume(const Context& context, const cleft_volume* volume);
void judge_arrays(const Context& context, const cleft_mesh* mesh);

}  // namespace fuzz
