// Points of any kind to the Delaunay engine: a refusal with a sentence, or the Delaunay mesh, in bricks of any size the
// same.
#include "delaunay/engines.hpp"
#include "fuzz/bytes.hpp"
#include "fuzz/judge.hpp"

#include <cmath>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

using cleft::Array;
using cleft::Tet;
using cleft::Vec3;
using fuzz::Bytes;

// One form for all points of an input: places of a small lattice, which share spheres and planes, places that nearly
// do, or any doubles.
double coordinate(Bytes& bytes, int form)
{
    switch (form) {
        case 0:
            return bytes.below(5);
        case 1:
            return bytes.below(4) + std::ldexp(bytes.below(3) - 1, -10 * bytes.below(8));
        case 2:
            return bytes.between(-1, 1);
        case 3:
            return std::ldexp(bytes.between(-1, 1), -bytes.below(256));
        default:
            return bytes.any<double>();
    }
}

Array<Vec3> points_of(Bytes& bytes)
{
    constexpr size_t kMost = 120;
    const int form = bytes.below(5);
    const bool in_a_plane = bytes.one_in(8);
    Array<Vec3> points;
    while (bytes.are_left() && points.size() < kMost) {
        Vec3 p;
        for (double& x : p)
            x = coordinate(bytes, form);
        points.push_back(in_a_plane && !points.empty() ? Vec3(p[0], p[1], points[0][2]) : p);
    }
    return points;
}

bool is_refusal(cleft_status status) { return status == CLEFT_ERROR_ARGUMENT || status == CLEFT_ERROR_NOT_FINITE; }

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const int64_t brick = 2 + bytes.below(20);
    Array<Vec3> points = points_of(bytes);
    try {
        const Array<Tet> tets = cleft::delaunay(points, cleft::DelaunayEngine::cleft, cleft::Run{});
        // As the engine scales them: the least coordinates may be rounded.
        double greatest = 0;
        for (const Vec3& p : points)
            greatest = std::max(greatest, p.cwiseAbs().maxCoeff());
        for (Vec3& p : points)
            p *= std::ldexp(1.0, -std::ilogb(greatest));
        fuzz::expect(cleft_test::is_delaunay(points, tets), "the mesh is not Delaunay");
        fuzz::expect(cleft_test::in_bricks(points, brick) == tets, "bricks give another mesh");
    } catch (const cleft::Error& error) {
        fuzz::expect(is_refusal(error.status()), error.what());
        fuzz::expect(fuzz::is_line(error.what()), "no sentence");
    }
    return 0;
}
