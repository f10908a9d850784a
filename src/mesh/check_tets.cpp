#include "base/parallel.hpp"
#include "mesh/checks.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace cleft
{

namespace
{

constexpr int64_t kTetsChecked = 4096;
constexpr double kFlatVolume = 1e-12;  // of the cube of the mean edge

std::array<Vec3, 4> corners_of(const LabelledMesh& mesh, size_t t)
{
    std::array<Vec3, 4> x;
    for (size_t i = 0; i < 4; ++i)
        x[i] = mesh.points[static_cast<size_t>(mesh.tets[t][i])];
    return x;
}

double sum_of_edges(const std::array<Vec3, 4>& x)
{
    double sum = 0;
    for (const auto& e : kEdgeCorners)
        sum += (x[static_cast<size_t>(e[1])] - x[static_cast<size_t>(e[0])]).norm();
    return sum;
}

struct TetsPart {
    TetChecks checks;
    double edges = 0;
    int64_t measured = 0;
};

// The parts of measure(t, part) over all tetrahedra, joined in their order.
template <class Measure>
TetsPart over_tets(const LabelledMesh& mesh, const Run& run, const Measure& measure)
{
    const auto count = static_cast<int64_t>(mesh.tets.size());
    std::vector<TetsPart> parts(static_cast<size_t>(chunk_count(count, kTetsChecked)));
    parallel_chunks(run, count, kTetsChecked, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            measure(static_cast<size_t>(t), parts[static_cast<size_t>(chunk)]);
    });
    TetsPart whole;
    for (const TetsPart& part : parts) {
        whole.checks.bad_index.append(part.checks.bad_index);
        whole.checks.repeated_corner.append(part.checks.repeated_corner);
        whole.checks.negative.append(part.checks.negative);
        whole.checks.flat.append(part.checks.flat);
        whole.checks.volume += part.checks.volume;
        whole.edges += part.edges;
        whole.measured += part.measured;
    }
    return whole;
}

// Signs, bad indices, repeated corners and edges.
TetsPart check_corners(const LabelledMesh& mesh, std::vector<Sign>& sign, const Run& run)
{
    const auto point_count = static_cast<int64_t>(mesh.points.size());
    return over_tets(mesh, run, [&](size_t t, TetsPart& part) {
        const auto place = static_cast<int64_t>(t);
        if (has_bad_index(mesh.tets[t], point_count))
            return part.checks.bad_index.add(place);
        if (has_repeated_corner(mesh.tets[t]))
            part.checks.repeated_corner.add(place);
        const std::array<Vec3, 4> x = corners_of(mesh, t);
        if (!std::all_of(x.begin(), x.end(), [](const Vec3& v) { return v.allFinite(); }))
            return;
        sign[t] = static_cast<Sign>(orient_sign(x[0], x[1], x[2], x[3]));
        part.edges += sum_of_edges(x);
        ++part.measured;
    });
}

TetsPart check_volumes(const LabelledMesh& mesh, const std::vector<Sign>& sign, double flat_volume, const Run& run)
{
    return over_tets(mesh, run, [&](size_t t, TetsPart& part) {
        if (sign[t] == Sign::unknown)
            return;
        const std::array<Vec3, 4> x = corners_of(mesh, t);
        const double volume = orient(x[0], x[1], x[2], x[3]) / 6;
        part.checks.volume += volume;
        if (sign[t] == Sign::flat || std::abs(volume) <= flat_volume)
            part.checks.flat.add(static_cast<int64_t>(t));
        else if (sign[t] == Sign::negative)
            part.checks.negative.add(static_cast<int64_t>(t));
    });
}

}  // namespace

TetChecks check_tets(const LabelledMesh& mesh, const Run& run)
{
    std::vector<Sign> sign(mesh.tets.size(), Sign::unknown);
    const TetsPart corners = check_corners(mesh, sign, run);
    const double mean_edge = corners.measured ? corners.edges / (6 * static_cast<double>(corners.measured)) : 0;
    const TetsPart volumes = check_volumes(mesh, sign, kFlatVolume * mean_edge * mean_edge * mean_edge, run);

    TetChecks out = volumes.checks;
    out.bad_index = corners.checks.bad_index;
    out.repeated_corner = corners.checks.repeated_corner;
    out.sign = std::move(sign);
    return out;
}

}  // namespace cleft
