#include "cleaving/snap.hpp"

#include "cleaving/star.hpp"
#include "mesh/quality.hpp"

#include <limits>

namespace cleft
{

namespace
{

constexpr double kReach = 0.5;       // how far a cut may be to be snapped to, in shortest edges at the vertex
constexpr double kStay = 0.1;        // how close a cut must be to be taken over in place, in its edge
constexpr double kLeastSine = 0.34;  // 20 degrees: the background is not warped below, unless it gets better
constexpr int kPasses = 3;
constexpr size_t kMostCuts = 6;     // at one vertex, nearest first
constexpr int kMostMaterials = 10;  // at one vertex

struct NearCut {
    double distance;
    Vec3 x;
    int32_t edge, other;  // the end that is not the vertex
};

// A choice among the near cuts: the one at `last` alone, or all from the nearest up to it.
struct Choice {
    size_t first, last;
};

class Snapper
{
public:
    Snapper(Centres& c, const std::vector<uint8_t>& frozen, Snap rule, const Run& run)
        : c_(c), frozen_(frozen), rule_(rule), run_(run), tets_of_(c), touched_(c.points.size(), 1)
    {
    }

    SnapCounts run()
    {
        const int passes = rule_ == Snap::quality ? kPasses : 1;
        for (int pass = 0; pass < passes; ++pass) {
            const std::vector<int32_t> order = vertices_in_order();
            for (size_t i = 0; i < order.size(); ++i) {
                if (i % 128 == 0)
                    run_.report(0.3 + 0.5 * (pass + double(i) / double(order.size())) / passes, "cleaving: snapping");
                visit(order[i]);
            }
        }
        return counts_;
    }

private:
    // Vertices whose star changed since the last visit, by the distance of the nearest cut in shortest edges.
    std::vector<int32_t> vertices_in_order()
    {
        std::vector<std::pair<float, int32_t>> keyed;
        for (const int32_t v : tets_of_.vertices()) {
            if (!touched_[static_cast<size_t>(v)])
                continue;
            gather(v);
            if (!near_.empty())
                keyed.emplace_back(static_cast<float>(near_[0].distance / star_.shortest_edge), v);
        }
        std::sort(keyed.begin(), keyed.end());
        std::vector<int32_t> order;
        for (const auto& k : keyed)
            order.push_back(k.second);
        return order;
    }

    void gather(int32_t v)
    {
        star_.gather(c_, tets_of_, v);
        const double reach = reach_of();
        near_.clear();
        for (const int32_t e : star_.edges) {
            const CutEdge& edge = c_.edges[static_cast<size_t>(e)];
            const Vec3 x = c_.cut_point(edge);
            const double distance = (x - c_.point(v)).norm();
            if (distance <= reach)
                near_.push_back({distance, x, e, edge.lower == v ? edge.upper : edge.lower});
        }
        std::sort(near_.begin(), near_.end(), [](const NearCut& a, const NearCut& b) {
            return a.distance != b.distance ? a.distance < b.distance : a.edge < b.edge;
        });
        if (near_.size() > kMostCuts)
            near_.resize(kMostCuts);
    }

    // Half of the shortest edge; the safe rule of the paper: or of the shortest altitude.
    double reach_of() const
    {
        double length = star_.shortest_edge;
        if (rule_ == Snap::safe)
            for (const int32_t tet : star_.tets) {
                const Tet& t = c_.corners(tet);
                const auto i = static_cast<size_t>(std::find(t.begin(), t.end(), star_.vertex) - t.begin());
                const Vec3& a = c_.point(t[static_cast<size_t>(kFaceCorners[i][0])]);
                const Vec3 normal = (c_.point(t[static_cast<size_t>(kFaceCorners[i][1])]) - a)
                                        .cross(c_.point(t[static_cast<size_t>(kFaceCorners[i][2])]) - a)
                                        .normalized();
                length = std::min(length, std::abs(normal.dot(c_.point(star_.vertex) - a)));
            }
        return kReach * length;
    }

    void visit(int32_t v)
    {
        touched_[static_cast<size_t>(v)] = 0;
        gather(v);
        if (near_.empty())
            return;
        before_.save(c_, star_);
        shape_before_ = measure_star(c_, star_, std::numeric_limits<double>::infinity());
        best_cost_ = rule_ == Snap::quality ? shape_before_.cost : std::numeric_limits<double>::infinity();
        best_is_stay_ = false;
        tried_.clear();
        bool found = false;
        if (rule_ == Snap::quality) {
            for (size_t i = 0; i < near_.size(); ++i) {
                found |= attempt({i, i});
                if (i > 0)
                    found |= attempt({0, i});
            }
        } else {
            found = attempt({0, near_.size() - 1}) || attempt({0, 0});
        }
        if (!found)
            return;
        best_.restore(c_, star_);
        ++(best_is_stay_ ? counts_.stayed : counts_.moved);
        for (const int32_t tet : star_.tets)
            for (const int32_t corner : c_.corners(tet))
                touched_[static_cast<size_t>(corner)] = 1;
        touched_[static_cast<size_t>(v)] = 1;
    }

    // Keeps the state in best_ if it is the best so far.
    bool attempt(const Choice& choice)
    {
        MaterialSet materials = before_.materials;
        Vec3 start(0, 0, 0);
        bool may_stay = true;
        for (size_t i = choice.first; i <= choice.last; ++i) {
            const NearCut& cut = near_[i];
            if (!materials.unite(c_.materials_of(cut.other)))
                return false;
            start += cut.x;
            may_stay &= cut.distance <= kStay * (c_.point(cut.other) - before_.x).norm();
        }
        if (materials.size() > kMostMaterials || std::find(tried_.begin(), tried_.end(), materials) != tried_.end())
            return false;
        tried_.push_back(materials);
        start /= static_cast<double>(choice.last - choice.first + 1);
        const unsigned frozen = frozen_[static_cast<size_t>(star_.vertex)];
        const auto x =
            project_to_tie(c_.volume, before_.x, start, materials, frozen, kReach * star_.shortest_edge, scratch_);
        if (!x && !may_stay)
            return false;
        SampleStore::Span samples = before_.samples;
        if (x) {
            c_.volume.sample(*x, scratch_);
            samples = c_.samples.add(scratch_);
        }
        change_vertex(c_, star_, x ? *x : before_.x, materials, samples, scratch_);
        const StarShape shape = measure_star(c_, star_, best_cost_);
        const bool warped =
            shape.least_background < kLeastSine && shape.least_background < shape_before_.least_background;
        const bool better = shape.cost < best_cost_ && !warped;
        if (better) {
            best_cost_ = shape.cost;
            best_is_stay_ = !x;
            best_.save(c_, star_);
        } else if (x) {
            c_.samples.drop(samples);
        }
        before_.restore(c_, star_);
        return better;
    }

    Centres& c_;
    const std::vector<uint8_t>& frozen_;
    const Snap rule_;
    const Run& run_;
    const VertexTets tets_of_;
    std::vector<uint8_t> touched_;  // by vertex: something in its star changed since its last visit
    SnapCounts counts_;

    // Of the vertex being visited.
    Star star_;
    std::vector<NearCut> near_;
    std::vector<MaterialSet> tried_;
    StarState before_, best_;
    StarShape shape_before_;
    double best_cost_ = 0;
    bool best_is_stay_ = false;
    Samples scratch_;
};

}  // namespace

SnapCounts snap_vertices(Centres& c, const std::vector<uint8_t>& frozen, Snap rule, const Run& run)
{
    if (rule == Snap::none)
        return {};
    return Snapper(c, frozen, rule, run).run();
}

}  // namespace cleft
