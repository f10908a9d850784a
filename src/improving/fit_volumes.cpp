#include "improving/fit_volumes.hpp"

#include "base/parallel.hpp"
#include "base/stage_timer.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/interfaces.hpp"
#include "mesh/smoothing.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// The interface is looked for within this share of a triangle's longest edge: a chord of length h on a sphere of radius
// h lies h / 6 below it.
constexpr double kReach = 0.3;
// Steps of the search, in the least voxel spacing: label indicators are flat further away than that.
constexpr double kStep = 0.4;
constexpr double kCentroidShare = 0.75, kCornerShare = 1 / 12.0;
// The second round makes good what the guard of the first held back at a neighbour.
constexpr int kRounds = 2;
constexpr int64_t kGrain = 2048;

// By how much the first material of a pair leads the second at a point; not ok if a third one wins there.
struct Lead {
    double difference;
    bool ok;
};

Lead side_at(const Volume& volume, const Vec3& x, const std::array<Material, 2>& pair, Samples& samples)
{
    volume.sample(x, samples);
    const Material best = samples.material[samples.best()];
    const auto value = [&](Material m) {
        const int at = samples.find(m);
        return at < 0 ? 0.0 : samples.value[static_cast<size_t>(at)];
    };
    return {value(pair[0]) - value(pair[1]), best == pair[0] || best == pair[1]};
}

// Where the tie of the pair lies on the line from x along the unit normal (which looks from the first material to the
// second): positive if beyond x. 0 if it is not met within `reach`.
double height_of_tie(const Volume& volume, const Vec3& x, const Vec3& normal, const std::array<Material, 2>& pair,
                     double reach, double step, Samples& samples)
{
    Lead near = side_at(volume, x, pair, samples);
    if (!near.ok || near.difference == 0)
        return 0;
    const double direction = near.difference > 0 ? 1 : -1;
    double at = 0;
    while (at < reach) {
        const double next = std::min(reach, at + step);
        const Lead far = side_at(volume, x + direction * next * normal, pair, samples);
        if (!far.ok)
            return 0;
        if (far.difference * near.difference <= 0) {
            const double share = near.difference / (near.difference - far.difference);
            return direction * (at + share * (next - at));
        }
        at = next;
        near = far;
    }
    return 0;
}

// What the triangles at a point ask of it.
struct Wish {
    Vec3 normal = Vec3::Zero();  // sum of area normals
    double height = 0;           // sum of area times mean height
    double area = 0;
    int32_t pair = -1;  // of its triangles; -2: of several pairs
};

// Mean height of the interface above each triangle. `offset`: how far each point was moved off the tie before.
// A quadratic function has the mean  3/4 centroid + 1/12 sum of corners  over a triangle.
std::vector<double> mean_heights(const LocalMesh& mesh, const Interfaces& interfaces, const std::vector<double>& offset,
                                 const Volume& volume, const Run& run)
{
    const double step = kStep * volume.grid().spacing.minCoeff();
    std::vector<double> heights(interfaces.triangles.size());
    parallel_for(run, static_cast<int64_t>(heights.size()), kGrain, [&](int64_t begin, int64_t end) {
        Samples samples;
        for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
            const Triangle& t = interfaces.triangles[i];
            const Vec3& a = mesh.point(t[0]);
            const Vec3& b = mesh.point(t[1]);
            const Vec3& c = mesh.point(t[2]);
            const Vec3 normal = (b - a).cross(c - a).normalized();
            const double edge =
                std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
            heights[i] = kCentroidShare * height_of_tie(volume, (a + b + c) / 3, normal, interfaces.pairs[i],
                                                        kReach * edge, step, samples);
            for (const int32_t v : t)
                heights[i] -= kCornerShare * offset[static_cast<size_t>(v)];
        }
    });
    return heights;
}

std::vector<Wish> wishes(const LocalMesh& mesh, const Interfaces& interfaces, const std::vector<double>& heights)
{
    std::vector<Wish> out(static_cast<size_t>(mesh.point_count()));
    int32_t pair = -1;
    for (size_t i = 0; i < interfaces.triangles.size(); ++i) {
        if (i == 0 || interfaces.pairs[i] != interfaces.pairs[i - 1])
            ++pair;  // triangles come sorted by pair
        const Triangle& t = interfaces.triangles[i];
        const Vec3& a = mesh.point(t[0]);
        const Vec3 normal = 0.5 * (mesh.point(t[1]) - a).cross(mesh.point(t[2]) - a);
        for (const int32_t v : t) {
            Wish& wish = out[static_cast<size_t>(v)];
            wish.normal += normal;
            wish.area += normal.norm();
            wish.height += normal.norm() * heights[i];
            wish.pair = wish.pair == -1 || wish.pair == pair ? pair : -2;
        }
    }
    return out;
}

// The move that gives the wish along the free axes; zero where there is none.
Vec3 move_of(const Wish& wish, uint8_t frozen)
{
    if (wish.pair < 0 || wish.area <= 0 || wish.normal.norm() < 0.5 * wish.area)  // a fold or a cone has no normal
        return Vec3::Zero();
    Vec3 along = wish.normal.normalized();
    for (int axis = 0; axis < 3; ++axis)
        if (frozen >> axis & 1)
            along[axis] = 0;
    const double free = along.squaredNorm();
    return free < 0.25 ? Vec3(Vec3::Zero()) : Vec3(along * (wish.height / wish.area / free));
}

// Moves points one after the other, as far as the shapes around allow. Returns the number that could not move.
int64_t grant(const std::vector<Wish>& wanted, double floor, LocalMesh& mesh, std::vector<double>& offset,
              const Run& run)
{
    Star star;
    int64_t held = 0;
    for (int32_t v = 0; v < mesh.point_count(); ++v) {
        if (v % 4096 == 0)
            run.check();
        const Wish& wish = wanted[static_cast<size_t>(v)];
        const Vec3 move = move_of(wish, mesh.frozen(v));
        if (move.isZero(0))
            continue;
        star.load(mesh, v);
        const Vec3 from = mesh.point(v);
        const double allowed = std::min(floor, star.worst_at(from, -1));
        double share = allowed > 0 ? 1 : 0;
        while (share > 0.2 && star.worst_at(from + share * move, -1) < allowed)
            share *= 0.5;
        if (share <= 0.2) {
            ++held;
            continue;
        }
        mesh.move(v, from + share * move);
        offset[static_cast<size_t>(v)] += share * move.dot(wish.normal.normalized());
    }
    return held;
}

}  // namespace

void fit_volumes(LabelledMesh& mesh, const Volume& volume, double least_angle, const Run& run)
{
    if (volume.material_count() < 2)
        return;
    const StageTimer timer(run, "fitting");
    run.report(0, "fitting volumes");
    // Sides of the box do not matter here: frozen axes hold the points of the hull.
    const Interfaces interfaces = extract_interfaces(mesh, Vec3::Zero(), volume.grid().extent(), run);
    LocalMesh local(std::move(mesh.points), std::move(mesh.tets), std::move(mesh.material));
    std::vector<double> offset(static_cast<size_t>(local.point_count()), 0.0);
    for (int round = 0; round < kRounds; ++round) {
        run.report(0.3 + 0.3 * round, "fitting volumes");
        const std::vector<double> heights = mean_heights(local, interfaces, offset, volume, run);
        const int64_t held =
            grant(wishes(local, interfaces, heights), std::sin(least_angle * M_PI / 180), local, offset, run);
        run.note("fitting.held", static_cast<double>(held));
    }
    mesh = local.take();
}

}  // namespace cleft
