// Visits that change the mesh around them, on all threads, with the same result for any number of them: those that
// have no tetrahedron in common are made side by side, the others in a later round (deterministic reservations:
// Blelloch, Fineman, Gibbons, Shun 2012).
#pragma once

#include "base/shared_access.hpp"
#include "base/touched_array.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

class ClaimedVisits
{
public:
    // As many tetrahedra as the mesh has slots, which the visits must not add to.
    ClaimedVisits(const LocalMesh& mesh, const Run& run) : claimed_by_(large_array(run, mesh.slot_count(), UINT32_MAX))
    {
    }

    // Number of the round that goes on, over all calls; from 1.
    uint32_t round() const { return round_; }

    // For each visit 0 to count - 1:
    // claim(worker, i, tets) lists all tetrahedra that it may read or change; none if there is nothing to do.
    // do_visit(worker, i) follows when it has them for itself. Nothing that claim() has read has changed since.
    // end_visit(i) comes last, on the calling thread, in an order that does not depend on the threads.
    template <class Claim, class Visit, class End>
    void visit_all(const Run& run, int64_t count, const Claim& claim, const Visit& do_visit, const End& end_visit)
    {
        const Array<int64_t> order = spread(count);
        const int64_t at_once = chunk_count(count, kRounds);
        int64_t next = 0;
        visits_.clear();
        while (next < count || !visits_.empty()) {
            while (next < count && visits_.count() < at_once)
                visits_.push_back(order[next++]);
            run.report(static_cast<double>(next) / static_cast<double>(count));
            begin_round();
            parallel_chunks_by_worker(run, visits_.count(), kAtOnce,
                                      [&](int worker, int64_t, int64_t begin, int64_t end) {
                                          for (int64_t k = begin; k < end; ++k) {
                                              claims_[k].clear();
                                              claim(worker, visits_[k], claims_[k]);
                                              for (const int32_t t : claims_[k])
                                                  lower_shared(claimed_by_[t], rank(k));
                                          }
                                      });
            parallel_chunks_by_worker(run, visits_.count(), kAtOnce,
                                      [&](int worker, int64_t, int64_t begin, int64_t end) {
                                          for (int64_t k = begin; k < end; ++k) {
                                              waits_[k] = has_all(k) ? 0 : 1;
                                              if (!waits_[k] && !claims_[k].empty())
                                                  do_visit(worker, visits_[k]);
                                          }
                                      });
            end_round(end_visit);
        }
    }

private:
    // In fewer rounds, more visits wait for others near by, and make their claims again. In more, threads wait for each
    // other more often.
    static constexpr int64_t kRounds = 32;
    // Has no factor in common with the rounds, so that visits of rounds that follow each other are not neighbours: one
    // that waited would have the next one wait.
    static constexpr int64_t kRoundStep = 13;
    // Visits that a thread takes at once: each takes some ten microseconds or more. The number changes the time alone.
    static constexpr int64_t kAtOnce = 8;

    // Visits near to each other in the list are mostly near to each other in the mesh. They come in different rounds.
    static Array<int64_t> spread(int64_t count)
    {
        Array<int64_t> order;
        for (int64_t round = 0; round < kRounds; ++round)
            for (int64_t i = round * kRoundStep % kRounds; i < count; i += kRounds)
                order.push_back(i);
        return order;
    }

    void begin_round()
    {
        ++round_;
        const auto count = static_cast<uint32_t>(visits_.count());
        if (ranks_left_ < count) {
            ranks_left_ = UINT32_MAX;
            claimed_by_.assign(claimed_by_.size(), UINT32_MAX);
        }
        ranks_left_ -= count;
        claims_.resize(std::max(claims_.size(), visits_.size()));
        waits_.assign(visits_.size(), 0);
    }

    uint32_t rank(int64_t k) const { return ranks_left_ + static_cast<uint32_t>(k); }

    bool has_all(int64_t k) const
    {
        const Array<int32_t>& claims = claims_[k];
        return std::all_of(claims.begin(), claims.end(), [&](int32_t t) { return claimed_by_[t] == rank(k); });
    }

    // The first of a round has all that it claims, so each round gets on.
    template <class End>
    void end_round(const End& end_visit)
    {
        waiting_.clear();
        for (int64_t k = 0; k < visits_.count(); ++k) {
            if (waits_[k])
                waiting_.push_back(visits_[k]);
            else
                end_visit(visits_[k]);
        }
        visits_.swap(waiting_);
    }

    Array<int64_t> visits_;         // of the round
    Array<Array<int32_t>> claims_;  // by visit of the round
    Array<uint8_t> waits_;          // by visit of the round
    Array<int64_t> waiting_;        // for the next round
    Array<uint32_t> claimed_by_;    // by tetrahedron: the least rank of a visit that claims it
    uint32_t round_ = 0;
    uint32_t ranks_left_ = UINT32_MAX;  // ranks of a round are less than those of all earlier ones
};

}  // namespace cleft
