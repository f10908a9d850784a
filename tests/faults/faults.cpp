// faults [--all] [WORDS...]: does each work (those whose names have one of the words) while something fails, and looks
// at what is left. Without --all, some of the calls that may fail, over the whole of each work; with it, each, or every
// so many of a work that takes long.
#include "faults/digest.hpp"
#include "faults/interposer.hpp"
#include "faults/works.hpp"

#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <set>

namespace
{

namespace fs = std::filesystem;

constexpr unsigned most_seconds = 120;  // for one trial, which takes a fraction of one
constexpr int64_t some = 24;            // trials of a kind without --all
constexpr int most_told = 20;           // faults of one work

// ------------------------------------------------------------------------------------------- how it ends early --

char running[200];  // for the signal handler, which may not allocate

void tell_of_the_end(int signal)
{
    const char* const why = signal == SIGALRM ? ": did not end\n" : ": crashed\n";
    const ssize_t reported =
        write(STDOUT_FILENO, running, std::strlen(running)) + write(STDOUT_FILENO, why, std::strlen(why));
    _exit(reported > 0 ? 2 : 3);
}

// ----------------------------------------------------------------------------------------------- the trials --

// What is to fail.
struct Fault {
    const char* name;
    int32_t kind;
    int32_t on;
    int32_t error;
    cleft_status status;  // the failure that it may end in
};

constexpr Fault faults_of_memory[] = {
    {"an allocation", FAULTS_ALLOCATIONS, 0, 0, CLEFT_ERROR_OUT_OF_MEMORY},
    {"all allocations on", FAULTS_ALLOCATIONS, 1, 0, CLEFT_ERROR_OUT_OF_MEMORY},
};
constexpr Fault faults_of_files[] = {
    {"a call on a file (ENOSPC)", FAULTS_FILES, 0, ENOSPC, CLEFT_ERROR_FILE},
    {"a call on a file (EIO)", FAULTS_FILES, 0, EIO, CLEFT_ERROR_FILE},
    {"a call on a file (EDQUOT)", FAULTS_FILES, 0, EDQUOT, CLEFT_ERROR_FILE},
};
constexpr Fault no_fault = {"nothing", FAULTS_ALLOCATIONS, 0, 0, CLEFT_OK};
constexpr Fault a_cancel = {"the cancelled progress", FAULTS_ALLOCATIONS, 0, 0, CLEFT_ERROR_CANCELLED};

// Cancels at the call of a number; counts the calls.
struct Cancel {
    int64_t at = 0;
    int64_t calls = 0;
};

int on_progress(double, const char*, void* user)
{
    auto& cancel = *static_cast<Cancel*>(user);
    return ++cancel.calls == cancel.at;
}

class Trials
{
public:
    Trials(const faults::Work& work, fs::path folder, bool all) : work_(work), folder_(std::move(folder)), all_(all) {}

    // The number of faults found.
    int run()
    {
        run_one(no_fault, 0);  // what is made once in a process is made now
        run_one(no_fault, 0);
        wanted_digest_ = digest_;
        wanted_files_ = contents();
        for (const Fault& fault : faults_of_memory)
            sweep(fault);
        if (!work_.outputs.empty())
            for (const Fault& fault : faults_of_files)
                sweep(fault);
        sweep(a_cancel);
        std::printf("%-28s %6lld trials, %6lld failed as they should, %d faults\n", work_.name.c_str(),
                    static_cast<long long>(trials_), static_cast<long long>(failures_), found_);
        return found_;
    }

private:
    void sweep(const Fault& fault)
    {
        Fault counted = fault;
        counted.status = CLEFT_OK;
        run_one(counted, 0);
        const int64_t calls = calls_;
        const int64_t step = all_ ? work_.step : std::max<int64_t>(1, calls / some);
        for (int64_t at = 1; at <= calls; at += step) {
            std::snprintf(running, sizeof running, "%s: %s, number %lld of %lld", work_.name.c_str(), fault.name,
                          static_cast<long long>(at), static_cast<long long>(calls));
            run_one(fault, at);
            ++trials_;
        }
    }

