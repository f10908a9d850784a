// The order of work of every local search here: bad tetrahedra, the worst first, in passes. A tetrahedron that could
// not be made better is not tried again before something at its corners has changed.
#pragma once

#include "base/array.hpp"
#include "remeshing/local_mesh.hpp"

#include <functional>

namespace cleft
{

class WorstFirst
{
public:
    // How good a tetrahedron is; its quality unless another measure is given.
    using Measure = std::function<double(int32_t t)>;

    WorstFirst() = default;
    explicit WorstFirst(Measure measure) : measure_(std::move(measure)) {}

    // Starts a search: every tetrahedron of the mesh with a quality below `target`.
    void collect_all(const LocalMesh& mesh, double target, const Run& run);
    // Starts another search over what is left of the last one: all that did not help may be tried again.
    void collect_left(const LocalMesh& mesh, double target);
    // The next pass: those below the target that the last pass changed or gave back.
    // The order within a pass is fixed when it begins. Tetrahedra made during the pass wait for the next one.
    void collect_next(const LocalMesh& mesh, double target);

    size_t size() const { return list_.size(); }
    int32_t operator[](size_t i) const { return list_[i].tet; }
    // It is still bad, and something has changed since it was last tried.
    bool worth_trying(const LocalMesh& mesh, size_t i, double target) const;

    // These are new or have been moved.
    void changed(const LocalMesh& mesh, const Array<int32_t>& tets);
    // Its two steps, for several changes at once. The second may be taken by several threads at once for changes that
    // have no point in common. `worker`: of the threads of the run that the search started with.
    void begin_changes(const LocalMesh& mesh);
    void note_change(const LocalMesh& mesh, const Array<int32_t>& tets, int worker);
    // These took the place of others for which nothing helped.
    void renumbered(const Array<int32_t>& tets);
    // Gives the i-th one back for the next pass. `tried`: it was tried and nothing helped.
    void give_back(size_t i, bool tried);

private:
    struct Item {
        double quality;
        int32_t tet;
        uint32_t tried;  // when nothing helped it
    };

    static constexpr uint32_t kNotListed = UINT32_MAX;

    double goodness(const LocalMesh& mesh, int32_t t) const { return measure_ ? measure_(t) : mesh.quality(t); }
    static bool is_for_search(const LocalMesh& mesh, int32_t t, double good, double target)
    {
        return good < target && !mesh.waits(t);
    }
    void make_room_for(int64_t tets);
    void list_next(int32_t t, uint32_t tried, int worker = 0);
    void sort_list();

    Measure measure_;
    Array<Item> list_;
    // By worker, each tetrahedron once. Which worker has which does not matter, since the list is sorted.
    Array<Array<int32_t>> next_ = Array<Array<int32_t>>(1);
    Array<uint32_t> tried_;    // by tetrahedron in next_: when nothing helped it; of others kNotListed
    Array<uint32_t> changed_;  // by point: when something in its star changed last
    uint32_t now_ = 1;
    Run threads_;  // those of the search and its clock, without its callbacks
};

}  // namespace cleft
