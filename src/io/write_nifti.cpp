// Writes NIfTI-1: header, four zeros that say that there is no extension, voxels.
#include "io/write_nifti.hpp"

#include "base/error.hpp"
#include "io/atomic_file.hpp"
#include "io/file_name.hpp"
#include "io/nifti_header.hpp"
#include "io/packed_bytes.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cleft::io
{

namespace
{

// 352, the least vox_offset that nifti1.h allows in a single file.
constexpr size_t kVoxelOffset = kNifti1HeaderBytes + kNiftiExtensionMark;

template <class T>
void put(std::string& header, size_t offset, T value)
{
    std::memcpy(&header[offset], &value, sizeof value);
}

// A rotation as a quaternion (b, c, d) with a >= 0, by its largest component so that none is lost to rounding.
std::array<double, 3> quaternion_of(const std::array<Vector3, 3>& axes)
{
    // Four times the squares of a, b, c, d.
    const std::array<double, 4> squares{
        1 + axes[0][0] + axes[1][1] + axes[2][2], 1 + axes[0][0] - axes[1][1] - axes[2][2],
        1 - axes[0][0] + axes[1][1] - axes[2][2], 1 - axes[0][0] - axes[1][1] + axes[2][2]};
    // Four times the products: of a with b, c, d, and of c d, b d, b c.
    const std::array<double, 3> with_a{axes[1][2] - axes[2][1], axes[2][0] - axes[0][2], axes[0][1] - axes[1][0]};
    const std::array<double, 3> others{axes[1][2] + axes[2][1], axes[2][0] + axes[0][2], axes[0][1] + axes[1][0]};
    // Division by the largest component: the others are lost to rounding where it is small.
    const auto largest = static_cast<size_t>(std::max_element(squares.begin(), squares.end()) - squares.begin());
    const double twice = std::sqrt(squares[largest]);
    std::array<double, 3> found{};
    if (largest == 0) {
        for (size_t i = 0; i < 3; ++i)
            found[i] = with_a[i] / (2 * twice);
        return found;
    }
    const size_t self = largest - 1;
    found[self] = twice / 2;
    for (size_t i = 0; i < 3; ++i)
        if (i != self)
            found[i] = others[3 - self - i] / (2 * twice);
    // A quaternion and its negative are one rotation. nifti1.h stores the one with a >= 0 and
    // leaves a out.
    return with_a[self] < 0 ? std::array<double, 3>{-found[0], -found[1], -found[2]} : found;
}

bool is_sheared(const Image& image)
{
    // Directions come out of a division and are off by rounding.
    constexpr double kTolerance = 1e-6;
    for (size_t axis = 0; axis < 3; ++axis)
        if (std::abs(dot(image.directions[axis], image.directions[(axis + 1) % 3])) > kTolerance)
            return true;
    return false;
}

// From LPS to NIfTI's RAS.
Vector3 ras(const Vector3& v) { return {-v[0] + 0.0, -v[1] + 0.0, v[2]}; }

void put_geometry(const Image& image, std::string& header)
{
    std::array<Vector3, 3> axes{};
    for (size_t axis = 0; axis < 3; ++axis)
        axes[axis] = ras(image.directions[axis]);
    const Vector3 origin = ras(image.origin);
    const bool mirrored = dot(cross(axes[0], axes[1]), axes[2]) < 0;
    // qfac, in pixdim[0]: a quaternion cannot hold a reflection.
    put(header, 76, mirrored ? -1.0F : 1.0F);
    // sform_code 1: coordinates of a scanner. The unit and meaning of the world are not known here.
    put(header, 254, int16_t{1});
    for (size_t row = 0; row < 3; ++row) {
        for (size_t axis = 0; axis < 3; ++axis)
            put(header, 280 + 16 * row + 4 * axis, static_cast<float>(image.spacing[axis] * axes[axis][row]));
        put(header, 280 + 16 * row + 12, static_cast<float>(origin[row]));
    }
    // qform_code stays 0: no quaternion describes a sheared grid.
    if (is_sheared(image))
        return;
    put(header, 252, int16_t{1});
    if (mirrored)
        axes[2] = times(-1, axes[2]);
    const std::array<double, 3> quaternion = quaternion_of(axes);
    for (size_t i = 0; i < 3; ++i) {
        put(header, 256 + 4 * i, static_cast<float>(quaternion[i]));
        put(header, 268 + 4 * i, static_cast<float>(origin[i]));
    }
}

std::string header_of(const Image& image)
{
    // DT_FLOAT32
    constexpr int16_t kFloat32 = 16;
    std::string header(kVoxelOffset, '\0');
    put(header, 0, static_cast<int32_t>(kNifti1HeaderBytes));
    // dim[0]. Fields of nifti1.h that are not set below stay 0.
    put(header, 40, int16_t{3});
    for (size_t axis = 0; axis < 7; ++axis) {
        const int64_t count = axis < 3 ? image.dims[axis] : 1;
        // dim[] has 16 bits in NIfTI-1.
        if (count > INT16_MAX)
            throw Error(CLEFT_ERROR_UNSUPPORTED,
                        "a NIfTI file cannot hold " + std::to_string(count) + " voxels along an axis: use .nrrd");
        put(header, 42 + 2 * axis, static_cast<int16_t>(count));
        put(header, 80 + 4 * axis, axis < 3 ? static_cast<float>(image.spacing[axis]) : 1.0F);
    }
    put(header, 70, kFloat32);
    put(header, 72, int16_t{32});
    put(header, 108, static_cast<float>(kVoxelOffset));
    put(header, 112, 1.0F);  // scl_slope
    put_geometry(image, header);
    header.replace(344, 4, "n+1", 4);  // with its zero
    return header;
}

std::string gzip(const std::string& header, const Image& image)
{
    std::string bytes = header;
    bytes.append(reinterpret_cast<const char*>(image.voxels.get()), image.bytes());
    return packed_bytes(bytes, Wrapping::gzip);
}

}  // namespace

void write_nifti(const std::string& path, const Image& image)
{
    const std::string header = header_of(image);
    AtomicFile file(path);
    if (extension_of(path) == ".nii.gz") {
        const std::string packed = gzip(header, image);
        file.write(packed.data(), packed.size());
    } else {
        file.write(header.data(), header.size());
        file.write(image.voxels.get(), image.bytes());
    }
    file.commit();
}

}  // namespace cleft::io
