// Runs the searches of improving one after the other, from exact and cheap to tolerant and expensive.
#include "improving/improve.hpp"

#include "base/degrees.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "improving/improver.hpp"
#include "remeshing/angle_notes.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace cleft
{

namespace
{

// Tetrahedra that a thread looks at. The number changes the time alone.
constexpr int64_t kTetsCounted = 1 << 14;

// Most tetrahedra are helped at no price. For the few that are left, an interface may give way by a little, more and
// more, and then expensive attempts are made, at last with the tetrahedra around as well.
// The members of each line are those of Search. A tolerance doubles from search to search, so that no point leaves its
// tie by much more than it must.
Array<Search> searches_of(Effort effort)
{
    Array<Search> searches{{6, 0.0, 0.05, false, false},
                           {3, 0.05, 0.1, true, false},
                           {3, 0.1, 0.15, true, true},
                           {3, 0.2, 0.15, true, true},
                           {6, 0.4, 0.25, true, true, true}};
    if (effort == Effort::best)
        for (Search& search : searches)
            search.passes *= 2;
    return searches;
}

void note_counts(const SearchCounts& counts, const Run& run)
{
    run.note("improving.tried", static_cast<double>(counts.tried));
    run.note("improving.places", static_cast<double>(counts.places));
    run.note("improving.points_moved", static_cast<double>(counts.moved));
    run.note("improving.edges_removed", static_cast<double>(counts.edges_removed));
    run.note("improving.faces_removed", static_cast<double>(counts.faces_removed));
    run.note("improving.edges_contracted", static_cast<double>(counts.contracted));
    run.note("improving.edges_split", static_cast<double>(counts.split));
    run.note("improving.compound", static_cast<double>(counts.compound));
}

Shortfall shortfall(const LocalMesh& mesh, double target, const Run& run)
{
    Array<Shortfall> parts(chunk_count(mesh.slot_count(), kTetsCounted));
    parallel_chunks(run, mesh.slot_count(), kTetsCounted, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (auto t = static_cast<int32_t>(begin); t < end; ++t) {
            if (!mesh.alive(t) || mesh.quality(t) >= target || mesh.waits(t))
                continue;
            ++parts[chunk].tets;
            parts[chunk].least = std::min(parts[chunk].least, mesh.quality(t));
        }
    });
    Shortfall found;
    for (const Shortfall& part : parts) {
        found.tets += part.tets;
        found.least = std::min(found.least, part.least);
    }
    return found;
}

// The searches, and as many again in each round that searches on. The first one takes nearly all of the time: the
// others work on the few that are left.
Array<Step> steps_of(size_t searches)
{
    Array<Step> steps(searches * (1 + std::size(kHigherAims)), {"improving", 0});
    for (size_t i = 0; i < searches; ++i)
        steps[i].share = i == 0 ? 20 : 1;
    return steps;
}

// Where a few are left, the searches go on around them with a higher aim: few of those end at the same tetrahedra. With
// a margin, they have had a higher aim from the beginning.
Shortfall search_on(LocalMesh& mesh, Improver& improver, const ImproveOptions& options, Stage& stage, const Run& run)
{
    // More than these are left where the target is out of reach. Going on there would take long and change little. The
    // first number is for small meshes, the second for large ones of noise, which met 30 degrees after 288 were left.
    constexpr int64_t kFew = 40, kFewOneIn = 1000;
    const int64_t few = kFew + mesh.slot_count() / kFewOneIn;
    const double target = sine_of(target_angle(options));
    Shortfall left = shortfall(mesh, target, run);
    int rounds = 0;
    for (const double margin : kHigherAims) {
        if (options.margin > 0 || left.tets == 0 || left.tets > few || improver.counts().places > most_places(mesh))
            break;
        improver.aim_higher(sine_of(target_angle(options) + margin));
        for (const Search& search : searches_of(options.effort))
            improver.work(search, stage.next());
        left = shortfall(mesh, target, run);
        ++rounds;
    }
    run.note("improving.rounds_around", rounds);
    left.places = improver.counts().places;
    return left;
}

}  // namespace

Shortfall improve(LocalMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run)
{
    if (options.effort == Effort::off)
        return {};
    const Array<Search> searches = searches_of(options.effort);
    Stage stage(run, "improving", steps_of(searches.size()));
    Improver improver(mesh, volume, sine_of(target_angle(options) + options.margin), run);
    note_angles(mesh, "improving", "before", run);
    int number = 0;
    for (const Search& search : searches) {
        improver.work(search, stage.next());
        run.note("improving.left_" + std::to_string(++number), static_cast<double>(improver.left()));
    }
    const Shortfall left = search_on(mesh, improver, options, stage, run);
    note_angles(mesh, "improving", "after", run);
    note_counts(improver.counts(), run);
    return left;
}

void improve(LabelledMesh& mesh, const Volume& volume, const ImproveOptions& options, const Run& run)
{
    if (options.effort == Effort::off)
        return;
    // The mesh is moved in and out, so that it is never held twice.
    LocalMesh local(std::move(mesh), run);
    improve(local, volume, options, run);
    mesh = local.take(run);
}

}  // namespace cleft
