// Moves points of lines back onto their tie, one after the other, as far as the tetrahedra around allow.
#include "fitting/relocate_lines.hpp"

#include "remeshing/smoothing.hpp"
#include "volume/tie.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Smaller moves are not worth their price, in lengths of the edges around.
// A smaller step would move nearly every point of a line, for less than half a hundredth of an edge.
constexpr double kLeastStep = 5e-3;
// The last share tried is an eighth. Less of the way would hardly bring the point nearer.
constexpr double kLeastStepShare = 0.1;
constexpr int kLineRounds = 3;  // a point that is in the way may have moved on

class LineRelocator
{
public:
    LineRelocator(LocalMesh& mesh, const Volume& volume, double floor) : mesh_(mesh), volume_(volume), floor_(floor) {}

    enum class Place { on_tie, off_tie, without_tie };

    Place relocate(int32_t v)
    {
        star_.load(mesh_, v);
        const auto materials = materials_of(star_.tets(), mesh_.materials());
        if (!materials)
            return Place::without_tie;
        const Vec3 from = mesh_.point(v);
        const double reach = star_.reach(from);
        const auto on_tie = project_to_tie(volume_, from, from, *materials, mesh_.frozen(v), reach, samples_);
        if (!on_tie)
            return Place::without_tie;
        if ((*on_tie - from).norm() < kLeastStep * reach)
            return Place::on_tie;
        const double least = std::min(floor_, star_.worst_at(from, -1));
        // Halves of the way: each needs one look at the star, and what is left comes in the next round.
        for (double share = 1; share > kLeastStepShare; share *= 0.5) {
            const Vec3 x = from + share * (*on_tie - from);
            if (star_.worst_at(x, least) > least) {
                mesh_.move(v, x);
                return share == 1 ? Place::on_tie : Place::off_tie;
            }
        }
        return Place::off_tie;
    }

private:
    LocalMesh& mesh_;
    const Volume& volume_;
    const double floor_;
    TetStar star_;
    Samples samples_;
};

}  // namespace

LinePoints relocate_lines(LocalMesh& mesh, const Volume& volume, double floor, const Meetings& meetings, const Run& run)
{
    LinePoints out;
    Array<int32_t> points;
    for (int32_t v = 0; v < mesh.point_count(); ++v)
        if (meetings[v] == Meeting::line)
            points.push_back(v);
    LineRelocator relocator(mesh, volume, floor);
    for (int round = 0; round < kLineRounds; ++round) {
        Array<int32_t> left;
        for (size_t i = 0; i < points.size(); ++i) {
            run.check_at(i, 1 << 8);
            const LineRelocator::Place place = relocator.relocate(points[i]);
            if (place == LineRelocator::Place::off_tie)
                left.push_back(points[i]);
            else if (place == LineRelocator::Place::without_tie)
                out.without_tie.push_back(points[i]);
        }
        points.swap(left);
    }
    out.off = points.count();
    return out;
}

}  // namespace cleft
