// The header of a NIfTI-1, NIfTI-2 or Analyze 7.5 file as a plain value, in the numbers of the file.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace cleft::io
{

enum class NiftiKind { analyze, nifti1, nifti2 };

constexpr size_t kNifti1HeaderBytes = 348;
constexpr size_t kNifti2HeaderBytes = 540;
// The bytes extension[4] behind the header. The first of them is not 0 where extensions follow.
constexpr size_t kNiftiExtensionMark = 4;

struct NiftiHeader {
    NiftiKind kind = NiftiKind::analyze;
    bool single_file = false;  // the voxels follow the header
    bool swapped = false;      // is the order of bytes not that of this machine?
    std::array<int64_t, 8> dim{};
    int datatype = 0;
    int bitpix = 0;
    std::array<double, 8> pixdim{};
    double vox_offset = 0;
    double slope = 0;
    double intercept = 0;
    int intent = 0;
    int units = 0;
    int qform_code = 0;
    int sform_code = 0;
    std::array<double, 3> quaternion{};  // b, c, d
    std::array<double, 3> q_offset{};
    std::array<double, 12> s_rows{};
    std::array<int, 3> spm_origin{};  // of Analyze: the voxel, from 1, at the origin; 0: not said

    size_t bytes() const { return kind == NiftiKind::nifti2 ? kNifti2HeaderBytes : kNifti1HeaderBytes; }
};

// Are these the first bytes of such a header? Analyze has no mark of its own but its length.
// `count` may be any number; fewer than 348 bytes are no header.
bool is_nifti_header(const unsigned char* bytes, size_t count);
// Of bytes for which that is so.
// Throws Error(CLEFT_ERROR_FORMAT) where a header of NIfTI-2 is cut short. No field is judged.
NiftiHeader parse_nifti_header(const unsigned char* bytes, size_t count);

}  // namespace cleft::io
