// One run of the command: the library's context with progress, warnings, interrupts and the clock of the stages.
#pragma once

#include "exit_code.hpp"
#include "handles.hpp"
#include "interrupt.hpp"
#include "progress.hpp"

#include <string>
#include <utility>
#include <vector>

namespace CLI
{
class App;
}

namespace cleft_cli
{

// What every command has.
struct RunArguments {
    int threads = 0;
    bool quiet = false;
    bool verbose = false;
    std::string progress = "auto";
    std::string json;  // path of the machine-readable report; "-": standard output; "": none

    void add_to(CLI::App& app);
    bool prints() const { return !quiet && json != "-"; }
};

struct StageFigures {
    std::string name;
    std::string part_of;  // the stage that it is a part of, which ends later; "": none
    double seconds = 0;
    double cpu_seconds = 0;  // of all threads
    double peak_bytes = 0;   // of the process, up to the end of the stage
};

// Of the process so far, seconds by the clock; the name is left empty.
StageFigures process_figures();

// One object a run. It must stay where it is, as the library and the signal handlers point to it.
class Session
{
public:
    // `parts`: what is timed below, and how much of the time it takes.
    Session(const RunArguments& arguments, std::vector<Part> parts);
    Session(const Session&) = delete;
    Session& operator=(const Session&) = delete;

    cleft_context* context() const { return context_.get(); }
    // Throws if a call of the library failed or a signal arrived. `otherwise` is the exit code of failures that have
    // no code of their own.
    void check(cleft_status status, int otherwise) const;

    // Makes a handle by call(&handle), which answers a status.
    template <class Owner, class Call>
    Owner make(int otherwise, const Call& call) const
    {
        typename Owner::pointer handle = nullptr;
        const cleft_status status = call(&handle);
        Owner owner(handle);
        check(status, otherwise);
        return owner;
    }

    // Runs body(), which is the part `name` of the run and called by `words`, and notes its figures: those of the
    // stages that the library measured in it, then those of the whole under `name`.
    template <class Body>
    void timed(const char* name, const char* words, const Body& body)
    {
        begin_part(name, words);
        const StageFigures before = process_figures();
        const int64_t metrics_before = cleft_context_metric_count(context());
        body();
        note_stages(name, before, metrics_before);
    }

    // For a part that is not timed by itself.
    void begin_part(const char* name, const char* words) { progress_.begin(name, words); }

    const std::vector<StageFigures>& stages() const { return stages_; }
    // All figures of the library, in the order in which they were noted.
    std::vector<std::pair<std::string, double>> metrics() const;
    const std::vector<std::string>& warnings() const { return warnings_; }
    // Prints a sentence, and keeps it for the report.
    void warn(const std::string& sentence);
    // What the library last called its work, in words.
    const std::string& work() const { return work_; }
    // Since the session began, by a clock that is never set.
    double elapsed_seconds() const;
    // To be called before anything is printed.
    void clear_progress() { progress_.clear(); }

private:
    void note_stages(const char* name, const StageFigures& before, int64_t metrics_before);
    static int on_progress(double fraction, const char* stage, void* user);
    static void on_log(int32_t level, const char* sentence, void* user);

    // The order of these members is the order of their making: the context must live longer than
    // the guard.
    double start_ = process_figures().seconds;
    bool quiet_, verbose_;
    Progress progress_;
    Context context_;
    InterruptGuard interrupts_;
    std::vector<std::string> warnings_;
    std::vector<StageFigures> stages_;
    std::string work_;
};

}  // namespace cleft_cli
