#include "improving/settle_lines.hpp"

#include "cleaving/tie.hpp"
#include "mesh/smoothing.hpp"

#include <algorithm>
#include <array>

namespace cleft
{

namespace
{

// Smaller moves are not worth their price, in lengths of the edges around.
constexpr double kLeastMove = 5e-3;
constexpr double kLeastShare = 0.1;
constexpr int kRounds = 3;  // a point that is in the way may have moved on
constexpr int32_t kTetsACheck = 1 << 16;
constexpr size_t kPointsACheck = 1 << 8;  // between two looks for a cancel

// Ascending.
std::vector<int32_t> points_of_three_materials(const LocalMesh& mesh, const Run& run)
{
    constexpr Material kNone = -1;
    std::vector<std::array<Material, 2>> first_two(static_cast<size_t>(mesh.point_count()), {kNone, kNone});
    std::vector<uint8_t> has_three(static_cast<size_t>(mesh.point_count()), 0);
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        if (t % kTetsACheck == 0)
            run.check();
        const Material m = mesh.material(t);
        for (const int32_t v : mesh.tet(t)) {
            auto& [first, second] = first_two[static_cast<size_t>(v)];
            if (first == kNone)
                first = m;
            else if (m != first && second == kNone)
                second = m;
            else if (m != first && m != second)
                has_three[static_cast<size_t>(v)] = 1;
        }
    }
    std::vector<int32_t> points;
    for (int32_t v = 0; v < mesh.point_count(); ++v)
        if (has_three[static_cast<size_t>(v)])
            points.push_back(v);
    return points;
}

class Settler
{
public:
    Settler(LocalMesh& mesh, const Volume& volume, double floor) : mesh_(mesh), volume_(volume), floor_(floor) {}

    // The share of its way that the point went; 1 if there is none to go.
    double settle(int32_t v)
    {
        star_.load(mesh_, v);
        MaterialSet materials;
        for (const int32_t t : star_.tets())
            if (!materials.unite(MaterialSet(mesh_.material(t))))
                return 1;
        const Vec3 from = mesh_.point(v);
        const double reach = star_.reach(from);
        const auto on_tie = project_to_tie(volume_, from, from, materials, mesh_.frozen(v), reach, samples_);
        if (!on_tie || (*on_tie - from).norm() < kLeastMove * reach)
            return 1;
        const double least = std::min(floor_, star_.worst_at(from, -1));
        for (double share = 1; share > kLeastShare; share *= 0.5) {
            const Vec3 x = from + share * (*on_tie - from);
            if (star_.worst_at(x, least) > least) {
                mesh_.move(v, x);
                return share;
            }
        }
        return 0;
    }

private:
    LocalMesh& mesh_;
    const Volume& volume_;
    const double floor_;
    TetStar star_;
    Samples samples_;
};

}  // namespace

int64_t settle_lines(LocalMesh& mesh, const Volume& volume, double floor, const Run& run)
{
    std::vector<int32_t> points = points_of_three_materials(mesh, run);
    Settler settler(mesh, volume, floor);
    for (int round = 0; round < kRounds; ++round) {
        std::vector<int32_t> left;
        for (size_t i = 0; i < points.size(); ++i) {
            if (i % kPointsACheck == 0)
                run.check();
            if (settler.settle(points[i]) < 1)
                left.push_back(points[i]);
        }
        points.swap(left);
    }
    return static_cast<int64_t>(points.size());
}

}  // namespace cleft
