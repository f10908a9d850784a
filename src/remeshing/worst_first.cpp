// Keeps the list of bad tetrahedra of a local search, and when something near each of them changed.
#include "remeshing/worst_first.hpp"

#include "base/collect.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Tetrahedra that a thread looks at. The number changes the time alone.
constexpr int64_t kTetsAtOnce = 1 << 14;
// The same, of those in the next pass, whose qualities are not known.
constexpr int64_t kNextAtOnce = 1 << 10;

}  // namespace

void WorstFirst::collect_all(const LocalMesh& mesh, double target, const Run& run)
{
    threads_.threads = run.threads;
    threads_.team = run.team;
    threads_.loop_time = run.loop_time;
    next_.assign(worker_count(run), {});
    tried_ = array_with_room(run, mesh.slot_count(), kNotListed);
    // Items start with `tried` 0, before this time, so each is worth a first try.
    changed_ = array_with_room(run, mesh.point_count(), now_);
    if (!measure_)
        mesh.find_qualities(run);
    list_ = collect<Item>(run, mesh.slot_count(), kTetsAtOnce, [&](int64_t begin, int64_t end, Array<Item>& list) {
        for (auto t = static_cast<int32_t>(begin); t < end; ++t)
            if (const double good = mesh.alive(t) ? goodness(mesh, t) : target; is_for_search(mesh, t, good, target))
                list.push_back({good, t, 0});
    });
    sort_list();
}

void WorstFirst::collect_left(const LocalMesh& mesh, double target)
{
    for (const Item& item : list_)
        list_next(item.tet, 0);
    for (const Array<int32_t>& next : next_)
        for (const int32_t t : next)
            tried_[t] = 0;
    collect_next(mesh, target);
}

void WorstFirst::collect_next(const LocalMesh& mesh, double target)
{
    const Array<int32_t> next =
        joined<int32_t>(threads_, next_, [](Array<int32_t>& part) -> Array<int32_t>& { return part; });
    // Each tetrahedron is listed once, so no two threads find the quality of the same one.
    list_ = collect<Item>(threads_, next.count(), kNextAtOnce, [&](int64_t begin, int64_t end, Array<Item>& list) {
        for (int64_t i = begin; i < end; ++i) {
            const int32_t t = next[i];
            const uint32_t tried = std::exchange(tried_[t], kNotListed);
            if (const double good = mesh.alive(t) ? goodness(mesh, t) : target; is_for_search(mesh, t, good, target))
                list.push_back({good, t, tried});
        }
    });
    sort_list();
}

void WorstFirst::make_room_for(int64_t tets)
{
    if (tets <= tried_.count())
        return;
    make_room(tried_, to_size(tets - tried_.count()));
    tried_.resize(tets, kNotListed);
}

// Of several times the last one counts.
void WorstFirst::list_next(int32_t t, uint32_t tried, int worker)
{
    if (tried_[t] == kNotListed)
        next_[worker].push_back(t);
    if (tried_[t] == kNotListed || tried_[t] < tried)
        tried_[t] = tried;
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
    if (!mesh.alive(item.tet) || !is_for_search(mesh, item.tet, goodness(mesh, item.tet), target))
        return false;
    const Tet& corners = mesh.tet(item.tet);
    return std::any_of(corners.begin(), corners.end(), [&](int32_t v) { return changed_[v] > item.tried; });
}

void WorstFirst::changed(const LocalMesh& mesh, const Array<int32_t>& tets)
{
    begin_changes(mesh);
    note_change(mesh, tets, 0);
}

void WorstFirst::begin_changes(const LocalMesh& mesh)
{
    ++now_;
    make_room(changed_, to_size(mesh.point_count() - changed_.count()));
    changed_.resize(mesh.point_count(), now_);
    make_room_for(mesh.slot_count());
}

void WorstFirst::note_change(const LocalMesh& mesh, const Array<int32_t>& tets, int worker)
{
    for (const int32_t t : tets) {
        for (const int32_t v : mesh.tet(t))
            changed_[v] = now_;
        list_next(t, 0, worker);
    }
}

void WorstFirst::renumbered(const Array<int32_t>& tets)
{
    if (!tets.empty())
        make_room_for(int64_t{*std::max_element(tets.begin(), tets.end())} + 1);
    for (const int32_t t : tets)
        // The stars are what they were, so the time is kept and they are not tried again.
        list_next(t, now_);
}

void WorstFirst::give_back(size_t i, bool tried) { list_next(list_[i].tet, tried ? now_ : list_[i].tried); }

}  // namespace cleft
