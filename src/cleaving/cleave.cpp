#include "cleaving/cleave.hpp"

#include "base/stage_timer.hpp"
#include "cleaving/assemble.hpp"
#include "cleaving/centres.hpp"
#include "cleaving/snap.hpp"

namespace cleft
{

LabelledMesh cleave(const Volume& volume, const TetMesh& background, const CleaveOptions& options, const Run& run)
{
    const StageTimer timer(run, "cleaving");
    Centres centres = find_centres(volume, background, run);
    const SnapCounts snapped = snap_vertices(centres, options.snap, run);
    run.note("cleaving.snapped", static_cast<double>(snapped.moved));
    run.note("cleaving.stayed", static_cast<double>(snapped.stayed));
    run.note("cleaving.given_up", static_cast<double>(give_up_flat_cuts(centres, run)));
    LabelledMesh mesh = assemble(centres, run);
    run.note("cleaving.tets", static_cast<double>(mesh.tets.size()));
    run.report(1.0, "cleaving");
    return mesh;
}

}  // namespace cleft
