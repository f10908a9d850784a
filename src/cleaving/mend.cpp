// Mends pinched interfaces one point at a time, by the change that does the least harm.
#include "cleaving/mend.hpp"

#include "base/parallel.hpp"
#include "cleaving/change.hpp"

#include <algorithm>
#include <memory>

namespace cleft
{

namespace
{

// A change can uncover or cause a defect next to it, which the next round mends. The limit bounds the time in random
// noise, where defects never quite run out.
constexpr int kMendRounds = 10;
// With more debt allowed, every first change would be tried with all second ones around. That takes far longer, and
// moves more tetrahedra away from their material.
constexpr int kMostDebt = 2;  // defects that the first of two changes may add

int count_defects(Link& link, const LabelledMesh& mesh, const PointStars& stars, int32_t point)
{
    const PointStars::Range star = stars.at(point);
    link.load(mesh, point, star.first, star.last);
    return link.defects();
}

Array<int32_t> points_of(const LabelledMesh& mesh, const Change& change)
{
    Array<int32_t> points;
    for (const int32_t t : change.tets)
        points.insert(points.end(), mesh.tets[t].begin(), mesh.tets[t].end());
    std::sort(points.begin(), points.end());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    return points;
}

class Mender
{
public:
    Mender(LabelledMesh& mesh, const PointStars& stars, const Run& run)
        : mesh_(mesh),
          stars_(stars),
          run_(run),
          link_(mesh.points.size()),
          harm_(mesh, stars),
          defects_(mesh.points.size(), kUnknown)
    {
        for (const Material m : mesh.material) {
            tets_of_.resize(std::max(tets_of_.count(), int64_t{m} + 1), 0);
            ++tets_of_[m];
        }
    }

    // Returns the points that are still pinched.
    Array<int32_t> mend(Array<int32_t> pinched)
    {
        for (int round = 0; round < kMendRounds && !pinched.empty(); ++round) {
            touched_.clear();
            for (const int32_t v : pinched) {
                run_.check();
                while (defects(v) > 0 && (change_once(v, 0) || change_twice(v)))
                    ;
            }
            // A round without a change would repeat itself.
            if (touched_.empty())
                break;
            pinched.insert(pinched.end(), touched_.begin(), touched_.end());
            // By number: the order of the work decides the result, so it must not depend on the order of discovery.
            std::sort(pinched.begin(), pinched.end());
            pinched.erase(std::unique(pinched.begin(), pinched.end()), pinched.end());
            pinched.erase(std::remove_if(pinched.begin(), pinched.end(), [&](int32_t v) { return defects(v) == 0; }),
                          pinched.end());
        }
        return pinched;
    }

    int64_t changed() const { return changed_; }

private:
    static constexpr int kUnknown = -1;

    int defects(int32_t point)
    {
        int& known = defects_[point];
        if (known == kUnknown)
            known = count_defects(link_, mesh_, stars_, point);
        return known;
    }

    Array<Change> changes(int32_t point)
    {
        count_defects(link_, mesh_, stars_, point);
        return changes_at(mesh_, stars_.at(point), link_);
    }

    // The change at the point that does the least harm, and of these has the least volume, of those that leave fewer
    // defects than there were before the debt.
    bool change_once(int32_t point, int debt)
    {
        Harm least = Harm::adds_or_loses;
        const Change* best = nullptr;
        const Array<Change> all = changes(point);
        for (const Change& change : all) {
            // Changes come by volume, so the first one without harm is the one wanted.
            if (best && least == Harm::none)
                break;
            if (gain(change) <= debt || tets_of_[change.from] == change.tets.count())
                continue;
            const Harm harm = harm_.harm(change);
            if (!best || harm < least) {
                best = &change;
                least = harm;
            }
        }
        if (best)
            make(*best);
        return best != nullptr;
    }

    bool change_twice(int32_t point)
    {
        for (const Change& first : changes(point)) {
            const int debt = -gain(first);
            if (debt > kMostDebt || tets_of_[first.from] == first.tets.count())
                continue;
            make(first);
            for (const int32_t v : points_of(mesh_, first))
                if (defects(v) > 0 && change_once(v, debt))
                    return true;
            // Taken back, since no second change has paid its debt.
            make({first.tets, first.to, first.from, first.volume});
        }
        return false;
    }

    // How many defects fewer the change would leave.
    int gain(const Change& change)
    {
        const Array<int32_t> points = points_of(mesh_, change);
        int gain = 0;
        for (const int32_t v : points)
            gain += defects(v);
        give(change.tets, change.to);
        for (const int32_t v : points)
            gain -= count_defects(link_, mesh_, stars_, v);
        give(change.tets, change.from);
        return gain;
    }

    void make(const Change& change)
    {
        give(change.tets, change.to);
        const auto count = change.tets.count();
        tets_of_[change.from] -= count;
        CLEFT_ASSERT(tets_of_[change.from] > 0);  // no label loses its last tetrahedron
        tets_of_[change.to] += count;
        changed_ += count;
        for (const int32_t v : points_of(mesh_, change)) {
            defects_[v] = kUnknown;
            touched_.push_back(v);
        }
    }

    void give(const Array<int32_t>& tets, Material to)
    {
        for (const int32_t t : tets)
            mesh_.material[t] = to;
    }

    LabelledMesh& mesh_;
    const PointStars& stars_;
    const Run& run_;
    Link link_;
    HarmCheck harm_;
    Array<int> defects_;      // by point, as they are known
    Array<int64_t> tets_of_;  // by material
    Array<int32_t> touched_;
    int64_t changed_ = 0;
};

Array<int32_t> find_pinched(const LabelledMesh& mesh, const PointStars& stars, const Array<int32_t>& points,
                            const Run& run)
{
    // A worker needs a table of all points: 32 pieces of work bound how many can have one.
    const int64_t grain = std::max<int64_t>(512, points.count() / 32);
    Array<std::unique_ptr<Link>> links(worker_count(run));  // by worker; made when it begins
    Array<uint8_t> is_pinched(points.size());
    parallel_chunks_by_worker(run, points.count(), grain, [&](int worker, int64_t, int64_t begin, int64_t end) {
        if (!links[worker])
            links[worker] = std::make_unique<Link>(mesh.points.size());
        for (int64_t i = begin; i < end; ++i)
            is_pinched[i] = count_defects(*links[worker], mesh, stars, points[i]) > 0;
    });
    Array<int32_t> pinched;
    for (size_t i = 0; i < points.size(); ++i)
        if (is_pinched[i])
            pinched.push_back(points[i]);
    return pinched;
}

}  // namespace

void mend_interfaces(LabelledMesh& mesh, const Array<int32_t>& points, const Run& run)
{
    Array<int32_t> pinched;
    int64_t found = 0, changed = 0;
    if (!points.empty()) {
        const PointStars stars(mesh.tets, mesh.points.size(), run);
        pinched = find_pinched(mesh, stars, points, run);
        found = pinched.count();
        if (found > 0) {
            Mender mender(mesh, stars, run);
            pinched = mender.mend(std::move(pinched));
            changed = mender.changed();
        }
    }
    run.note("cleaving.pinched", static_cast<double>(found));
    run.note("cleaving.mended", static_cast<double>(changed));
    run.note("cleaving.left_pinched", static_cast<double>(pinched.size()));
}

}  // namespace cleft
