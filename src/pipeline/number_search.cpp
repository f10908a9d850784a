// The search for the scale of the sizing field at which the mesh has the wanted number of tetrahedra. Estimates give a
// first scale, then meshes are counted.
#include "pipeline/number_search.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/stage.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace cleft
{

namespace
{

// The number of tetrahedra that no round may pass; 0: none. Without it, those of a label of a few voxels would have the
// others fill the memory.
double limit_of(const PipelineOptions& options)
{
    if (options.kept.all() || options.max_tets <= 0)
        return 0;
    return std::max(options.max_tets, static_cast<double>(options.tets));
}

int64_t kept_count(const LabelledMesh& mesh, const PipelineOptions& options)
{
    return std::count_if(mesh.material.begin(), mesh.material.end(), [&](Material m) { return options.kept.has(m); });
}

void scale(ScaledSizing& sizing, double factor, const Run& run)
{
    if (factor == 1)
        return;
    scale_sizing(sizing.field, factor, run);
    sizing.scale *= factor;
}

// One run at one size, without the finishing.
LabelledMesh attempt(const Volume& volume, const ScaledSizing& sizing, const PipelineOptions& options, const Run& run)
{
    const double share = row_of(options.background.kind).share_of_time;
    Steps steps(run, {{nullptr, share}, {nullptr, 100 - share}});
    const TetMesh background = make_background(sizing, options, steps.next());
    return cleave_improve_and_fit(volume, background, measured_by(sizing.field.metric.get(), options), steps.next());
}

// Finds the factor on the sizing field that gives the wanted number. The number falls with the factor by a power
// between two (all tetrahedra at interfaces) and three; where a lattice has to fit the box it also jumps. So the search
// is that of a bracket, interpolated in logarithms.
class NumberSearch
{
public:
    explicit NumberSearch(double wanted) : wanted_(std::log(wanted)) {}

    // The next factor, after one has given a number of tetrahedra. Both stay logarithms inside.
    double next(double factor, double count)
    {
        const Try tried{std::log(factor), std::log(std::max(count, 0.5))};
        const bool many = tried.count > wanted_;
        (many ? many_ : few_) = tried;
        (many ? has_many_ : has_few_) = true;
        if (!has_many_ || !has_few_)
            return std::exp(tried.factor + (tried.count - wanted_) / kExponent);
        // The share is kept away from the ends, so that the bracket shrinks by a tenth at least even where the number
        // jumps.
        const double share = (many_.count - wanted_) / (many_.count - few_.count);
        return std::exp(many_.factor + std::clamp(share, 0.1, 0.9) * (few_.factor - many_.factor));
    }

private:
    // Between the two and three of above. It serves the first steps only: as soon as there is a bracket, the counts
    // decide.
    static constexpr double kExponent = 2.6;
    struct Try {
        double factor, count;
    };
    double wanted_;
    bool has_many_ = false, has_few_ = false;
    Try many_{}, few_{};  // the last that gave too many, and too few
};

// A bound for searches in which the number jumps past what is wanted. The warning reports what was reached.
constexpr int kRounds = 8;

// Fitting, then the rounds, each of which scales and meshes. Most searches end with the first mesh, so it has three
// quarters of the progress, and each later one of what is left.
Array<Step> steps_of_rounds()
{
    Array<Step> steps{{nullptr, 0}};
    for (int round = 0; round < kRounds; ++round) {
        steps.push_back({nullptr, 0});
        steps.push_back({nullptr, std::ldexp(1.0, -2 * round)});
    }
    return steps;
}

// Warnings are of the mesh that is kept.
Run silenced(Run run)
{
    run.on_warning = nullptr;
    return run;
}

// The least factor that keeps a mesh to the limit, where `all` tetrahedra came (or are expected) of `factor`.
double least_factor(double factor, double all, double limit) { return limit > 0 ? factor * std::cbrt(all / limit) : 0; }

// max_tets bounds the size of a lattice where no number is wanted.
PipelineOptions without_limit(PipelineOptions options)
{
    options.background.lattice.max_tets = 0;
    return options;
}

// Whether sizes so many times as large left the number as it was: cells are no longer than the box is thin, whatever
// size they are to have, so that a plate has a least number. Else the number falls by at least the factor squared, but
// for the steps of an octree.
bool is_least(double factor, double before, double now)
{
    constexpr double kBeyondSteps = 2, kSame = 0.99;
    return factor >= kBeyondSteps && now >= kSame * before;
}

// A least number that is far from what is wanted, and takes long to mesh, is no answer.
void refuse_flat_box(double least, const PipelineOptions& options)
{
    constexpr double kFar = 10, kLittleWork = 100'000;
    if (least > std::max(kLittleWork, kFar * static_cast<double>(options.tets)))
        throw Error(CLEFT_ERROR_TOO_LARGE, "the box is so thin that the background has about " + count_text(least) +
                                               " tetrahedra, whatever their size, far more than the wanted number, " +
                                               std::to_string(options.tets) +
                                               ": set a greater number by tets or another background");
}

// The promise is 10 %. Less than kTolerance would take more rounds, each of which makes a mesh. Where the first ones do
// not come as near, the number jumps, and the promise has to do.
bool is_met(int round, double count, double wanted)
{
    constexpr double kTolerance = 0.08, kPromise = 0.1;
    constexpr int kNearRounds = 2;
    return std::abs(count - wanted) <= (round < kNearRounds ? kTolerance : kPromise) * wanted;
}

void warn_of_number(int64_t kept, const PipelineOptions& options, bool is_limited, const Run& run)
{
    constexpr double kMet = 0.1;  // as the text of the option says
    const double wanted = static_cast<double>(options.tets);
    if (std::abs(static_cast<double>(kept) - wanted) <= kMet * wanted)
        return;
    std::string sentence =
        "the wanted number of tetrahedra, " + std::to_string(options.tets) + ", was not met: " + std::to_string(kept);
    if (is_limited)
        sentence += ", since the whole mesh, from which labels are left out, keeps to max_tets, " +
                    count_text(options.max_tets);
    run.warn(sentence);
}

}  // namespace

void scale_by_estimate(ScaledSizing& sizing, const Volume& volume, const PipelineOptions& options, const Run& run)
{
    constexpr int kFittingRounds = 6;  // the gradation limit bends the power law
    constexpr double kFitted = 0.01;   // of the factor: 3 % of the number
    constexpr double kMostOff = 1.1;   // what comes out is hardly ever more than so many times what is expected
    if (options.tets <= 0 || sizing.found_for == options.tets)
        return;
    const PipelineOptions unlimited = without_limit(options);
    const double wanted = static_cast<double>(options.tets), limit = limit_of(options);
    double factor = 1, before = 0;
    // No mesh is made here, so that these rounds cost little beside the first one that makes one.
    for (int round = 0; round < kFittingRounds; ++round) {
        const ExpectedMesh expected = expected_mesh(volume, sizing.field, unlimited, run);
        if (is_least(factor, std::exchange(before, expected.background_tets), expected.background_tets))
            return refuse_flat_box(expected.background_tets, options);
        const double for_number = expected.kept_tets > 0 ? std::cbrt(expected.kept_tets / wanted) : 1;
        factor = std::max(for_number, least_factor(1, kMostOff * expected.whole_tets, limit));
        if (std::abs(factor - 1) < kFitted)
            return;
        scale(sizing, factor, run);
    }
}

double factor_of_search(const ExpectedMesh& expected, const PipelineOptions& options)
{
    if (options.tets <= 0 || expected.kept_tets <= 0)
        return 1;
    const double for_number = static_cast<double>(options.tets) / expected.kept_tets, limit = limit_of(options);
    return limit > 0 ? std::min(for_number, limit / expected.whole_tets) : for_number;
}

LabelledMesh mesh_of_number(const Volume& volume, ScaledSizing& sizing, const PipelineOptions& options, const Run& run)
{
    // Nearer to the limit than this, a search that wants more has ended. A lattice may jump over it: then it goes on.
    constexpr double kNearLimit = 0.9, kOverLimit = 1.05;
    const StageTimer timer(run, "pipeline.rounds");  // of all; the stages note their last round
    const double wanted = static_cast<double>(options.tets), limit = limit_of(options);
    NumberSearch search(wanted);
    Steps steps(run, steps_of_rounds());
    const bool was_found = sizing.found_for == options.tets;
    double factor = 1, next = 1;
    scale_by_estimate(sizing, volume, options, steps.next());
    bool is_limited = false;
    LabelledMesh mesh;
    int64_t kept = 0;
    double all = 0;
    for (int round = 0; round < kRounds && !is_limited; ++round) {
        // From the factor before, since the field is scaled in place and a copy of it could be the largest array of
        // all.
        const double coarser = next / std::exchange(factor, next);
        scale(sizing, coarser, steps.next());
        // Frees the mesh of the round before: two would double the peak of memory.
        mesh = LabelledMesh();
        mesh = attempt(volume, sizing, options, silenced(steps.next()));
        const double before = std::exchange(all, static_cast<double>(mesh.tets.size()));
        kept = kept_count(mesh, options);
        const double count = static_cast<double>(kept);
        run.note("pipeline.rounds.count", round + 1);
        // cleft_sizing_create() has searched already. Meshing its field must not search on, so that single calls give
        // the bytes of the one call.
        const bool is_where_a_search_ended = round == 0 && was_found && kept == sizing.found;
        if (is_where_a_search_ended || is_met(round, count, wanted) || is_least(coarser, before, all))
            break;
        next = std::max(search.next(factor, count), least_factor(factor, all, limit));
        is_limited = limit > 0 && all >= kNearLimit * limit && all <= kOverLimit * limit && count < wanted;
    }
    sizing.found_for = options.tets;
    sizing.found = kept;
    warn_of_number(kept, options, is_limited, run);
    return mesh;
}

}  // namespace cleft
