// STL and PLY of the surfaces inside the box: the interfaces, and the hull where it is in no side of the box.
#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/inner_surface.hpp"
#include "io/vector3.hpp"
#include "io/writers.hpp"

#include <array>
#include <cstring>

namespace cleft::io
{

namespace
{

Vector3 point(const MeshView& mesh, int32_t p)
{
    const double* x = mesh.points + 3 * int64_t{p};
    return {x[0], x[1], x[2]};
}

Vector3 unit_normal(const Vector3& a, const Vector3& b, const Vector3& c)
{
    const Vector3 normal = cross(minus(b, a), minus(c, a));
    // Readers of STL compute the normal anew where it is zero.
    return length(normal) > 0 ? times(1 / length(normal), normal) : Vector3{0, 0, 0};
}

}  // namespace

void write_stl(const MeshView& mesh, const std::string& path)
{
    const InnerSurface surface = inner_surface(mesh);
    // The count in the header has 32 bits.
    if (surface.count() > UINT32_MAX)
        throw Error(CLEFT_ERROR_TOO_LARGE, "too many triangles for an STL file");
    AtomicFile file(path);
    // A text that does not begin with "solid", by which readers know STL of text.
    std::array<char, 80> header{};
    std::strcpy(header.data(), "binary STL of the interfaces between materials, by cleft");
    file.write(header.data(), header.size());
    file.binary(static_cast<uint32_t>(surface.count()));
    for (int64_t t = 0; t < surface.count(); ++t) {
        const int32_t* c = surface.triangles.data() + 3 * t;
        const Vector3 corners[] = {point(mesh, c[0]), point(mesh, c[1]), point(mesh, c[2])};
        for (const Vector3& row : {unit_normal(corners[0], corners[1], corners[2]), corners[0], corners[1], corners[2]})
            for (const double coordinate : row)
                file.binary(static_cast<float>(coordinate));
        // The attribute byte count, which the format leaves to applications.
        file.binary(uint16_t{0});
    }
    file.commit();
}

void write_ply(const MeshView& mesh, const std::string& path)
{
    const InnerSurface surface = inner_surface(mesh);
    AtomicFile file(path);
    // PLY has double precision. Single precision would move the points.
    file.print("ply\nformat binary_little_endian 1.0\ncomment interfaces between materials, by cleft\nelement vertex ",
               surface.points.size(), "\nproperty double x\nproperty double y\nproperty double z\nelement face ",
               surface.count(),
               "\nproperty list uchar int vertex_indices\nproperty int material_1\nproperty int material_2\n"
               "end_header\n");
    for (const int32_t p : surface.points)
        file.write(mesh.points + 3 * int64_t{p}, 3 * sizeof(double));
    for (int64_t t = 0; t < surface.count(); ++t) {
        file.binary(uint8_t{3});
        file.write(surface.corners.data() + 3 * t, 3 * sizeof(int32_t));
        file.write(surface.labels.data() + 2 * t, 2 * sizeof(int32_t));
    }
    file.commit();
}

}  // namespace cleft::io
