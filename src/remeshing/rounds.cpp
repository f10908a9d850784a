// Finds, chooses and makes changes in rounds. Which visits a round has follows from the list alone.
#include "remeshing/rounds.hpp"

#include "base/large_pages.hpp"
#include "base/parallel.hpp"
#include "base/shared_access.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Visits of a round: at most one for so many points of the mesh, and one in so many of the list. In larger rounds more
// changes are found in vain, since others are made near by: a change is about some twenty points. In smaller ones,
// threads wait for each other more often.
constexpr size_t kPointsEach = 500, kRounds = 64;
constexpr size_t kFewest = 1;
// Visits that a thread takes at once: to find a change takes some twenty microseconds, to check the claims one, to make
// it five. A thread more costs about as much as one of these chunks. The numbers change the time alone.
constexpr int64_t kFoundAtOnce = 8, kCheckedAtOnce = 64, kMadeAtOnce = 16;

// In the place of a step: the tetrahedron is good now, or nothing has changed since it was last tried.
constexpr int kNotTried = -1;

}  // namespace

bool Rounds::visit(size_t begin, size_t end, double target, const Find& find, const Made& made, const Run& run,
                   double done, double share)
{
    const size_t points = to_size(mesh_.point_count());
    const size_t at_once = std::max(kFewest, std::min((end - begin) / kRounds, points / kPointsEach));
    bool changed = false;
    size_t next = begin;
    visits_.clear();
    while (next < end || !visits_.empty()) {
        while (next < end && visits_.size() < at_once)
            visits_.push_back({next++});
        run.report(done + share * static_cast<double>(next - begin) / static_cast<double>(end - begin));
        find_all(target, find, run);
        check_claims(run);
        choose();
        make_all(made, run);
        changed = changed || !chosen_.empty();
        visits_.swap(waiting_);
    }
    return changed;
}

void Rounds::find_all(double target, const Find& find, const Run& run)
{
    if (proposals_.size() < visits_.size())
        proposals_.resize(visits_.size());
    next_step_.resize(visits_.size());
    if (ranks_left_ < visits_.size()) {
        ranks_left_ = UINT32_MAX;
        claimed_by_.assign(claimed_by_.size(), UINT32_MAX);
    }
    ranks_left_ -= static_cast<uint32_t>(visits_.size());
    make_room(claimed_by_, to_size(mesh_.point_count() - claimed_by_.count()));
    claimed_by_.resize(mesh_.point_count(), UINT32_MAX);
    parallel_chunks_by_worker(run, visits_.count(), kFoundAtOnce, [&](int worker, int64_t, int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            const Visit& visit = visits_[i];
            Proposal& proposal = proposals_[i];
            proposal.kind = Proposal::Kind::none;
            next_step_[i] = kNotTried;
            if (!bad_.worth_trying(mesh_, visit.item, target))
                continue;
            next_step_[i] = find(worker, bad_[visit.item], visit.step, proposal);
            if (proposal.kind != Proposal::Kind::none)
                claim(proposal, ranks_left_ + static_cast<uint32_t>(i));
        }
    });
}

// All that an operation changes, and all that decides whether it may be made, is at the points of the tetrahedra that
// it takes out.
void Rounds::claim(const Proposal& proposal, uint32_t rank)
{
    for (const int32_t t : proposal.cavity.old_tets)
        for (const int32_t v : mesh_.tet(t))
            lower_shared(claimed_by_[v], rank);
}

void Rounds::check_claims(const Run& run)
{
    has_all_.assign(visits_.size(), 0);
    parallel_for(run, visits_.count(), kCheckedAtOnce, [&](int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i)
            if (proposals_[i].kind != Proposal::Kind::none)
                has_all_[i] = has_all(proposals_[i], ranks_left_ + static_cast<uint32_t>(i)) ? 1 : 0;
    });
}

bool Rounds::has_all(const Proposal& proposal, uint32_t rank) const
{
    return std::all_of(proposal.cavity.old_tets.begin(), proposal.cavity.old_tets.end(), [&](int32_t t) {
        const Tet& corners = mesh_.tet(t);
        return std::all_of(corners.begin(), corners.end(), [&](int32_t v) { return claimed_by_[v] == rank; });
    });
}

// In the order of visits. The first of a round has all that it claims, so each round gets on.
void Rounds::choose()
{
    chosen_.clear();
    waiting_.clear();
    for (size_t i = 0; i < visits_.size(); ++i) {
        const Visit& visit = visits_[i];
        Proposal& proposal = proposals_[i];
        if (proposal.kind == Proposal::Kind::none) {
            tried_ += next_step_[i] != kNotTried || visit.moved;
            bad_.give_back(visit.item, next_step_[i] != kNotTried && !visit.moved);
        } else if (!has_all_[i]) {
            waiting_.push_back(visit);
        } else {
            chosen_.push_back(i);
            proposal.begin(mesh_);
            if (proposal.kind == Proposal::Kind::move)
                waiting_.push_back({visit.item, next_step_[i], true});
            else
                ++tried_;
        }
    }
}

void Rounds::make_all(const Made& made, const Run& run)
{
    bad_.begin_changes(mesh_);
    parallel_chunks_by_worker(run, chosen_.count(), kMadeAtOnce, [&](int worker, int64_t, int64_t begin, int64_t end) {
        for (int64_t i = begin; i < end; ++i) {
            Proposal& proposal = proposals_[chosen_[i]];
            proposal.make(mesh_, worker);
            bad_.note_change(mesh_, proposal.changed(), worker);
        }
    });
    for (const size_t i : chosen_) {
        Proposal& proposal = proposals_[i];
        proposal.end(mesh_);
        made(proposal);
    }
}

}  // namespace cleft
