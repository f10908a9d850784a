// storm N [--seed S]: N random volumes through the C interface, seeds S, S + 1, ... Each must end in a mesh that the
// checker finds sound, or in a status that the interface documents. `storm 1 --seed S` runs one again and tells of it.
#include "storm/mesh_checker.hpp"
#include "storm/random_case.hpp"

#include <unistd.h>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>

namespace
{

constexpr unsigned kMostSeconds = 300;  // for one volume that takes a few: what takes longer never ends

char running[64];  // for the signal handler, which may not allocate

void tell_of_the_end(int signal)
{
    const char* const why = signal == SIGALRM ? " did not end\n" : " crashed\n";
    const ssize_t told =
        write(STDOUT_FILENO, running, std::strlen(running)) + write(STDOUT_FILENO, why, std::strlen(why));
    _exit(told > 0 ? 2 : 3);
}

bool is_documented(cleft_status status)
{
    switch (status) {
        case CLEFT_ERROR_ARGUMENT:
        case CLEFT_ERROR_NOT_FINITE:
        case CLEFT_ERROR_TOO_LARGE:
        case CLEFT_ERROR_OPTION:
        case CLEFT_ERROR_LABEL_LOST:
            return true;
        default:
            return false;
    }
}

// What became of a case: a mesh or a documented status ("" in `fault`), or a fault.
struct Outcome {
    cleft_status status = CLEFT_OK;
    int64_t tets = 0;
    std::string sentence;
    std::string fault;
};

class Trial
{
public:
    explicit Trial(const storm::Case& given) : case_(given)
    {
        if (cleft_context_create(&context_) != CLEFT_OK || cleft_options_create(&options_) != CLEFT_OK)
            std::abort();
    }
    ~Trial()
    {
        cleft_mesh_destroy(mesh_);
        cleft_volume_destroy(volume_);
        cleft_options_destroy(options_);
        cleft_context_destroy(context_);
    }
    Trial(const Trial&) = delete;
    Trial& operator=(const Trial&) = delete;

    Outcome run()
    {
        Outcome outcome;
        outcome.status = set_options();
        if (outcome.status == CLEFT_OK)
            outcome.status = make_volume();
        if (outcome.status == CLEFT_OK)
            outcome.status = cleft_mesh_volume(context_, volume_, nullptr, nullptr, options_, &mesh_);
        outcome.sentence = cleft_context_last_error(context_);
        if (outcome.status == CLEFT_OK) {
            outcome.tets = cleft_mesh_tet_count(mesh_);
            outcome.fault = storm::fault_of(mesh_, expectation());
        } else if (!is_documented(outcome.status)) {
            outcome.fault = "status " + std::to_string(outcome.status) + " is not one that is documented for this";
        } else if (outcome.status != CLEFT_ERROR_OPTION && outcome.sentence.empty()) {
            outcome.fault = "there is no sentence about the failure";
        }
        return outcome;
    }

private:
    cleft_status set_options()
    {
        for (const auto& [name, value] : case_.options)
            if (const cleft_status status = cleft_options_set_text(options_, name.c_str(), value.c_str()))
                return status;
        for (const auto& [label, size] : case_.label_sizes)
            if (const cleft_status status = cleft_options_set_label_size(options_, label, size))
                return status;
        return cleft_options_set_strip(options_, case_.strip.data(), static_cast<int64_t>(case_.strip.size()));
    }

    cleft_status make_volume()
    {
        if (case_.functions.empty())
            return cleft_volume_create_labels(context_, case_.type, case_.labels.data(), case_.dims.data(),
                                              case_.affine.data(), options_, &volume_);
        std::vector<const void*> fields;
        for (const auto& function : case_.functions)
            fields.push_back(function.data());
        return cleft_volume_create_indicators(context_, CLEFT_TYPE_FLOAT32, fields.data(),
                                              static_cast<int64_t>(fields.size()), case_.dims.data(),
                                              case_.affine.data(), nullptr, &volume_);
    }

    storm::Expectation expectation() const
    {
        storm::Expectation expected;
        const int32_t* labels = cleft_volume_labels(volume_);
        expected.labels.assign(labels, labels + cleft_volume_label_count(volume_));
        expected.fills_box = case_.strip.empty();
        for (size_t corner = 0; corner < 8; ++corner)
            for (size_t row = 0; row < 3; ++row) {
                double x = case_.affine[4 * row + 3];
                for (size_t axis = 0; axis < 3; ++axis) {
                    const double end = (corner >> axis & 1) ? static_cast<double>(case_.dims[axis]) - 0.5 : -0.5;
                    x += case_.affine[4 * row + axis] * end;
                }
                expected.box[corner][row] = x;
            }
        return expected;
    }

    const storm::Case& case_;
    cleft_context* context_ = nullptr;
    cleft_options* options_ = nullptr;
    cleft_volume* volume_ = nullptr;
    cleft_mesh* mesh_ = nullptr;
};

}  // namespace

int main(int argc, char** argv)
{
    const long count = argc > 1 ? std::strtol(argv[1], nullptr, 10) : 0;
    const unsigned long long first = argc > 3 ? std::strtoull(argv[3], nullptr, 10) : 1;
    if (count < 1 || (argc > 2 && (argc != 4 || std::strcmp(argv[2], "--seed") != 0))) {
        std::fprintf(stderr, "usage: storm N [--seed S]\n");
        return 64;
    }
    for (const int signal : {SIGSEGV, SIGABRT, SIGFPE, SIGBUS, SIGALRM})
        std::signal(signal, tell_of_the_end);
    long faults = 0;
    std::map<cleft_status, long> ends;
    for (long i = 0; i < count; ++i) {
        const unsigned long long seed = first + static_cast<unsigned long long>(i);
        std::snprintf(running, sizeof running, "seed %llu", seed);
        alarm(kMostSeconds);
        const storm::Case drawn = storm::random_case(seed);
        const Outcome outcome = Trial(drawn).run();
        ++ends[outcome.status];
        if (!outcome.fault.empty() || count == 1)
            std::printf("%s: %s\n  status %d, %lld tetrahedra %s\n  %s\n", running, drawn.text.c_str(), outcome.status,
                        static_cast<long long>(outcome.tets), outcome.sentence.c_str(), outcome.fault.c_str());
        faults += !outcome.fault.empty();
        std::fflush(stdout);
    }
    for (const auto& [status, times] : ends)
        std::printf("%6ld x %s\n", times, cleft_status_string(status));
    std::printf("%ld passed, %ld failed\n", count - faults, faults);
    return faults == 0 ? 0 : 1;
}
