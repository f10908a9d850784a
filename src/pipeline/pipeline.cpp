#include "pipeline/pipeline.hpp"

#include "background/lattice.hpp"
#include "background/octree.hpp"
#include "background/repair.hpp"
#include "base/stage_timer.hpp"
#include "improving/fit_volumes.hpp"
#include "mesh/finish.hpp"
#include "pipeline/label_report.hpp"

#include <algorithm>
#include <cmath>
#include <string>

namespace cleft
{

namespace
{

// Refuses to give back a mesh without one of the volume's labels, or with a large piece of one lost or broken.
void require_all_labels(const Volume& volume, const LabelledMesh& mesh, const Run& run)
{
    for (const LabelRow& row : label_report(volume, mesh, run)) {
        const std::string name = "label " + std::to_string(row.label);
        if (row.voxels > 0 && row.tets == 0)
            throw Error(CLEFT_ERROR_LABEL_LOST, name + " (" + std::to_string(row.voxels) +
                                                    " voxels) has no tetrahedron; a smaller size would keep it");
        if (row.large_components_lost > 0)
            throw Error(CLEFT_ERROR_LABEL_LOST, name + " has a piece of more than " + std::to_string(kLargeComponent) +
                                                    " voxels without a tetrahedron; a smaller size would keep it");
        if (row.large_components_broken > 0)
            throw Error(CLEFT_ERROR_LABEL_LOST, name + " has a piece of more than " + std::to_string(kLargeComponent) +
                                                    " voxels that broke; a smaller size would keep it whole");
    }
}

// Scaled for a wanted number of tetrahedra, the one size of a lattice can come out coarser than the thinnest parts ask
// for, which is half of their thickness. A field that is constant asks for nothing of the kind.
void warn_of_coarse_lattice(const SizingField& field, const Run& run)
{
    constexpr double kCoarse = 1.1;
    if (field.scale > kCoarse && field.least() < field.greatest())
        run.say(CLEFT_LOG_WARNING, "the lattice has one size, " + std::to_string(field.least()) +
                                       ", which may lose the thinnest parts: a size of " +
                                       std::to_string(field.least() / field.scale) +
                                       " resolves them, or a graded background with fewer tetrahedra");
}

// The least that the field asks for. Where only features ask for it, not the user, a lattice that would have more than
// max_tets is made coarser: one thin part would make it fill the memory.
double lattice_size(const SizingField& field, const PipelineOptions& options, const Run& run)
{
    const double least = field.least(), most = options.sizing.max_tets;
    const bool is_asked_for = options.sizing.size > 0 || options.sizing.size_min > 0 || least == field.greatest();
    if (most <= 0 || is_asked_for)
        return least;
    const double size = lattice_size_for(field.grid, most);
    if (size <= least)
        return least;
    const double asked = most * std::pow(size / least, 3);
    run.say(CLEFT_LOG_WARNING, "a lattice of the least size, " + std::to_string(least) + ", has about " +
                                   std::to_string(std::llround(asked)) + " tetrahedra: its size was raised to " +
                                   std::to_string(size) + " to keep to max_tets, " +
                                   std::to_string(std::llround(most)));
    return size;
}

// Where the search for a number begins: a lattice as fine as the field asks for could fill the memory.
double first_factor(const SizingField& field, const PipelineOptions& options)
{
    constexpr double kCleavedOverBackground = 1.2;
    if (options.background != BackgroundKind::lattice)
        return 1;
    const double wanted = static_cast<double>(options.tets) / kCleavedOverBackground;
    return std::max(1.0, lattice_size_for(field.grid, wanted) / field.least());
}

LabelledMesh finished(const Volume& volume, LabelledMesh mesh, const PipelineOptions& options, const Run& run)
{
    if (options.strict)
        require_all_labels(volume, mesh, run);
    const StageTimer timer(run, "finish");
    order_spatially(mesh, run);
    return mesh;
}

// One run at one size, without the finishing.
LabelledMesh attempt(const Volume& volume, const SizingField& field, const PipelineOptions& options, const Run& run)
{
    const TetMesh background = make_background(field, options, part_of(run, 0.0, 0.5));
    return cleave_and_improve(volume, background, options, part_of(run, 0.5, 1.0));
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
        const Try tried{std::log(factor), std::log(count)};
        const bool many = tried.count > wanted_;
        (many ? many_ : few_) = tried;
        (many ? has_many_ : has_few_) = true;
        if (!has_many_ || !has_few_)
            return std::exp(tried.factor + (tried.count - wanted_) / kExponent);
        const double share = (many_.count - wanted_) / (many_.count - few_.count);
        return std::exp(many_.factor + std::clamp(share, 0.1, 0.9) * (few_.factor - many_.factor));
    }

private:
    static constexpr double kExponent = 2.6;
    struct Try {
        double factor, count;
    };
    double wanted_;
    bool has_many_ = false, has_few_ = false;
    Try many_{}, few_{};  // the last that gave too many, and too few
};

LabelledMesh attempt_number(const Volume& volume, SizingField& field, const PipelineOptions& options, const Run& run)
{
    constexpr int kRounds = 8;
    constexpr double kTolerance = 0.08;
    const StageTimer timer(run, "pipeline.rounds");  // of all; the stages note their last round
    const double wanted = static_cast<double>(options.tets);
    NumberSearch search(wanted);
    Run silent = run;  // warnings are of the mesh that is kept
    silent.log = nullptr;
    double factor = 1, next = first_factor(field, options);
    LabelledMesh mesh;
    for (int round = 0; round < kRounds; ++round) {
        if (next != factor)
            scale_sizing(field, next / factor, run);
        factor = next;
        mesh = LabelledMesh();
        // Most searches end in the second or third round: progress goes by halves of what is left.
        mesh = attempt(volume, field, options,
                       part_of(silent, 1 - std::ldexp(1.0, -round), 1 - std::ldexp(1.0, -round - 1)));
        const double count = static_cast<double>(mesh.tets.size());
        run.note("pipeline.rounds.count", round + 1);
        if (std::abs(count - wanted) <= kTolerance * wanted)
            return mesh;
        next = search.next(factor, count);
    }
    if (std::abs(static_cast<double>(mesh.tets.size()) - wanted) > 0.1 * wanted)
        run.say(CLEFT_LOG_WARNING, "the wanted number of tetrahedra, " + std::to_string(options.tets) +
                                       ", was not met: " + std::to_string(mesh.tets.size()));
    return mesh;
}

}  // namespace

