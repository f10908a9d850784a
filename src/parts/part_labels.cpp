// Each rank sums what it owns, and all get the sums of all.
#include "parts/part_labels.hpp"

#include "mesh/quality.hpp"
#include "parts/rank_sums.hpp"

#include <algorithm>
#include <unordered_map>

namespace cleft
{

namespace
{

struct LabelTotals {
    int64_t tets = 0;
    double volume = 0;

    LabelTotals& operator+=(const LabelTotals& other)
    {
        tets += other.tets;
        volume += other.volume;
        return *this;
    }
};

// Of the tetrahedra that the part owns.
std::unordered_map<int32_t, LabelTotals> totals_of_own(const MeshPart& part)
{
    std::unordered_map<int32_t, LabelTotals> totals;
    LabelTotals* of_label = nullptr;
    for (int64_t t = 0; t < part.of_tets.owned; ++t) {
        // Neighbours mostly have one label.
        if (!of_label || part.material[t] != part.material[t - 1])
            of_label = &totals[part.material[t]];
        const auto corner = [&](size_t i) -> const Vec3& { return part.points[part.tets[t][i]]; };
        *of_label += {1, orient(corner(0), corner(1), corner(2), corner(3)) / 6};
    }
    return totals;
}

}  // namespace

Array<PartLabel> part_labels(const LabelCounts& labels, const KeptMaterials& kept, const Grid& grid,
                             const MeshPart& part, Exchange& exchange)
{
    Array<PartLabel> rows;
    for (int64_t m = 0; m < labels.labels.count(); ++m)
        rows.push_back({labels.labels[m], kept.has(static_cast<Material>(m)), labels.voxels[m], 0,
                        static_cast<double>(labels.voxels[m]) * grid.spacing.prod(), 0});
    std::sort(rows.begin(), rows.end(), [](const PartLabel& a, const PartLabel& b) { return a.label < b.label; });
    const auto own = totals_of_own(part);
    Array<LabelTotals> totals(rows.size());
    for (size_t i = 0; i < rows.size(); ++i)
        if (const auto found = own.find(number_of(rows[i].label)); found != own.end())
            totals[i] = found->second;
    totals = sums_of_ranks(totals, exchange);
    for (size_t i = 0; i < rows.size(); ++i) {
        rows[i].tets = totals[i].tets;
        rows[i].mesh_volume = totals[i].volume;
    }
    return rows;
}

}  // namespace cleft
