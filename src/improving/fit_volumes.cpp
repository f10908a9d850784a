#include "improving/fit_volumes.hpp"

#include "base/parallel.hpp"
#include "base/stage_timer.hpp"
#include "improving/material_offsets.hpp"
#include "improving/settle_lines.hpp"
#include "mesh/adjacency.hpp"
#include "mesh/smoothing.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
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
constexpr double kCentroidShare = 0.75;
// Fields of a user's own say where surfaces are to a small part of a voxel: there points give up so much less of their
// place, in the least voxel spacing, but keep no more than this share of a height, which vanishes with the edge length.
constexpr double kSlackOfFields = 0.0105;
constexpr double kSlackShare = 0.4;
// Smaller moves are not worth their price, in lengths of the root of the area around.
constexpr double kLeastMove = 2e-3;
// Later rounds make good at neighbours what a point could not give.
constexpr int kRounds = 3;
// More rounds while a label of so many voxels is off by more than this share: one that is hardly thicker than the steps
// of its interface comes close by and by.
constexpr int kMostRounds = 8;
constexpr int64_t kLargeLabel = 1000;
constexpr double kTolerance = 0.003;
// Directions in which the triangles at a point ask for less than this share of what they ask in the strongest are along
// the interface.
constexpr double kLeastShare = 0.2;
// A point that cannot go further than this share of its way stays.
constexpr double kLeastGrant = 0.1;
// Interfaces of label maps go no further beyond the tie than this, in the least voxel spacing.
constexpr double kMostOffset = 0.2;
constexpr int64_t kGrain = 2048;
constexpr int32_t kTetsACheck = 1 << 16;
constexpr size_t kPointsACheck = 1 << 12;  // between two looks for a cancel

constexpr Material kNone = -1, kSeveral = -2;

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

// A triangle of an interface; its corners wind so that the normal looks from the first material to the second.
struct InterfaceTriangle {
    std::array<int32_t, 3> corners;
    std::array<Material, 2> pair;  // ascending
    double height = 0;             // mean height of the tie above the triangle as it was found
    double offset = 0;             // beyond the tie, for the volumes of the labels
};

// Only tetrahedra with three points of interfaces can have a triangle in one.
std::vector<InterfaceTriangle> find_triangles(const LocalMesh& mesh, const Run& run)
{
    std::vector<Material> only(static_cast<size_t>(mesh.point_count()), kNone);
    for (int32_t t = 0; t < mesh.slot_count(); ++t)
        for (const int32_t v : mesh.tet(t)) {
            Material& m = only[static_cast<size_t>(v)];
            m = m == kNone || m == mesh.material(t) ? mesh.material(t) : kSeveral;
        }
    std::vector<InterfaceTriangle> triangles;
    triangles.reserve(static_cast<size_t>(mesh.slot_count()) / 8);
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        if (t % kTetsACheck == 0)
            run.report(0.2 * t / mesh.slot_count(), "fitting volumes");
        const Tet& corners = mesh.tet(t);
        for (int face = 0; face < 4; ++face) {
            const auto& f = kFaceCorners[face];
            const std::array<int32_t, 3> points{corners[static_cast<size_t>(f[0])], corners[static_cast<size_t>(f[1])],
                                                corners[static_cast<size_t>(f[2])]};
            if (std::any_of(points.begin(), points.end(),
                            [&](int32_t v) { return only[static_cast<size_t>(v)] != kSeveral; }))
                continue;
            const int32_t behind = mesh.neighbour(t, face);
            if (behind >= 0 && mesh.material(t) < mesh.material(behind))
                triangles.push_back({points, {mesh.material(t), mesh.material(behind)}});
        }
    }
    return triangles;
}

// A quadratic function that is zero at the corners has 3/4 of its value at the centroid as its mean over the triangle.
void find_heights(const LocalMesh& mesh, const Volume& volume, std::vector<InterfaceTriangle>& triangles,
                  const Run& run)
{
    const double step = kStep * volume.grid().spacing.minCoeff();
    const double slack = volume.is_label_map() ? 0 : kSlackOfFields * volume.grid().spacing.minCoeff();
    parallel_for(run, static_cast<int64_t>(triangles.size()), kGrain, [&](int64_t begin, int64_t end) {
        Samples samples;
        for (auto i = static_cast<size_t>(begin); i < static_cast<size_t>(end); ++i) {
            InterfaceTriangle& t = triangles[i];
            const Vec3 &a = mesh.point(t.corners[0]), &b = mesh.point(t.corners[1]), &c = mesh.point(t.corners[2]);
            const Vec3 normal = (b - a).cross(c - a).normalized();
            const double edge =
                std::sqrt(std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()}));
            const double height =
                kCentroidShare * height_of_tie(volume, (a + b + c) / 3, normal, t.pair, kReach * edge, step, samples);
            t.height = height - std::copysign(std::min(slack, kSlackShare * std::abs(height)), height);
        }
    });
}

