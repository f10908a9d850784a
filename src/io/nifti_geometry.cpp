// Reads the place of the voxels from the numbers of a NIfTI header, in full: sheared and roughly rounded matrices are
// taken as they are.
#include "io/nifti_geometry.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "io/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace cleft::io
{

namespace
{

using Affine = std::array<double, 12>;  // to RAS
using Notes = std::vector<std::string>;

// Headers of broken converters have NaN in forms that are switched on. A check here names the form;
// later only the product would be known.
template <size_t N>
void check_finite(const std::array<double, N>& values, const std::string& what)
{
    for (const double value : values)
        if (!std::isfinite(value))
            throw Error(CLEFT_ERROR_FORMAT, what + " is not finite");
}

// The sizes of the voxels, positive; 0 where the file does not say.
// pixdim[1..3] of nifti1.h. They are to be positive, but some programs write negative ones for
// flips.
Vector3 voxel_sizes(const NiftiHeader& header, Notes& notes)
{
    Vector3 sizes{};
    bool negative = false;
    for (size_t axis = 0; axis < 3; ++axis) {
        // pixdim beyond the number of dimensions is undefined.
        if (static_cast<int64_t>(axis) >= header.dim[0])
            continue;
        const double size = header.pixdim[axis + 1];
        if (!std::isfinite(size))
            throw Error(CLEFT_ERROR_FORMAT, "pixdim[" + std::to_string(axis + 1) + "] is not finite");
        negative = negative || size < 0;
        sizes[axis] = std::abs(size);
    }
    if (negative)
        notes.emplace_back("sizes of its voxels (pixdim) are negative: they are taken without their signs");
    // One voxel is as thick as it is wide.
    for (size_t axis = 1; axis < 3; ++axis)
        // A single slice often has no thickness in its header.
        if (sizes[axis] == 0 && header.dim[axis + 1] == 1)
            sizes[axis] = sizes[0];
    return sizes;
}

// b, c, d made a rotation (a, b, c, d); rounding may have made them longer than 1.
// nifti1.h, "quaternion representation of rotation matrix": a = sqrt(1 - b^2 - c^2 - d^2), a >= 0.
std::array<double, 4> whole_quaternion(const NiftiHeader& header, Notes& notes)
{
    // Three numbers of single precision.
    constexpr double kRounding = 1e-6;
    // Files that were rounded to two or three digits by a text format lie below it.
    constexpr double kTolerance = 0.01;
    const auto [b, c, d] = header.quaternion;
    const double squared = b * b + c * c + d * d;
    if (squared > 1 + kTolerance)
        throw Error(CLEFT_ERROR_FORMAT,
                    "its qform is no rotation: the squares of its quaternion add up to " + number_text(squared));
    if (squared > 1 + kRounding)
        notes.push_back("the quaternion of its qform is roughly rounded (its squares add up to " +
                        number_text(squared) + "): it is made a rotation");
    const double length = std::max(1.0, std::sqrt(squared));
    return {squared >= 1 ? 0.0 : std::sqrt(1 - squared), b / length, c / length, d / length};
}

Affine qform_of(const NiftiHeader& header, Notes& notes)
{
    // nifti1.h calls pixdim[0] qfac, and says that 0 is to be taken for 1.
    const double handedness = header.pixdim[0] == 0 ? 1 : header.pixdim[0];
    if (handedness != 1 && handedness != -1)
        throw Error(CLEFT_ERROR_FORMAT,
                    "the handedness of its qform, pixdim[0], is " + number_text(handedness) + ": 1 or -1 is wanted");
    const auto [a, b, c, d] = whole_quaternion(header, notes);
    // Method 2 of nifti1.h. qfac changes the sign of the third axis alone.
    Vector3 steps = voxel_sizes(header, notes);
    steps[2] *= handedness;
    // The matrix R of nifti1.h, with the same names.
    const std::array<double, 9> rotation{
        a * a + b * b - c * c - d * d, 2 * (b * c - a * d),           2 * (b * d + a * c),
        2 * (b * c + a * d),           a * a + c * c - b * b - d * d, 2 * (c * d - a * b),
        2 * (b * d - a * c),           2 * (c * d + a * b),           a * a + d * d - b * b - c * c};
    Affine affine{};
    for (size_t row = 0; row < 3; ++row) {
        for (size_t axis = 0; axis < 3; ++axis)
            affine[4 * row + axis] = rotation[3 * row + axis] * steps[axis];
        affine[4 * row + 3] = header.q_offset[row];
    }
    return affine;
}

// Neither form: the middle of the box, or Analyze's origin where it is near the box, is at 0.
Affine base_affine(const NiftiHeader& header, Notes& notes)
{
    // Method 1 of nifti1.h leaves the orientation open. As nibabel does, the first axis is taken to
    // point left, and the middle of the box to be the origin.
    Vector3 steps = voxel_sizes(header, notes);
    steps[0] = -steps[0];
    bool said = false;
    bool near = true;
    for (size_t axis = 0; axis < 3; ++axis) {
        // SPM stored its origin in the field `originator` of Analyze, as a voxel counted from 1.
        // Other programs left text or noise there.
        said = said || header.spm_origin[axis] != 0;
        // Within one box below and two above, as nibabel accepts it. Noise is mostly far outside.
        near = near && header.spm_origin[axis] > -header.dim[axis + 1] &&
               header.spm_origin[axis] / 2 < header.dim[axis + 1];
    }
    Affine affine{};
    for (size_t axis = 0; axis < 3; ++axis) {
        const double middle = static_cast<double>(header.dim[axis + 1] - 1) / 2;
        affine[5 * axis] = steps[axis];
        affine[4 * axis + 3] = -steps[axis] * (said && near ? header.spm_origin[axis] - 1 : middle);
    }
    notes.push_back(std::string("the file says nothing of its orientation: its first axis is taken to point left, ") +
                    (said && near ? "and its origin from its header" : "and the middle of its box for the origin"));
    return affine;
}

Vector3 column(const Affine& affine, size_t axis) { return {affine[axis], affine[4 + axis], affine[8 + axis]}; }

double determinant(const Affine& affine) { return dot(cross(column(affine, 0), column(affine, 1)), column(affine, 2)); }

// The greatest distance between the places that two maps give to a corner of the box.
double greatest_distance(const Affine& a, const Affine& b, const NiftiHeader& header)
{
    double greatest = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        Vector3 way = minus(column(a, 3), column(b, 3));
        for (size_t axis = 0; axis < 3; ++axis) {
            // The box reaches half a voxel beyond the centres of its outer voxels.
            const bool far = (corner >> axis & 1) != 0;
            const double index = far ? static_cast<double>(header.dim[axis + 1]) - 0.5 : -0.5;
            way = minus(way, times(-index, minus(column(a, axis), column(b, axis))));
        }
        greatest = std::max(greatest, length(way));
    }
    return greatest;
}

double smallest_step(const Affine& affine)
{
    return std::min({length(column(affine, 0)), length(column(affine, 1)), length(column(affine, 2))});
}

// Near half a turn, rounding to single precision leaves this angle of a quaternion open.
// There a is the root of a small difference. Rounding of 1e-7 in it changes a by 3e-4, and the
// angle by twice that.
double open_angle(const NiftiHeader& header)
{
    // Within it, the sum of squares is 1 but for rounding.
    constexpr double kRounding = 1e-6;
    constexpr double kAngle = 7e-4;
    const auto [b, c, d] = header.quaternion;
    return std::abs(1 - (b * b + c * c + d * d)) < kRounding ? kAngle : 0;
}

double diagonal(const Affine& affine, const NiftiHeader& header)
{
    double squared = 0;
    for (size_t axis = 0; axis < 3; ++axis)
        squared += std::pow(length(column(affine, axis)) * static_cast<double>(header.dim[axis + 1]), 2);
    return std::sqrt(squared);
}

// nifti1.h allows both forms to be set for different purposes. Programs differ in which one they
// use, so a real difference is reported.
void compare_forms(const NiftiHeader& header, double scale, Notes& notes)
{
    const std::string used = ": the sform (code " + std::to_string(header.sform_code) + ") is used, the qform (code " +
                             std::to_string(header.qform_code) + ") is not";
    try {
        // Notes on a qform that is not used would only confuse.
        Notes of_qform;
        const Affine qform = qform_of(header, of_qform);
        const double apart = greatest_distance(header.s_rows, qform, header);
        const bool mirrored = determinant(header.s_rows) * determinant(qform) < 0;
        const double open = open_angle(header) * diagonal(header.s_rows, header);
        // Half a voxel: a smaller shift moves no label to another voxel. Rounding of the quaternion
        // is allowed for.
        if (apart > 0.5 * smallest_step(header.s_rows) + open || mirrored)
            notes.push_back("its sform and its qform place a corner of the box " + number_text(apart * scale) +
                            " mm apart" + (mirrored ? " and are mirrors of each other" : "") + used);
        // A broken qform beside a good sform is no reason to refuse the file.
    } catch (const Error& error) {
        notes.push_back(error.what() + used);
    }
}

// With an sform alone, nothing but the sizes of the voxels can tell of a doubt.
void compare_sizes(const NiftiHeader& header, Notes& notes)
{
    for (size_t axis = 0; axis < 3; ++axis) {
        const double size = std::abs(header.pixdim[axis + 1]);
        const double step = length(column(header.s_rows, axis));
        const auto voxels = static_cast<double>(header.dim[axis + 1]);
        // The same half voxel, at the far end of the box.
        if (size == 0 || voxels == 1 || std::abs(size - step) * voxels <= 0.5 * step)
            continue;
        notes.push_back("its voxels are " + number_text(step) + " wide along the " +
                        ordinal(static_cast<int64_t>(axis)) + " axis by its sform, which is used, but " +
                        number_text(size) + " by its pixdim");
        return;
    }
}

void check_numbers(const NiftiHeader& header)
{
    // 0 means that the form is not set. Unknown positive codes still say that it is.
    if (header.sform_code < 0 || header.qform_code < 0)
        throw Error(CLEFT_ERROR_FORMAT, "its sform_code, " + std::to_string(header.sform_code) +
                                            ", or its qform_code, " + std::to_string(header.qform_code) +
                                            ", is negative");
    if (header.sform_code > 0)
        check_finite(header.s_rows, "its sform");
    if (header.qform_code > 0) {
        check_finite(header.quaternion, "the quaternion of its qform");
        check_finite(header.q_offset, "the offset of its qform");
    }
}

Affine best_affine(const NiftiHeader& header, double scale, Notes& notes)
{
    check_numbers(header);
    // Method 3 before method 2, as nibabel does where both are set.
    if (header.sform_code > 0) {
        if (header.qform_code > 0)
            compare_forms(header, scale, notes);
        else
            compare_sizes(header, notes);
        return header.s_rows;
    }
    return header.qform_code > 0 ? qform_of(header, notes) : base_affine(header, notes);
}

// What makes millimetres of the file's lengths.
double millimetres(const NiftiHeader& header, Notes& notes)
{
    // The lowest three bits of xyzt_units: NIFTI_UNITS_METER 1, _MM 2, _MICRON 3. The other bits
    // are the unit of time.
    const int unit = header.units & 7;
    if (unit == 1 || unit == 3) {
        notes.emplace_back(unit == 1 ? "its lengths are turned from metres into millimetres"
                                     : "its lengths are turned from micrometres into millimetres");
        return unit == 1 ? 1e3 : 1e-3;
    }
    if (unit != 0 && unit != 2)
        notes.push_back("its unit of length, number " + std::to_string(unit) + ", is unknown: millimetres are taken");
    return 1;
}

// A plane of voxels may leave its third step open: it is as thick as it is wide. Any other step of no length is kept,
// with a way at right angles to the others, so that the user can give it.
void place(Affine affine, Image& image)
{
    std::array<bool, 3> missing{};
    const double width = length(column(affine, 0));
    for (size_t axis = 0; axis < 3; ++axis) {
        missing[axis] = length(column(affine, axis)) == 0;
        const Vector3 normal = cross(column(affine, (axis + 1) % 3), column(affine, (axis + 2) % 3));
        // With two missing steps the direction of neither is known.
        if (missing[axis] && length(normal) == 0)
            throw Error(CLEFT_ERROR_FORMAT, "its voxels have no size along several axes (sform, qform or pixdim)");
        if (missing[axis])
            for (size_t row = 0; row < 3; ++row)
                affine[4 * row + axis] = normal[row] * (axis == 0 ? 1 : width) / length(normal);
    }
    set_geometry(affine, CLEFT_IO_WORLD_RAS, image);
    for (size_t axis = 0; axis < 3; ++axis)
        // 0 makes a later check ask the user for this spacing, unless one was given.
        if (missing[axis] && (axis != 2 || image.dims[2] != 1))
            image.spacing[axis] = 0;
}

}  // namespace

void set_nifti_geometry(const NiftiHeader& header, Image& image)
{
    const double scale = millimetres(header, image.notes);
    Affine affine = best_affine(header, scale, image.notes);
    // The whole matrix in one unit, the origin too.
    for (double& value : affine)
        value *= scale;
    place(affine, image);
}

}  // namespace cleft::io
