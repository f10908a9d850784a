// Cleaves and improves a background; again, on other ways, where the first one ends with a few bad tetrahedra.
#include "pipeline/improved_mesh.hpp"

#include "base/stage_timer.hpp"

namespace cleft
{

namespace
{

// In degrees. A search that aims a little higher takes other ways, few of which end at the same bad tetrahedra.
constexpr double kMargins[] = {1, 2, 0.5, 3};
// More bad ones than these have a cause that another try does not take away.
constexpr int64_t kFew = 100;
// A try costs about as much as the first one: in a larger mesh that is too much for a few tetrahedra.
constexpr int32_t kMostTets = 200000;

struct Try {
    LocalMesh mesh;
    Shortfall left;
};

Try first_try(const Volume& volume, const TetMesh& background, const PipelineOptions& options, const Run& run)
{
    LabelledMesh cleaved;
    {
        const StageTimer timer(run, "cleaving");
        cleaved = cleave(volume, background, options.cleave, part_of(run, 0.0, 0.7));
    }
    LocalMesh mesh(std::move(cleaved), run);
    const Shortfall left = improve(mesh, volume, options.improve, part_of(run, 0.7, 0.9));
    return {std::move(mesh), left};
}

Try another_try(const Volume& volume, const TetMesh& background, const PipelineOptions& options, double margin,
                const Run& run)
{
    ImproveOptions higher = options.improve;
    higher.margin = margin;
    LocalMesh mesh(cleave(volume, background, options.cleave, run), run);
    const Shortfall left = improve(mesh, volume, higher, run);
    return {std::move(mesh), left};
}

}  // namespace

LocalMesh improved_mesh(const Volume& volume, const TetMesh& background, const PipelineOptions& options, const Run& run)
{
    Try best = first_try(volume, background, options, run);
    int tries = 1;
    for (const double margin : kMargins) {
        if (best.left.tets == 0 || best.left.tets > kFew || best.mesh.slot_count() > kMostTets)
            break;
        ++tries;
        Metrics noted;
        Run quiet = part_of(run, 0.9, 0.9);
        quiet.log = nullptr;
        quiet.metrics = &noted;
        Try other = another_try(volume, background, options, margin, quiet);
        if (other.left.least <= best.left.least)
            continue;
        best = std::move(other);
        for (const auto& [name, value] : noted.items)
            run.note(name, value);
    }
    run.note("improving.tries", tries);
    return std::move(best.mesh);
}

}  // namespace cleft
