#include "fitting/fit_volumes.hpp"

#include "base/degrees.hpp"
#include "base/stage.hpp"
#include "fitting/interface_triangles.hpp"
#include "fitting/material_offsets.hpp"
#include "fitting/relocate_gaps.hpp"
#include "fitting/relocate_lines.hpp"
#include "mesh/materials.hpp"
#include "remeshing/smoothing.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>

namespace cleft
{

namespace
{

// Smaller moves are not worth their price, in lengths of the root of the area around.
constexpr double kLeastMove = 2e-3;
// Later rounds make good at neighbours what a point could not give.
constexpr int kFitRounds = 3;
// More rounds while a label of so many voxels is off by more than this share: one that is hardly thicker than the steps
// of its interface comes close by and by.
constexpr int kMostRounds = 8;
constexpr int64_t kLargeLabel = 1000;
constexpr double kTolerance = 0.003;
// And while one of more voxels than these, such as a shell, is off by this share.
constexpr int64_t kSmallLabel = 60;
constexpr double kWideTolerance = 0.03;
// Directions in which the triangles at a point ask for less than this share of what they ask in the strongest are along
// the interface.
constexpr double kLeastShare = 0.2;
// A point that cannot go further than this share of its way stays.
constexpr double kLeastGrant = 0.1;
// Interfaces of label maps go no further beyond the tie than this, in the least voxel spacing.
constexpr double kMostOffset = 0.2;
// And than this at a small label that is still off after the first rounds.
constexpr double kWideOffset = 0.45;

// What the triangles at a point ask of it: to move by their heights along their normals.
struct Wish {
    Mat3 normals = Mat3::Zero();  // sum of area n n^T
    Vec3 heights = Vec3::Zero();  // sum of area height n
    double area = 0;
};

// A point of interfaces, and how far it has been moved from its place on the tie.
struct FitPoint {
    int32_t number;
    bool stays = false;
    Vec3 moved{0, 0, 0};
};

// Numbers the corners of the triangles among themselves. Those of `astray`, which have no tie to be moved off, stay.
std::vector<FitPoint> find_points(const LocalMesh& mesh, const std::vector<int32_t>& astray,
                                  std::vector<InterfaceTriangle>& triangles)
{
    std::vector<int32_t> index(static_cast<size_t>(mesh.point_count()), 0);
    for (const InterfaceTriangle& t : triangles)
        for (const int32_t v : t.corners)
            index[static_cast<size_t>(v)] = 1;
    std::vector<FitPoint> points;
    for (int32_t v = 0; v < mesh.point_count(); ++v)
        if (index[static_cast<size_t>(v)] == 1) {
            index[static_cast<size_t>(v)] = static_cast<int32_t>(points.size());
            points.push_back({v});
        }
    for (InterfaceTriangle& t : triangles)
        for (int32_t& v : t.corners)
            v = index[static_cast<size_t>(v)];
    std::vector<int32_t> staying = astray;
    std::sort(staying.begin(), staying.end());
    for (FitPoint& p : points)
        p.stays = std::binary_search(staying.begin(), staying.end(), p.number);
    return points;
}

std::vector<Wish> wishes(const LocalMesh& mesh, const std::vector<InterfaceTriangle>& triangles,
                         const std::vector<FitPoint>& points)
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

// What each label lacks of the volume of its voxels. `voxels` is empty for fields, of which nothing is known.
std::vector<double> missing_volumes(const LocalMesh& mesh, const std::vector<int64_t>& voxels, double voxel)
{
    if (voxels.empty())
        return {};
    std::vector<double> missing =
        material_volumes(mesh.points(), mesh.tets(), mesh.materials(), static_cast<Material>(voxels.size()));
    for (size_t m = 0; m < voxels.size(); ++m)
        missing[m] = static_cast<double>(voxels[m]) * voxel - missing[m];
    return missing;
}

bool is_off(double missing, int64_t voxels, double voxel, int64_t least_voxels, double tolerance)
{
    return voxels > least_voxels && std::abs(missing) > tolerance * (static_cast<double>(voxels) * voxel);
}

bool is_any_off(const std::vector<double>& missing, const std::vector<int64_t>& voxels, double voxel)
{
    for (size_t m = 0; m < missing.size(); ++m)
        if (is_off(missing[m], voxels[m], voxel, kLargeLabel, kTolerance) ||
            is_off(missing[m], voxels[m], voxel, kSmallLabel, kWideTolerance))
            return true;
    return false;
}

// The pairs of materials that touch, each once, without areas.
std::vector<Contact> find_contacts(const std::vector<InterfaceTriangle>& triangles)
{
    std::vector<std::array<Material, 2>> pairs;
    for (const InterfaceTriangle& t : triangles)
        if (pairs.empty() || pairs.back() != t.pair)
            pairs.push_back(t.pair);
    std::sort(pairs.begin(), pairs.end());
    pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
    std::vector<Contact> contacts;
    for (const auto& pair : pairs)
        contacts.push_back({pair[0], pair[1], 0});
    return contacts;
}

Contact& contact_of(std::vector<Contact>& contacts, const std::array<Material, 2>& pair)
{
    return *std::lower_bound(contacts.begin(), contacts.end(), pair, [](const Contact& c, const auto& wanted) {
        return c.first != wanted[0] ? c.first < wanted[0] : c.second < wanted[1];
    });
}

// Adds to the offsets of the triangles what the labels miss. The heights are counted as granted in the first round;
// later, what has not been granted will hardly be.
void add_offsets(const LocalMesh& mesh, std::vector<double> missing, const std::vector<char>& wide, const Vec3& spacing,
                 const std::vector<FitPoint>& points, bool first, std::vector<Contact> contacts,
                 std::vector<InterfaceTriangle>& triangles)
{
    const auto place = [&](int32_t i) -> const Vec3& { return mesh.point(points[static_cast<size_t>(i)].number); };
    for (const InterfaceTriangle& t : triangles) {
        const Vec3& a = place(t.corners[0]);
        const double area = 0.5 * (place(t.corners[1]) - a).cross(place(t.corners[2]) - a).norm();
        contact_of(contacts, t.pair).area += area;
        if (first) {
            missing[static_cast<size_t>(t.pair[0])] -= area * t.height;
            missing[static_cast<size_t>(t.pair[1])] += area * t.height;
        }
    }
    const std::vector<double> offsets = material_offsets(contacts, missing);
    for (InterfaceTriangle& t : triangles) {
        const double more = offsets[static_cast<size_t>(t.pair[0])] - offsets[static_cast<size_t>(t.pair[1])];
        const bool is_wide = wide[static_cast<size_t>(t.pair[0])] || wide[static_cast<size_t>(t.pair[1])];
        const double most = (is_wide ? kWideOffset : kMostOffset) * spacing.minCoeff();
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
    // What materials gain is taken off `missing`, unless that is empty.
    int64_t grant(const std::vector<Wish>& wanted, std::vector<FitPoint>& points, std::vector<double>& missing,
                  const Run& run);

private:
    Granted place_for(int32_t v, const Move& move);
    void count_gains(const Vec3& shift, std::vector<double>& missing) const;

    LocalMesh& mesh_;
    const double floor_;
    TetStar star_;
    Smoother smoother_;
};

int64_t Granter::grant(const std::vector<Wish>& wanted, std::vector<FitPoint>& points, std::vector<double>& missing,
                       const Run& run)
{
    int64_t held = 0;
    for (size_t i = 0; i < points.size(); ++i) {
        run.check_at(i, 1 << 12);
        if (points[i].stays)
            continue;
        const int32_t v = points[i].number;
        const Move move = move_of(wanted[i], mesh_.frozen(v));
        if (move.shift.isZero(0))
            continue;
        const Granted granted = place_for(v, move);
        if (granted.share > 0) {
            if (!missing.empty())
                count_gains(granted.x - mesh_.point(v), missing);
            mesh_.move(v, granted.x);
            points[i].moved += granted.share * move.shift;
        } else
            ++held;
    }
    return held;
}

// Of the star that is loaded.
void Granter::count_gains(const Vec3& shift, std::vector<double>& missing) const
{
    for (size_t i = 0; i < star_.tets().size(); ++i)
        missing[static_cast<size_t>(mesh_.material(star_.tets()[i]))] -= star_.volume_change(i, shift);
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
        if (share < 1 && star_.worst_at(from + share * move.shift, least) > least)
            return {from + share * move.shift, share};
        const Place place = smoother_.climb(star_, from + share * move.shift, least, move.along, {});
        if (place.worst >= least)
            return {place.x, share};
    }
    return {from, 0};
}

// Points of interfaces that are off the tie go back to it. Returns those that have none; only fields of a user's own,
// which are exact, say that for sure.
std::vector<int32_t> settle(LocalMesh& mesh, const Volume& volume, double floor, const Meetings& meetings,
                            const Run& run)
{
    const LinePoints lines = settle_lines(mesh, volume, floor, meetings, run);
    run.note("fitting.off_lines", static_cast<double>(lines.off));
    if (volume.is_label_map())
        return {};
    const std::vector<int32_t> in_gaps =
        settle_gaps(mesh, volume, volume.voxel_counts(), floor, lines.without_tie, run);
    run.note("fitting.in_gaps", static_cast<double>(in_gaps.size()));
    return in_gaps;
}

}  // namespace

void fit_volumes(LocalMesh& mesh, const Volume& volume, double least_angle, const Run& run)
{
    if (volume.material_count() < 2)
        return;
    Stage stage(run, "fitting", {{"fitting: lines and gaps", 13}, {"fitting: heights", 24}, {"fitting: volumes", 63}});
    const Run of_places = stage.next();
    const double floor = sine_of(least_angle);
    const Meetings meetings = find_meetings(mesh, of_places);
    const std::vector<int32_t> astray = settle(mesh, volume, floor, meetings, of_places);
    const Run of_heights = stage.next();
    std::vector<InterfaceTriangle> triangles = find_triangles(mesh, meetings, of_heights);
    find_heights(mesh, volume, astray, triangles, of_heights);
    const Run of_volumes = stage.next();
    std::vector<FitPoint> points = find_points(mesh, astray, triangles);
    const std::vector<Contact> contacts = find_contacts(triangles);
    Granter granter(mesh, floor);
    const std::vector<int64_t> voxels = volume.is_label_map() ? volume.voxel_counts() : std::vector<int64_t>();
    const Vec3 spacing = volume.grid().spacing;
    std::vector<double> missing = missing_volumes(mesh, voxels, spacing.prod());
    std::vector<char> wide(missing.size(), 0);  // by material: its interfaces may go further beyond the tie
    for (int round = 0; round < kMostRounds; ++round) {
        if (round >= kFitRounds && !is_any_off(missing, voxels, spacing.prod()))
            break;
        of_volumes.report(static_cast<double>(round) / kMostRounds);
        if (round >= kFitRounds)
            for (size_t m = 0; m < wide.size(); ++m)
                wide[m] = wide[m] || is_off(missing[m], voxels[m], spacing.prod(), kSmallLabel, kWideTolerance);
        if (volume.is_label_map())
            add_offsets(mesh, missing, wide, spacing, points, round == 0, contacts, triangles);
        const int64_t held = granter.grant(wishes(mesh, triangles, points), points, missing, of_volumes);
        run.note("fitting.held", static_cast<double>(held));
    }
}

void fit_volumes(LabelledMesh& mesh, const Volume& volume, double least_angle, const Run& run)
{
    LocalMesh local(std::move(mesh), run);
    fit_volumes(local, volume, least_angle, run);
    mesh = local.take();
}

}  // namespace cleft