Run part_of(const Run& run, double from, double to)
{
    Run part = run;
    if (run.progress)
        part.progress = [progress = run.progress, from, to](double fraction, const char* stage) {
            return progress(from + (to - from) * fraction, stage);
        };
    return part;
}

void fit_to_number(SizingField& field, int64_t tets, const Run& run)
{
    // A finished mesh has from 1.1 times the tetrahedra of its background (few interfaces) to 2.2 times (many).
    constexpr double kCleavedOverBackground = 1.3;
    constexpr int kRounds = 4;  // the gradation limit bends the power law
    for (int round = 0; tets > 0 && round < kRounds; ++round) {
        const double ratio = kCleavedOverBackground * expected_background_tets(field) / static_cast<double>(tets);
        if (std::abs(ratio - 1) < 0.05)
            return;
        scale_sizing(field, std::cbrt(ratio), run);
    }
}

TetMesh make_background(const SizingField& field, const PipelineOptions& options, const Run& run)
{
    const StageTimer timer(run, "background");
    TetMesh mesh;
    switch (options.background) {
        case BackgroundKind::particles:
            mesh = particle_background(field, options.particles, run);
            break;
        case BackgroundKind::lattice:
            warn_of_coarse_lattice(field, run);
            mesh = lattice_background(field.grid, lattice_size(field, options, run), run);
            break;
        case BackgroundKind::octree:
            mesh = octree_background(field, run);
            break;
    }
    run.note("background.points", static_cast<double>(mesh.points.size()));
    run.note("background.tets", static_cast<double>(mesh.tets.size()));
    return mesh;
}

void repair_background(TetMesh& background, const PipelineOptions& options, const Run& run)
{
    if (options.repair_angle <= 0)
        return;
    const StageTimer timer(run, "background");
    RepairOptions repair_options;
    repair_options.target_angle = options.repair_angle;
    repair_options.sweeps = 0;  // a user's points stay where they are unless a bad tetrahedron needs them moved
    repair(background, repair_options, run);
}

LabelledMesh cleave_and_improve(const Volume& volume, const TetMesh& background, const PipelineOptions& options,
                                const Run& run)
{
    LabelledMesh mesh;
    {
        const StageTimer timer(run, "cleaving");
        mesh = cleave(volume, background, options.cleave, part_of(run, 0.0, 0.7));
    }
    if (options.improve.effort != Effort::off) {
        const StageTimer timer(run, "improving");
        LocalMesh local(std::move(mesh), run);
        improve(local, volume, options.improve, part_of(run, 0.7, 0.9));
        fit_volumes(local, volume, options.improve.target_angle, part_of(run, 0.9, 1.0));
        mesh = local.take();
    }
    return mesh;
}

LabelledMesh mesh_from_sizing(const Volume& volume, SizingField field, const PipelineOptions& options, const Run& run)
{
    if (options.tets > 0) {
        LabelledMesh mesh = attempt_number(volume, field, options, run);
        if (options.background == BackgroundKind::lattice)
            warn_of_coarse_lattice(field, run);
        field = SizingField();
        return finished(volume, std::move(mesh), options, run);
    }
    TetMesh background = make_background(field, options, part_of(run, 0.0, 0.5));
    field = SizingField();
    LabelledMesh mesh = cleave_and_improve(volume, background, options, part_of(run, 0.5, 1.0));
    background = TetMesh();
    return finished(volume, std::move(mesh), options, run);
}

LabelledMesh mesh_from_background(const Volume& volume, TetMesh background, const PipelineOptions& options,
                                  const Run& run)
{
    repair_background(background, options, part_of(run, 0.0, 0.2));
    LabelledMesh mesh = cleave_and_improve(volume, background, options, part_of(run, 0.2, 1.0));
    background = TetMesh();
    return finished(volume, std::move(mesh), options, run);
}

}  // namespace cleft
