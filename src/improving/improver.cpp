// Passes over the bad tetrahedra: cheap operations for all, expensive ones for the worst.
#include "improving/improver.hpp"

#include "base/touched_array.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Expensive operations are for a few: where a target is out of reach for many (random noise, an angle asked too much),
// only the worst get them, one in so many tetrahedra of the mesh and some more.
// The first number of each pair bounds the time in large meshes. The second leaves small meshes some attempts too.
constexpr size_t kThoroughOneIn = 200, kThoroughAtLeast = 200;
constexpr size_t kAttemptsOneIn = 10000, kAttemptsAtLeast = 5;
constexpr size_t kWideOneIn = 100000, kWideAtLeast = 5;

// Where a target is out of reach, each pass makes as many tetrahedra bad as it makes good. After so many passes in a
// row with hardly fewer bad ones the search ends, if there are many: checkerboards at 32 degrees then take a fifth of
// the time. The first pass over labels of random voxels leaves more bad ones than before, and the later ones ever
// fewer.
constexpr double kStalled = 0.98;
constexpr int kStalledPasses = 2;

// Where a target is out of reach, as 25 degrees are where voxels are long needles, splits would go on for ever: each
// makes something better. Labels of random voxels grow to 1.6 times at 32 degrees. Coarse meshes of long voxels, which
// are small, grow to some five times until they meet 25.
int32_t most_tets_from(int32_t tets)
{
    constexpr int64_t kGrowth = 2, kGrowthAtLeast = 5000;
    return static_cast<int32_t>(std::min<int64_t>(kGrowth * tets + kGrowthAtLeast, INT32_MAX));
}

// The tetrahedra at the corners of some, these included, ascending.
void add_around(const LocalMesh& mesh, Array<int32_t>& tets)
{
    Array<int32_t> found;
    for (const int32_t t : tets)
        for (const int32_t v : mesh.tet(t))
            found.insert(found.end(), mesh.star(v).begin(), mesh.star(v).end());
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    tets = std::move(found);
}

size_t attempts_in_pass(const Search& search, size_t tets)
{
    if (!search.compound)
        return 0;
    return search.wide ? tets / kWideOneIn + kWideAtLeast : tets / kAttemptsOneIn + kAttemptsAtLeast;
}

}  // namespace

Improver::Improver(LocalMesh& mesh, const Volume& volume, double target, const Run& run)
    : target_(target),
      mesh_(mesh),
      home_(large_copy(run, mesh.points())),
      finders_(run, mesh, volume, home_),
      rounds_(mesh, bad_),
      compound_(mesh, volume, home_, bad_),
      most_tets_(most_tets_from(mesh.slot_count()))
{
}

void Improver::work(const Search& search, const Run& run)
{
    search_ = search;
    search_.most_tets = most_tets_;
    for (ChangeFinder& finder : finders_)
        finder.aim_at(target_, search_);
    if (started_)
        bad_.collect_left(mesh_, target_);
    else
        bad_.collect_all(mesh_, target_, run);
    started_ = true;
    const size_t tets = to_size(mesh_.slot_count());
    const size_t many = tets / kThoroughOneIn + kThoroughAtLeast;
    const double share = 1.0 / search.passes;
    bool changed = true;
    int stalled = 0;
    for (int number = 0; number < search.passes && changed && stalled < kStalledPasses; ++number) {
        if (counts_.places > most_places(mesh_))
            break;
        const size_t before = bad_.size();
        attempts_left_ = attempts_in_pass(search, tets);
        changed = pass(search.thorough ? std::min(many, before) : before, run, number * share, share);
        bad_.collect_next(mesh_, target_);
        count_places();
        const bool is_stalled = bad_.size() > many && double(bad_.size()) > kStalled * double(before);
        stalled = is_stalled ? stalled + 1 : 0;
    }
}

// Over the worst `most`. Compound operations change much and are for a few, so their tetrahedra are visited one by one.
bool Improver::pass(size_t most, const Run& run, double done, double share)
{
    bool changed = false;
    size_t i = 0;
    for (; i < most && attempts_left_ > 0; ++i) {
        run.report(done);
        const bool worth = bad_.worth_trying(mesh_, i, target_);
        const bool helped = worth && improve_tet(bad_[i]);
        changed = changed || helped;
        bad_.give_back(i, worth && !helped);
    }
    const auto find = [&](int worker, int32_t t, int step, Proposal& proposal) {
        return finders_[worker].find(t, step, proposal);
    };
    const auto made = [&](const Proposal& proposal) { count(proposal); };
    const int64_t tried = rounds_.tried();
    changed = rounds_.visit(i, most, target_, find, made, run, done, share) || changed;
    counts_.tried += rounds_.tried() - tried;
    // Those that are not visited are given back too, so that the next pass finds all that are left.
    for (i = std::max(i, most); i < bad_.size(); ++i)
        bad_.give_back(i, false);
    return changed;
}

void Improver::aim_higher(double target)
{
    // With fewer rings the search has no room to take another way. With more, it works on tetrahedra that are far from
    // any bad one.
    constexpr int kRings = 3;
    target_ = target;
    Array<int32_t> near;
    for (size_t i = 0; i < bad_.size(); ++i)
        near.push_back(bad_[i]);
    for (int ring = 0; ring < kRings; ++ring)
        add_around(mesh_, near);
    bad_.changed(mesh_, near);
}

bool Improver::improve_tet(int32_t t)
{
    ++counts_.tried;
    bool moved = false;
    for (int step = 0; mesh_.alive(t) && mesh_.quality(t) < target_;) {
        proposal_.kind = Proposal::Kind::none;
        step = finders_[0].find(t, step, proposal_);
        if (proposal_.kind == Proposal::Kind::none)
            break;
        proposal_.make(mesh_);
        bad_.changed(mesh_, proposal_.changed());
        count(proposal_);
        if (proposal_.kind != Proposal::Kind::move)
            return true;
        moved = true;
    }
    if (moved)
        return true;
    --attempts_left_;
    if (!compound_.improve(t, search_, target_))
        return false;
    counts_.moved += compound_.points_moved();
    ++counts_.compound;
    return true;
}

void Improver::count_places()
{
    counts_.places = compound_.places();
    for (const ChangeFinder& finder : finders_)
        counts_.places += finder.places();
}

void Improver::count(const Proposal& proposal)
{
    using Kind = Proposal::Kind;
    counts_.moved += proposal.kind == Kind::move;
    counts_.edges_removed += proposal.kind == Kind::edge_removal;
    counts_.faces_removed += proposal.kind == Kind::face_removal;
    counts_.contracted += proposal.kind == Kind::contraction;
    counts_.split += proposal.kind == Kind::split;
    if (proposal.kind == Kind::split)
        home_.push_back(proposal.place);
}

}  // namespace cleft
