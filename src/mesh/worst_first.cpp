#include "mesh/worst_first.hpp"

#include <algorithm>

namespace cleft
{

void WorstFirst::collect_all(const LocalMesh& mesh, double target)
{
    added_.clear();
    bad_.clear();
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        if (mesh.alive(t)) {
            const double q = mesh.quality(t);
            if (q < target)
                bad_.push_back({q, t});
        }
    sort();
}

void WorstFirst::collect_added(const LocalMesh& mesh, double target)
{
    std::sort(added_.begin(), added_.end());
    added_.erase(std::unique(added_.begin(), added_.end()), added_.end());
    bad_.clear();
    for (const int32_t t : added_)
        if (mesh.alive(t)) {
            const double q = mesh.quality(t);
            if (q < target)
                bad_.push_back({q, t});
        }
    added_.clear();
    sort();
}

void WorstFirst::sort()
{
    std::sort(bad_.begin(), bad_.end(), [](const Bad& a, const Bad& b) {
        return a.quality != b.quality ? a.quality < b.quality : a.tet < b.tet;
    });
    order_.clear();
    for (const Bad& bad : bad_)
        order_.push_back(bad.tet);
}

}  // namespace cleft
