// Removes slivers from a background by flips and smoothing, while no material boundary is in the way.
#include "background/repair.hpp"

#include "background/shape_repair.hpp"
#include "base/stage.hpp"
#include "remeshing/angle_notes.hpp"

namespace cleft
{
namespace
{

// Flips first: a sweep over bad connections would only move points to bad places.
void work(LocalMesh& mesh, const RepairOptions& options, const Run& run)
{
    Array<Step> shares(options.sweeps + 2, {nullptr, 4});
    shares[0].share = 2;
    Steps steps(run, shares);
    ShapeRepair repair(mesh);
    repair.improve_bad(std::min(kSweepAngle, options.target_angle), options.passes, false, steps.next());
    for (int sweep = 0; sweep < options.sweeps; ++sweep)
        repair.smooth_poor(steps.next());
    repair.improve_bad(options.target_angle, options.passes, true, steps.next());
}

}  // namespace

void repair(TetMesh& mesh, const RepairOptions& options, const Run& run)
{
    Stage stage(run, "background.repair", {{"background: repairing", 1}});
    const Run of_repair = stage.next();
    LocalMesh local(std::move(mesh.points), std::move(mesh.tets), {}, of_repair);
    local.hold(options.held, false);
    note_angles(local, "background.repair", "before", run);
    work(local, options, of_repair);
    note_angles(local, "background.repair", "after", run);
    LabelledMesh repaired = local.take(of_repair);
    mesh = {std::move(repaired.points), std::move(repaired.tets)};
}

}  // namespace cleft