// What the triangles at a point ask of it: to move by their heights along their normals.
struct Wish {
    Mat3 normals = Mat3::Zero();  // sum of area n n^T
    Vec3 heights = Vec3::Zero();  // sum of area height n
    double area = 0;
};

// A point of interfaces, and how far it has been moved from its place on the tie.
struct InterfacePoint {
    int32_t number;
    Vec3 moved{0, 0, 0};
};

// Numbers the corners of the triangles among themselves.
std::vector<InterfacePoint> find_points(const LocalMesh& mesh, std::vector<InterfaceTriangle>& triangles)
{
    std::vector<int32_t> index(static_cast<size_t>(mesh.point_count()), 0);
    for (const InterfaceTriangle& t : triangles)
        for (const int32_t v : t.corners)
            index[static_cast<size_t>(v)] = 1;
    std::vector<InterfacePoint> points;
    for (int32_t v = 0; v < mesh.point_count(); ++v)
        if (index[static_cast<size_t>(v)] == 1) {
            index[static_cast<size_t>(v)] = static_cast<int32_t>(points.size());
            points.push_back({v});
        }
    for (InterfaceTriangle& t : triangles)
        for (int32_t& v : t.corners)
            v = index[static_cast<size_t>(v)];
    return points;
}

std::vector<Wish> wishes(const LocalMesh& mesh, const std::vector<InterfaceTriangle>& triangles,
                         const std::vector<InterfacePoint>& points)
{
    std::vector<Wish> out(points.size());
    const auto place = [&](int32_t i) -> const Vec3& { return mesh.point(points[static_cast<size_t>(i)].number); };
    for (const InterfaceTriangle& t : triangles) {
        const Vec3& a = place(t.corners[0]);
        const Vec3 twice = (place(t.corners[1]) - a).cross(place(t.corners[2]) - a);
        const double area = 0.5 * twice.norm();
        const Vec3 normal = twice.normalized();
        double height = t.height + t.offset;
        for (const int32_t v : t.corners)
            height -= points[static_cast<size_t>(v)].moved.dot(normal) / 3;
        for (const int32_t v : t.corners) {
            Wish& wish = out[static_cast<size_t>(v)];
            wish.normals += area * normal * normal.transpose();
            wish.heights += area * height * normal;
            wish.area += area;
        }
    }
    return out;
}

std::vector<double> material_volumes(const LocalMesh& mesh, size_t materials)
{
    std::vector<double> volumes(materials, 0);
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        const Tet& c = mesh.tet(t);
        const Vec3& a = mesh.point(c[0]);
        const Vec3 ab = mesh.point(c[1]) - a, ac = mesh.point(c[2]) - a, ad = mesh.point(c[3]) - a;
        volumes[static_cast<size_t>(mesh.material(t))] += ab.cross(ac).dot(ad) / 6;
    }
    return volumes;
}

// What each label lacks of the volume of its voxels. `voxels` is empty for fields, of which nothing is known.
std::vector<double> missing_volumes(const LocalMesh& mesh, const std::vector<int64_t>& voxels, double voxel)
{
    if (voxels.empty())
        return {};
    std::vector<double> missing = material_volumes(mesh, voxels.size());
    for (size_t m = 0; m < voxels.size(); ++m)
        missing[m] = static_cast<double>(voxels[m]) * voxel - missing[m];
    return missing;
}

bool is_large_label_off(const std::vector<double>& missing, const std::vector<int64_t>& voxels, double voxel)
{
    for (size_t m = 0; m < missing.size(); ++m)
        if (voxels[m] > kLargeLabel && std::abs(missing[m]) > kTolerance * (static_cast<double>(voxels[m]) * voxel))
            return true;
    return false;
}

// Adds to the offsets of the triangles what the labels miss. The heights are counted as granted in the first round;
// later, what has not been granted will hardly be.
void add_offsets(const LocalMesh& mesh, std::vector<double> missing, const Vec3& spacing,
                 const std::vector<InterfacePoint>& points, bool first, std::vector<InterfaceTriangle>& triangles)
{
    std::vector<Contact> contacts;
    contacts.reserve(triangles.size());
    const auto place = [&](int32_t i) -> const Vec3& { return mesh.point(points[static_cast<size_t>(i)].number); };
    for (const InterfaceTriangle& t : triangles) {
        const Vec3& a = place(t.corners[0]);
        const double area = 0.5 * (place(t.corners[1]) - a).cross(place(t.corners[2]) - a).norm();
        contacts.push_back({t.pair[0], t.pair[1], area});
        if (first) {
            missing[static_cast<size_t>(t.pair[0])] -= area * t.height;
            missing[static_cast<size_t>(t.pair[1])] += area * t.height;
        }
    }
    const std::vector<double> offsets = material_offsets(contacts, missing);
    const double most = kMostOffset * spacing.minCoeff();
    for (InterfaceTriangle& t : triangles) {
        const double more = offsets[static_cast<size_t>(t.pair[0])] - offsets[static_cast<size_t>(t.pair[1])];
        t.offset = std::clamp(t.offset + more, -most, most);
    }
}

