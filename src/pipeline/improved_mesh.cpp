// Improves a cleaved mesh; again, on other ways, where the first one ends with a few bad tetrahedra.
#include "pipeline/improved_mesh.hpp"

namespace cleft
{

namespace
{

// More bad ones than these have a cause that another try does not take away.
constexpr int64_t kFew = 100;
// A try costs about as much as the first one: in a larger mesh that is too much for a few tetrahedra.
constexpr int32_t kMostTets = 200000;

struct Try {
    LocalMesh mesh;
    Shortfall left;
};

Try try_with(const Volume& volume, const Cleaved& cleaved, const ImproveOptions& options, const Run& run)
{
    LocalMesh mesh(cleaved(part_of(run, 0.0, 0.75)), run);
    const Shortfall left = improve(mesh, volume, options, part_of(run, 0.75, 1.0));
    return {std::move(mesh), left};
}

}  // namespace

LocalMesh improved_mesh(const Volume& volume, const Cleaved& cleaved, const PipelineOptions& options, const Run& run)
{
    Try best = try_with(volume, cleaved, options.improve, run);
    int tries = 1;
    for (const double margin : kHigherAims) {
        if (best.left.tets == 0 || best.left.tets > kFew || best.mesh.slot_count() > kMostTets)
            break;
        ++tries;
        ImproveOptions higher = options.improve;
        higher.margin = margin;
        Metrics noted;
        Run quiet = part_of(run, 1.0, 1.0);
        quiet.log = nullptr;
        quiet.metrics = &noted;
        Try other = try_with(volume, cleaved, higher, quiet);
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
