// Checks the tetrahedra of a mesh one by one: their indices, and their orientation by the exact predicate.
#include "checking/check_tets.hpp"

#include "base/parallel.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/predicates.hpp"
#include "mesh/quality.hpp"

namespace cleft
{

namespace
{

// Tetrahedra per chunk. Volumes are added chunk by chunk, so another number would change the sum in its last digits.
constexpr int64_t kTetsChecked = 4096;
// Relative to the tetrahedron, so that the unit of length does not matter. At this volume rounding leaves about four
// digits, and solvers divide by it. Cleaving keeps twice this distance (cleaving/flat_cuts.cpp).
constexpr double kFlatVolume = 1e-12;  // of the cube of its mean edge

FixedArray<Vec3, 4> corners_of(const RegionMesh& mesh, int64_t t)
{
    FixedArray<Vec3, 4> x;
    for (size_t i = 0; i < 4; ++i)
        x[i] = mesh.points[mesh.tets[t][i]];
    return x;
}

double sum_of_edges(const FixedArray<Vec3, 4>& x)
{
    double sum = 0;
    for (const auto& e : kEdgeCorners)
        sum += (x[e[1]] - x[e[0]]).norm();
    return sum;
}

// The parts of measure(t, part) over all tetrahedra, joined in their order.
template <class Measure>
TetChecks over_tets(const RegionMesh& mesh, const Run& run, const Measure& measure)
{
    const auto count = mesh.tets.count();
    Array<TetChecks> parts(chunk_count(count, kTetsChecked));
    parallel_chunks(run, count, kTetsChecked, [&](int64_t chunk, int64_t begin, int64_t end) {
        for (int64_t t = begin; t < end; ++t)
            measure(t, parts[chunk]);
    });
    TetChecks whole;
    for (const TetChecks& part : parts) {
        whole.bad_index.append(part.bad_index);
        whole.repeated_corner.append(part.repeated_corner);
        whole.negative.append(part.negative);
        whole.flat.append(part.flat);
        whole.volume += part.volume;
    }
    return whole;
}

void check_tet(const RegionMesh& mesh, int64_t t, Sign& sign, TetChecks& part)
{
    const auto place = static_cast<int64_t>(t);
    if (has_bad_index(mesh.tets[t], mesh.points.count()))
        return part.bad_index.add(place);
    if (has_repeated_corner(mesh.tets[t]))
        // No return here: such a tetrahedron has no volume, and counts as flat too.
        part.repeated_corner.add(place);
    const FixedArray<Vec3, 4> x = corners_of(mesh, t);
    if (!std::all_of(x.begin(), x.end(), [](const Vec3& v) { return v.allFinite(); }))
        return;
    // The sign of the rounded volume can be wrong for slivers.
    sign = static_cast<Sign>(orient_sign(x[0], x[1], x[2], x[3]));
    const double volume = orient(x[0], x[1], x[2], x[3]) / 6, mean_edge = sum_of_edges(x) / 6;
    part.volume += volume;
    if (sign == Sign::flat || std::abs(volume) <= kFlatVolume * mean_edge * mean_edge * mean_edge)
        part.flat.add(place);
    else if (sign == Sign::negative)
        part.negative.add(place);
}

}  // namespace

TetChecks check_tets(const RegionMesh& mesh, const Run& run)
{
    Array<Sign> sign(mesh.tets.size(), Sign::unknown);
    TetChecks out = over_tets(mesh, run, [&](int64_t t, TetChecks& part) { check_tet(mesh, t, sign[t], part); });
    out.sign = std::move(sign);
    return out;
}

}  // namespace cleft
