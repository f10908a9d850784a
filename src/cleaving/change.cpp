// Lists the changes that may mend an interface, and judges by a search nearby whether they cut or join pieces.
#include "cleaving/change.hpp"

#include "mesh/quality.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// A larger limit would find longer ways around, and so call fewer changes harmful; each change costs two such searches.
constexpr size_t kNear = 300;  // tetrahedra in which a search looks for what hangs together

bool share_face(const Tet& a, const Tet& b)
{
    return std::count_if(a.begin(), a.end(), [&](int32_t v) { return has_corner(b, v); }) == 3;
}

// Groups of one material that hang together over faces.
Array<Array<int32_t>> pieces(const LabelledMesh& mesh, Array<int32_t> tets)
{
    Array<Array<int32_t>> groups;
    while (!tets.empty()) {
        Array<int32_t> group{tets.back()};
        tets.pop_back();
        for (size_t i = 0; i < group.size(); ++i) {
            const auto joins = [&](int32_t t) {
                return mesh.material[t] == mesh.material[group[i]] && share_face(mesh.tets[t], mesh.tets[group[i]]);
            };
            const auto rest = std::stable_partition(tets.begin(), tets.end(), std::not_fn(joins));
            group.insert(group.end(), rest, tets.end());
            tets.erase(rest, tets.end());
        }
        groups.push_back(std::move(group));
    }
    return groups;
}

double volume(const LabelledMesh& mesh, const Array<int32_t>& tets)
{
    double sum = 0;
    for (const int32_t t : tets) {
        const auto x = [&](size_t i) { return mesh.points[mesh.tets[t][i]]; };
        sum += orient(x(0), x(1), x(2), x(3)) / 6;
    }
    return sum;
}

// `tets`, of two materials: each piece of them, and each alone.
void add_changes(const LabelledMesh& mesh, const Array<int32_t>& tets, Array<Change>& changes)
{
    const Material first = mesh.material[tets.front()];
    Material second = first;
    for (const int32_t t : tets)
        // A defect counts only where two materials meet, so one of them is `first` and all others are `second`.
        if (mesh.material[t] != first)
            second = mesh.material[t];
    const auto add = [&](const Array<int32_t>& part) {
        const Material from = mesh.material[part.front()];
        changes.push_back({part, from, from == first ? second : first, volume(mesh, part)});
    };
    for (const Array<int32_t>& piece : pieces(mesh, tets)) {
        add(piece);
        for (size_t i = 0; i < piece.size() && piece.size() > 1; ++i)
            add({piece[i]});
    }
}

}  // namespace

Array<Change> changes_at(const LabelledMesh& mesh, const PointStars::Range& star, const Link& link)
{
    Array<Change> changes;
    Array<int32_t> tets(star.begin(), star.end());
    std::sort(tets.begin(), tets.end());
    if (link.is_pinched())
        add_changes(mesh, tets, changes);
    for (const int32_t other : link.pinched_edges()) {
        Array<int32_t> ring;
        std::copy_if(tets.begin(), tets.end(), std::back_inserter(ring),
                     [&](int32_t t) { return has_corner(mesh.tets[t], other); });
        add_changes(mesh, ring, changes);
    }
    // Of equal volumes the first found stays first, so that the choice is the same in every run.
    std::stable_sort(changes.begin(), changes.end(),
                     [](const Change& a, const Change& b) { return a.volume < b.volume; });
    return changes;
}

Harm HarmCheck::harm(const Change& change)
{
    CLEFT_ASSERT(std::all_of(change.tets.begin(), change.tets.end(),
                             [&](int32_t t) { return mesh_.material[t] == change.from; }));
    const Array<int32_t> rest = touching(change, change.from), near = touching(change, change.to);
    // Nothing of `from` is left next to it, or nothing of `to` is there to join: a piece would vanish or appear.
    if (rest.empty() || near.empty())
        return Harm::adds_or_loses;
    const bool cuts = !are_connected(rest, change), joins = !are_connected(near, change);
    return cuts && joins ? Harm::both : cuts || joins ? Harm::cuts_or_joins : Harm::none;
}

// Tetrahedra of a material that share a face with the change.
Array<int32_t> HarmCheck::touching(const Change& change, Material material) const
{
    Array<int32_t> found;
    for (const int32_t t : change.tets)
        for (size_t corner = 0; corner < 4; ++corner) {
            const int32_t n = neighbour(t, corner);
            if (n >= 0 && mesh_.material[n] == material &&
                std::find(change.tets.begin(), change.tets.end(), n) == change.tets.end())
                found.push_back(n);
        }
    std::sort(found.begin(), found.end());
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

// All in one piece of their material, the change left out.
bool HarmCheck::are_connected(const Array<int32_t>& tets, const Change& change)
{
    if (tets.size() < 2)
        return true;
    ++search_;
    for (const int32_t t : change.tets)
        met_[t] = search_;
    queue_.assign(1, tets.front());
    met_[tets.front()] = search_;
    size_t found = 1;
    for (size_t i = 0; i < queue_.size() && queue_.size() < kNear; ++i)
        for (size_t corner = 0; corner < 4; ++corner) {
            const int32_t n = neighbour(queue_[i], corner);
            if (n < 0 || met_[n] == search_ || mesh_.material[n] != mesh_.material[tets.front()])
                continue;
            met_[n] = search_;
            queue_.push_back(n);
            found += std::binary_search(tets.begin(), tets.end(), n);
        }
    return found == tets.size();
}

// Behind the face opposite the corner; -1 on the hull.
int32_t HarmCheck::neighbour(int32_t tet, size_t corner) const
{
    const Tet& c = mesh_.tets[tet];
    const int32_t x = c[(corner + 1) % 4], y = c[(corner + 2) % 4], z = c[(corner + 3) % 4];
    for (const int32_t t : stars_.at(x))
        if (t != tet && has_corner(mesh_.tets[t], y) && has_corner(mesh_.tets[t], z))
            return t;
    return -1;
}

}  // namespace cleft
