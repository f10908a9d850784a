// Visits of points of a mesh that change no connections, on all threads, with the same result for any number of them.
#pragma once

#include "base/array.hpp"
#include "base/collect.hpp"
#include "remeshing/ordered_points.hpp"

namespace cleft
{

class PointVisits
{
public:
    // Points are visited by number within a block; those next to a point of another block come last.
    PointVisits(const LocalMesh& mesh, const Run& run) : mesh_(mesh), run_(run) {}

    // do_visit(worker, v) for each point of which is_wanted(v) was true before the first visit. A visit may change the
    // place of its point, and see the points next to it.
    template <class IsWanted, class Visit>
    void visit(const IsWanted& is_wanted, const Visit& do_visit) const
    {
        const int64_t count = mesh_.point_count();
        Array<Place> place(count, Place::left_out);
        parallel_for(run_, count, kBlock, [&](int64_t begin, int64_t end) {
            for (auto v = static_cast<int32_t>(begin); v < end; ++v)
                if (is_wanted(v))
                    place[v] = is_inside(v, begin, end) ? Place::inside : Place::at_border;
        });
        parallel_chunks_by_worker(run_, count, kBlock, [&](int worker, int64_t, int64_t begin, int64_t end) {
            for (auto v = static_cast<int32_t>(begin); v < end; ++v)
                if (place[v] == Place::inside)
                    do_visit(worker, v);
        });
        run_.report(0.7);
        const auto border =
            collect<int32_t>(run_, count, kBlock, [&](int64_t begin, int64_t end, Array<int32_t>& list) {
                for (auto v = static_cast<int32_t>(begin); v < end; ++v)
                    if (place[v] == Place::at_border)
                        list.push_back(v);
            });
        visit_points_in_order(
            mesh_, border.count(), [&](int64_t i) { return border[i]; }, run_,
            [&](int worker, int32_t i) { do_visit(worker, border[i]); });
    }

private:
    enum class Place : uint8_t { left_out, inside, at_border };

    // Points come along a curve through space, so most of those next to one are in its block. Smaller blocks have more
    // points at their borders, larger ones leave threads without work in small meshes.
    static constexpr int64_t kBlock = 8192;

    bool is_inside(int32_t v, int64_t begin, int64_t end) const
    {
        for (const int32_t t : mesh_.star(v))
            for (const int32_t w : mesh_.tet(t))
                if (w < begin || w >= end)
                    return false;
        return true;
    }

    const LocalMesh& mesh_;
    const Run& run_;
};

}  // namespace cleft
