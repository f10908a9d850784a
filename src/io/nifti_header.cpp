// Takes the header of NIfTI and Analyze files apart, in either order of bytes.
#include "io/nifti_header.hpp"

#include "base/error.hpp"
#include "io/binary_header.hpp"

#include <algorithm>
#include <cstring>
#include <string>

namespace cleft::io
{

namespace
{

constexpr bool kBigEndianMachine = __BYTE_ORDER__ == __ORDER_BIG_ENDIAN__;

// sizeof_hdr is the first field of all three formats. Its value shows the order of bytes.
bool has_length(const unsigned char* bytes, int32_t length, bool swapped)
{
    return BinaryHeader(bytes, sizeof length, swapped != kBigEndianMachine).at<int32_t>(0) == length;
}

bool has_mark(const unsigned char* at, const char* mark, size_t count) { return std::memcmp(at, mark, count) == 0; }

// The field `magic`. It is at the end of NIfTI-1, where Analyze has a field that few programs use, and behind
// sizeof_hdr in NIfTI-2.
constexpr size_t kMarkOfNifti1 = 344;
constexpr size_t kMarkOfNifti2 = 4;

// "n+1": header and voxels in one file. "ni1": in two.
bool is_nifti1(const unsigned char* bytes)
{
    return has_mark(bytes + kMarkOfNifti1, "n+1", 4) || has_mark(bytes + kMarkOfNifti1, "ni1", 4);
}

// The bytes behind the mark end PNG's signature, too: they show if a transfer changed the ends of
// lines.
bool is_nifti2(const unsigned char* bytes)
{
    return has_mark(bytes + kMarkOfNifti2, "n+2\0\r\n\032\n", 8) ||
           has_mark(bytes + kMarkOfNifti2, "ni2\0\r\n\032\n", 8);
}

// Offsets in struct dsr of Analyze 7.5: dim, datatype, bitpix, pixdim, vox_offset, funused1 (SPM's
// scale) and originator.
void parse_analyze(const BinaryHeader& fields, NiftiHeader& header)
{
    fields.at<int16_t>(40, header.dim);
    header.datatype = fields.at<int16_t>(70);
    header.bitpix = fields.at<int16_t>(72);
    fields.at<float>(76, header.pixdim);
    header.vox_offset = fields.at<float>(108);
    header.slope = fields.at<float>(112);
    fields.at<int16_t>(253, header.spm_origin);
}

void parse_nifti1(const BinaryHeader& fields, NiftiHeader& header)
{
    parse_analyze(fields, header);
    header.intercept = fields.at<float>(116);
    header.intent = fields.at<int16_t>(68);
    header.units = fields.at<uint8_t>(123);
    header.qform_code = fields.at<int16_t>(252);
    header.sform_code = fields.at<int16_t>(254);
    fields.at<float>(256, header.quaternion);
    fields.at<float>(268, header.q_offset);
    fields.at<float>(280, header.s_rows);
    // In NIfTI these bytes belong to other fields.
    header.spm_origin = {};
}

void parse_nifti2(const BinaryHeader& fields, NiftiHeader& header)
{
    header.datatype = fields.at<int16_t>(12);
    header.bitpix = fields.at<int16_t>(14);
    fields.at<int64_t>(16, header.dim);
    fields.at<double>(104, header.pixdim);
    header.vox_offset = static_cast<double>(fields.at<int64_t>(168));
    header.slope = fields.at<double>(176);
    header.intercept = fields.at<double>(184);
    header.qform_code = fields.at<int32_t>(344);
    header.sform_code = fields.at<int32_t>(348);
    fields.at<double>(352, header.quaternion);
    fields.at<double>(376, header.q_offset);
    fields.at<double>(400, header.s_rows);
    header.units = fields.at<int32_t>(500);
    header.intent = fields.at<int32_t>(504);
}

}  // namespace

bool is_nifti_header(const unsigned char* bytes, size_t count)
{
    if (count < kNifti1HeaderBytes)
        return false;
    for (const bool swapped : {false, true}) {
        const int64_t axes = BinaryHeader(bytes, count, swapped != kBigEndianMachine).at<int16_t>(40);
        // Analyze has no mark: 348 at the beginning and a plausible dim[0] are all that shows it.
        // So the table of readers asks for it after the formats with marks.
        if (has_length(bytes, kNifti1HeaderBytes, swapped) && (is_nifti1(bytes) || (axes >= 1 && axes <= 7)))
            return true;
        if (has_length(bytes, kNifti2HeaderBytes, swapped) && is_nifti2(bytes))
            return true;
    }
    return false;
}

NiftiHeader parse_nifti_header(const unsigned char* bytes, size_t count)
{
    NiftiHeader header;
    const bool second = is_nifti2(bytes);
    const auto length = static_cast<int32_t>(second ? kNifti2HeaderBytes : kNifti1HeaderBytes);
    header.swapped = !has_length(bytes, length, false);
    header.kind = second ? NiftiKind::nifti2 : is_nifti1(bytes) ? NiftiKind::nifti1 : NiftiKind::analyze;
    if (count < header.bytes())
        throw Error(CLEFT_ERROR_FORMAT, "its header is cut short");
    const BinaryHeader fields(bytes, count, header.swapped != kBigEndianMachine);
    if (header.kind == NiftiKind::nifti2)
        parse_nifti2(fields, header);
    else if (header.kind == NiftiKind::nifti1)
        parse_nifti1(fields, header);
    else
        parse_analyze(fields, header);
    // The second letter of the mark: "n+1" or "ni1".
    header.single_file =
        header.kind != NiftiKind::analyze && bytes[(second ? kMarkOfNifti2 : kMarkOfNifti1) + 1] == '+';
    return header;
}

}  // namespace cleft::io
