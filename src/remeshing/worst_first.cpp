// Keeps the list of bad tetrahedra of a local search, and when something near each of them changed.
#include "remeshing/worst_first.hpp"

#include <algorithm>

namespace cleft
{

void WorstFirst::collect_all(const LocalMesh& mesh, double target, const Run& run)
{
    next_.clear();
    list_.clear();
    // Items start with `tried` 0, before this time, so each is worth a first try.
    changed_.assign(mesh.point_count(), now_);
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        run.check_at(t);
        if (mesh.alive(t) && mesh.quality(t) < target)
            list_.push_back({mesh.quality(t), t, 0});
    }
    sort_list();
}

void WorstFirst::collect_left(const LocalMesh& mesh, double target)
{
    for (const Item& item : list_)
        next_.push_back(item);
    for (Item& item : next_)
        item.tried = 0;
    collect_next(mesh, target);
}

void WorstFirst::collect_next(const LocalMesh& mesh, double target)
{
    // One item for each tetrahedron, the one that knows of the last try.
    std::sort(next_.begin(), next_.end(),
              [](const Item& a, const Item& b) { return a.tet != b.tet ? a.tet < b.tet : a.tried > b.tried; });
    next_.erase(std::unique(next_.begin(), next_.end(), [](const Item& a, const Item& b) { return a.tet == b.tet; }),
                next_.end());
    list_.clear();
    for (Item item : next_)
        if (mesh.alive(item.tet)) {
            item.quality = mesh.quality(item.tet);
            if (item.quality < target)
                list_.push_back(item);
        }
    next_.clear();
    sort_list();
}

// By quality, then by number: a total order, so that the course of a search, and so the mesh, is the same in every run.
void WorstFirst::sort_list()
{
    std::sort(list_.begin(), list_.end(), [](const Item& a, const Item& b) {
        return a.quality != b.quality ? a.quality < b.quality : a.tet < b.tet;
    });
}

// What an operation finds at a tetrahedron depends on the stars of its corners alone.
bool WorstFirst::worth_trying(const LocalMesh& mesh, size_t i, double target) const
{
    const Item& item = list_[i];
    if (!mesh.alive(item.tet) || mesh.quality(item.tet) >= target)
        return false;
    const Tet& corners = mesh.tet(item.tet);
    return std::any_of(corners.begin(), corners.end(), [&](int32_t v) { return changed_[v] > item.tried; });
}

void WorstFirst::changed(const LocalMesh& mesh, const Array<int32_t>& tets)
{
    ++now_;
    changed_.resize(mesh.point_count(), now_);
    for (const int32_t t : tets) {
        for (const int32_t v : mesh.tet(t))
            changed_[v] = now_;
        next_.push_back({0, t, 0});
    }
}

void WorstFirst::renumbered(const Array<int32_t>& tets)
{
    for (const int32_t t : tets)
        // The stars are what they were, so the time is kept and they are not tried again.
        next_.push_back({0, t, now_});
}

void WorstFirst::give_back(size_t i, bool tried) { next_.push_back({0, list_[i].tet, tried ? now_ : list_[i].tried}); }

}  // namespace cleft
