// Threads take bricks as they come; the tetrahedra of a brick go to the groups of its own points.
#include "delaunay/brick_delaunay.hpp"

#include "base/parallel.hpp"
#include "delaunay/brick.hpp"
#include "delaunay/tet_groups.hpp"

#include <memory>
#include <mutex>

namespace cleft
{

namespace
{

// Memory of kernels that no thread uses at the moment.
class SpareWork
{
public:
    std::unique_ptr<BrickWork> take()
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        if (spare_.empty())
            return std::make_unique<BrickWork>();
        std::unique_ptr<BrickWork> work = std::move(spare_.back());
        spare_.pop_back();
        return work;
    }
    void give(std::unique_ptr<BrickWork> work)
    {
        const std::lock_guard<std::mutex> lock(mutex_);
        spare_.push_back(std::move(work));
    }

private:
    std::mutex mutex_;
    Array<std::unique_ptr<BrickWork>> spare_;
};

FixedArray<int64_t, 4> positions_of(const PointTree& tree, const Tet& numbers)
{
    FixedArray<int64_t, 4> positions{};
    for (int64_t i = 0; i < tree.points().count(); ++i)
        for (int k = 0; k < 4; ++k)
            if (tree.points()[i].number == numbers[k])
                positions[k] = i;
    return positions;
}

Array<Array<Tet>> tets_of_bricks(const PointTree& tree, const Tet& first_tet, const Run& run)
{
    const FixedArray<int64_t, 4> first = positions_of(tree, first_tet);
    Array<Array<Tet>> tets(tree.brick_count());
    SpareWork spare;
    std::atomic<int64_t> done{0};
    const std::thread::id caller = std::this_thread::get_id();
    parallel_for(run, tree.brick_count(), 1, [&](int64_t begin, int64_t end) {
        std::unique_ptr<BrickWork> work = spare.take();
        for (int64_t brick = begin; brick < end; ++brick)
            tets[brick] = brick_tets(tree, brick, first, *work, run);
        spare.give(std::move(work));
        done += end - begin;
        if (std::this_thread::get_id() == caller)
            run.report(static_cast<double>(done) / static_cast<double>(tree.brick_count()));
    });
    return tets;
}

}  // namespace

Array<Tet> brick_delaunay(const Array<Vec3>& points, const Tet& first_tet, int64_t points_in_brick, const Run& run)
{
    const PointTree tree(points, points_in_brick, run);
    Array<Array<Tet>> bricks = tets_of_bricks(tree, first_tet, run);
    return grouped(bricks, points.count(), run);
}

}  // namespace cleft