// Where a point is to go, and along which directions it may slide without breaking the wish.
struct Move {
    Vec3 shift{0, 0, 0};
    Mat3 along = Mat3::Zero();
};

// The shortest move that grants the wish best (least squares), along the free axes: one direction on a smooth
// interface, two on a line where interfaces meet, three in a corner. No shift if it is not worth while.
Move move_of(const Wish& wish, uint8_t frozen)
{
    Move move;
    if (wish.heights.squaredNorm() < kLeastMove * kLeastMove * wish.area * wish.area * wish.area)
        return move;
    const Mat3 free = free_axes(frozen);
    Eigen::SelfAdjointEigenSolver<Mat3> eigen;
    eigen.computeDirect(free * wish.normals * free);
    const double strongest = eigen.eigenvalues()[2];
    if (!(strongest > kLeastShare * wish.area))  // across the wall
        return move;
    move.along = free;
    for (int i = 0; i < 3; ++i)
        if (eigen.eigenvalues()[i] > kLeastShare * strongest) {
            const Vec3 direction = free * eigen.eigenvectors().col(i);
            move.shift += direction.dot(wish.heights) / eigen.eigenvalues()[i] * direction;
            move.along -= direction * direction.transpose();
        }
    return move;
}

// A place for a point, and the share of its move that it has there.
struct Granted {
    Vec3 x;
    double share;
};

class Granter
{
public:
    Granter(LocalMesh& mesh, double floor) : mesh_(mesh), floor_(floor) {}

    // Moves points one after the other, as far as the shapes around allow. Returns the number that could not move.
    int64_t grant(const std::vector<Wish>& wanted, std::vector<InterfacePoint>& points, const Run& run);

private:
    Granted place_for(int32_t v, const Move& move);

    LocalMesh& mesh_;
    const double floor_;
    TetStar star_;
    Smoother smoother_;
};

int64_t Granter::grant(const std::vector<Wish>& wanted, std::vector<InterfacePoint>& points, const Run& run)
{
    int64_t held = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        if (i % kPointsACheck == 0)
            run.check();
        const int32_t v = points[i].number;
        const Move move = move_of(wanted[i], mesh_.frozen(v));
        if (move.shift.isZero(0))
            continue;
        const Granted granted = place_for(v, move);
        if (granted.share > 0) {
            mesh_.move(v, granted.x);
            points[i].moved += granted.share * move.shift;
        } else
            ++held;
    }
    return held;
}

// All of the move, or a half, a quarter ...; where the place itself is bad, there may be a good one beside it along the
// interface.
Granted Granter::place_for(int32_t v, const Move& move)
{
    star_.load(mesh_, v);
    const Vec3 from = mesh_.point(v);
    if (star_.worst_at(from + move.shift, floor_) > floor_)
        return {from + move.shift, 1};
    const double least = std::min(floor_, star_.worst_at(from, -1));
    for (double share = 1; least > 0 && share > kLeastGrant; share *= 0.5) {
        const Place place = smoother_.climb(star_, from + share * move.shift, least, move.along, {});
        if (place.worst >= least)
            return {place.x, share};
    }
    return {from, 0};
}

}  // namespace

void fit_volumes(LabelledMesh& mesh, const Volume& volume, double least_angle, const Run& run)
{
    if (volume.material_count() < 2)
        return;
    const StageTimer timer(run, "fitting");
    run.report(0, "fitting volumes");
    LocalMesh local(std::move(mesh.points), std::move(mesh.tets), std::move(mesh.material), run);
    const double floor = std::sin(least_angle * M_PI / 180);
    run.note("fitting.off_lines", static_cast<double>(settle_lines(local, volume, floor, run)));
    std::vector<InterfaceTriangle> triangles = find_triangles(local, run);
    run.report(0.3, "fitting volumes");
    find_heights(local, volume, triangles, run);
    std::vector<InterfacePoint> points = find_points(local, triangles);
    Granter granter(local, floor);
    const std::vector<int64_t> voxels = volume.is_label_map() ? volume.voxel_counts() : std::vector<int64_t>();
    const Vec3 spacing = volume.grid().spacing;
    for (int round = 0; round < kMostRounds; ++round) {
        const std::vector<double> missing = missing_volumes(local, voxels, spacing.prod());
        if (round >= kRounds && !is_large_label_off(missing, voxels, spacing.prod()))
            break;
        run.report(0.6 + 0.4 * round / kMostRounds, "fitting volumes");
        if (volume.is_label_map())
            add_offsets(local, missing, spacing, points, round == 0, triangles);
        const int64_t held = granter.grant(wishes(local, triangles, points), points, run);
        run.note("fitting.held", static_cast<double>(held));
    }
    mesh = local.take();
}

}  // namespace cleft
