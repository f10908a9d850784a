// One run of the command: makes the context, shows progress and warnings, turns statuses into
// failures, and measures stages.
#include "session.hpp"

#include "base/process_figures.hpp"
#include "program.hpp"

#include <CLI/CLI.hpp>

#include <chrono>
#include <cstdio>
#include <utility>

namespace cleft_cli
{
namespace
{

Context make_context(int threads)
{
    cleft_context* context = nullptr;
    if (cleft_context_create(&context) != CLEFT_OK)
        throw std::bad_alloc();
    Context owner(context);
    if (cleft_context_set_threads(context, threads) != CLEFT_OK)
        // The library's limits; its own sentence does not know the name of the argument.
        throw usage_failure("--threads: " + std::to_string(threads) + " is not in 0 .. 1024");
    return owner;
}

// These statuses mean the same wherever they come from. For others the caller knows whether it
// read, meshed or wrote.
int exit_code_of(cleft_status status, int otherwise)
{
    switch (status) {
        case CLEFT_ERROR_OUT_OF_MEMORY:
            return EXIT_OUT_OF_MEMORY;
        case CLEFT_ERROR_CANCELLED:
            return EXIT_INTERRUPTED;
        case CLEFT_ERROR_LABEL_LOST:
            return EXIT_LABEL_LOST;
        case CLEFT_ERROR_OPTION:
            return EXIT_USAGE;
        default:
            return otherwise;
    }
}

bool ends_with(const std::string& text, const std::string& end)
{
    return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace

void RunArguments::add_to(CLI::App& app)
{
    app.add_option("--threads", threads,
                   "Threads to use; 0: as many as the machine has. The result does\n"
                   "not depend on it (default 0)")
        ->type_name("N")
        ->group("Run");
    app.add_option("--json", json,
                   "Write a machine-readable report, also of a failure; \"-\": to\n"
                   "standard output, instead of the summary")
        ->type_name("FILE")
        ->group("Run");
    app.add_flag("-q,--quiet", quiet, "Print nothing but errors")->group("Run");
    app.add_option("--progress", progress,
                   "How far the work is, on standard error: a bar, lines, or nothing.\n"
                   "auto: a bar on a terminal, elsewhere lines after ten seconds (default\n"
                   "auto)")
        ->check(CLI::IsMember({"auto", "bar", "lines", "none"}).description(""))
        ->type_name("auto|bar|lines|none")
        ->group("Run");
    app.add_flag("-v,--verbose", verbose, "Print all labels and all remarks of the library")->group("Run");
}

StageFigures process_figures()
{
    StageFigures figures;
    figures.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    figures.cpu_seconds = cleft::process_cpu_seconds();
    figures.peak_bytes = cleft::process_peak_bytes();
    return figures;
}

Session::Session(const RunArguments& arguments, std::vector<Part> parts)
    : quiet_(arguments.quiet),
      verbose_(arguments.verbose),
      progress_(progress_style(arguments.progress, arguments.quiet), std::move(parts)),
      context_(make_context(arguments.threads)),
      interrupts_(context_.get())
{
    // Callbacks get this object as `user`, so it can be neither copied nor moved.
    check(cleft_context_set_progress(context(), on_progress, this), EXIT_MESHING_FAILED);
    check(cleft_context_set_log(context(), on_log, this), EXIT_MESHING_FAILED);
}

void Session::check(cleft_status status, int otherwise) const
{
    // A signal that arrived between two calls of the library was forgotten there.
    if (interrupt_signal() != 0)
        throw stopped_by_signal();
    if (status == CLEFT_OK)
        return;
    std::string sentence = cleft_context_last_error(context());
    if (sentence.empty())
        sentence = cleft_status_string(status);
    throw Failure(exit_code_of(status, otherwise), status, sentence);
}

std::vector<std::pair<std::string, double>> Session::metrics() const
{
    std::vector<std::pair<std::string, double>> all;
    for (int64_t index = 0; index < cleft_context_metric_count(context()); ++index) {
        const char* name = nullptr;
        double value = 0;
        if (cleft_context_metric(context(), index, &name, &value) == CLEFT_OK)
            all.emplace_back(name, value);
    }
    return all;
}

double Session::elapsed_seconds() const { return process_figures().seconds - start_; }

void Session::warn(const std::string& sentence)
{
    // Kept with --quiet, too: the JSON report has all warnings.
    warnings_.push_back(sentence);
    if (!quiet_) {
        progress_.clear();
        std::fprintf(stderr, "%s: warning: %s\n", kProgram, sentence.c_str());
    }
}

void Session::note_stages(const char* name, const StageFigures& before, int64_t metrics_before)
{
    const auto all = metrics();
    const auto value_of = [&](const std::string& metric) {
        for (const auto& [key, value] : all)
            if (key == metric)
                return value;
        return 0.0;
    };
    // The library notes several metrics for each stage; this one comes once a stage, so it stands for
    // all.
    const std::string end = ".cpu_seconds";
    for (std::size_t i = static_cast<std::size_t>(metrics_before); i < all.size(); ++i) {
        const std::string& metric = all[i].first;
        if (!ends_with(metric, end))
            continue;
        const std::string stage = metric.substr(0, metric.size() - end.size());
        // "background.seed" is a step of the stage "background".
        const std::string whole = stage.substr(0, stage.find('.'));
        stages_.push_back({stage, whole == stage ? name : whole, value_of(stage + ".seconds"), all[i].second,
                           value_of(stage + ".peak_bytes")});
    }
    const StageFigures now = process_figures();
    stages_.push_back({name, "", now.seconds - before.seconds, now.cpu_seconds - before.cpu_seconds, now.peak_bytes});
}

int Session::on_progress(double fraction, const char* stage, void* user)
{
    auto& session = *static_cast<Session*>(user);
    if (session.work_ != stage)
        session.work_ = stage;
    session.progress_.show(fraction, stage);
    // A second way to cancel, for a signal that came before the library's call began.
    return interrupt_signal() != 0;
}

void Session::on_log(int32_t level, const char* sentence, void* user)
{
    auto& session = *static_cast<Session*>(user);
    if (level == CLEFT_LOG_WARNING) {
        session.warn(sentence);
    } else if (session.verbose_ && !session.quiet_) {
        session.progress_.clear();
        std::fprintf(stderr, "%s: %s\n", kProgram, sentence);
    }
}

}  // namespace cleft_cli