    // Failing, and then again on the same handles with nothing failing.
    void run_one(const Fault& fault, int64_t at)
    {
        alarm(most_seconds);
        plant();
        {
            faults::Bench bench(work_.threads);
            Cancel cancel;
            if (cleft_context_set_progress(bench.context, on_progress, &cancel) != CLEFT_OK)
                report("cannot set the progress");
            const bool cancels = fault.name == a_cancel.name;
            cancel.at = cancels ? at : 0;
            const bool ours = work_.ours_alone && fault.kind == FAULTS_ALLOCATIONS;
            faults_arm(ours ? FAULTS_ALLOCATIONS_OF_OURS : fault.kind, cancels ? 0 : at, fault.on, fault.error);
            const cleft_status status = work_.run(bench);
            const int64_t counted = faults_disarm();
            calls_ = cancels ? cancel.calls : counted;
            check(fault, at, bench, status);
            cancel.at = 0;
            if (at > 0 && status != CLEFT_OK) {
                ++failures_;
                if (work_.run(bench) != CLEFT_OK || bench.digest != wanted_digest_ || contents() != wanted_files_)
                    report("the same again is not what it was");
            }
            digest_ = bench.digest;
        }
        if (at > 0 && faults_live() != 0)
            report(std::to_string(faults_live()) + " blocks are lost, one of " + faults_owner_of_live());
        alarm(0);
    }

    void check(const Fault& fault, int64_t at, const faults::Bench& bench, cleft_status status)
    {
        if (at == 0) {
            if (status != CLEFT_OK)
                report(std::string("fails for nothing: ") + cleft_context_last_error(bench.context));
            return;
        }
        const std::string sentence = cleft_context_last_error(bench.context);
        if (status == CLEFT_OK && (bench.digest != wanted_digest_ || contents() != wanted_files_))
            report("done, but not the same");
        if (status != CLEFT_OK && status != fault.status)
            report("status " + std::to_string(status) + ": " + sentence);
        if (status != CLEFT_OK && contents() != planted())
            report("the old files are not what they were");
        if (fault.kind == FAULTS_FILES && status != CLEFT_OK && sentence.find("cannot write '") == std::string::npos)
            report("no sentence about the file: " + sentence);
    }

    // ------------------------------------------------------------------------------------------------ files --

    using Contents = std::set<std::pair<std::string, std::string>>;

    Contents planted() const
    {
        Contents all;
        for (const std::string& name : work_.outputs)
            all.emplace(name, "old " + name);
        return all;
    }
    void plant() const
    {
        for (const auto& [name, text] : planted())
            std::ofstream(folder_ / name) << text;
    }
    Contents contents() const
    {
        Contents all;
        for (const auto& entry : fs::directory_iterator(folder_)) {
            std::ifstream file(entry.path(), std::ios::binary);
            all.emplace(entry.path().filename().string(), std::string(std::istreambuf_iterator<char>(file), {}));
        }
        return work_.outputs.empty() ? Contents() : all;
    }

    void report(const std::string& what)
    {
        if (++found_ <= most_told)
            std::printf("%s: %s\n", running, what.c_str());
    }

    const faults::Work& work_;
    const fs::path folder_;
    const bool all_;
    Contents wanted_files_;
    uint64_t digest_ = 0, wanted_digest_ = 0;
    int64_t calls_ = 0, trials_ = 0, failures_ = 0;
    int found_ = 0;
};

bool is_wanted(const std::string& name, const std::vector<std::string>& words)
{
    return words.empty() || std::any_of(words.begin(), words.end(),
                                        [&](const std::string& word) { return name.find(word) != std::string::npos; });
}

}  // namespace

int main(int count, char** arguments)
{
    bool all = false;
    std::vector<std::string> words;
    fs::path inputs;
    for (int i = 1; i < count; ++i)
        if (std::strcmp(arguments[i], "--all") == 0)
            all = true;
        else if (std::strcmp(arguments[i], "--files") == 0 && i + 1 < count)
            inputs = arguments[++i];
        else
            words.push_back(arguments[i]);
    for (const int signal : {SIGSEGV, SIGABRT, SIGBUS, SIGFPE, SIGILL, SIGALRM})
        std::signal(signal, tell_of_the_end);

    std::string name = (fs::temp_directory_path() / "cleft-faults-XXXXXX").string();
    const fs::path outputs = mkdtemp(name.data());
    std::vector<faults::Work> works = faults::core_works();
    if (!inputs.empty()) {
        std::vector<faults::Work> more = faults::file_works(inputs, outputs);
        works.insert(works.end(), more.begin(), more.end());
    }
    int found = 0;
    for (const faults::Work& work : works)
        if (is_wanted(work.name, words)) {
            found += Trials(work, outputs, all).run();
            std::fflush(stdout);
            for (const std::string& output : work.outputs)
                fs::remove(outputs / output);
        }
    fs::remove_all(outputs);
    std::printf("%d faults\n", found);
    return found > 0;
}
