// Takes the header of NIfTI and Analyze files apart, in either order of bytes.
#include "io/nifti_header.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstring>
#include <string>

namespace cleft::io
{

namespace
{

class Fields
{
public:
    Fields(const unsigned char* bytes, bool swapped) : bytes_(bytes), swapped_(swapped) {}

    template <class T>
    T get(size_t offset) const
    {
        std::array<unsigned char, sizeof(T)> raw{};
        std::copy_n(bytes_ + offset, sizeof(T), raw.begin());
        if (swapped_)
            std::reverse(raw.begin(), raw.end());
        T value{};
        std::memcpy(&value, raw.data(), sizeof(T));
        return value;
    }

    template <class T, class To, size_t N>
    void get(size_t offset, std::array<To, N>& to) const
    {
        for (size_t i = 0; i < N; ++i)
            to[i] = static_cast<To>(get<T>(offset + i * sizeof(T)));
    }

private:
    const unsigned char* bytes_;
    bool swapped_;
};

bool has_length(const unsigned char* bytes, int32_t length, bool swapped)
{
    return Fields(bytes, swapped).get<int32_t>(0) == length;
}

bool has_mark(const unsigned char* at, const char* mark, size_t count) { return std::memcmp(at, mark, count) == 0; }

constexpr size_t mark_of_nifti1 = 344;
constexpr size_t mark_of_nifti2 = 4;

bool is_nifti1(const unsigned char* bytes)
{
    return has_mark(bytes + mark_of_nifti1, "n+1", 4) || has_mark(bytes + mark_of_nifti1, "ni1", 4);
}

bool is_nifti2(const unsigned char* bytes)
{
    return has_mark(bytes + mark_of_nifti2, "n+2\0\r\n\032\n", 8) ||
           has_mark(bytes + mark_of_nifti2, "ni2\0\r\n\032\n", 8);
}

void parse_analyze(const Fields& fields, NiftiHeader& header)
{
    fields.get<int16_t>(40, header.dim);
    header.datatype = fields.get<int16_t>(70);
    header.bitpix = fields.get<int16_t>(72);
    fields.get<float>(76, header.pixdim);
    header.vox_offset = fields.get<float>(108);
    header.slope = fields.get<float>(112);
    fields.get<int16_t>(253, header.spm_origin);
}

void parse_nifti1(const Fields& fields, NiftiHeader& header)
{
    parse_analyze(fields, header);
    header.intercept = fields.get<float>(116);
    header.intent = fields.get<int16_t>(68);
    header.units = fields.get<uint8_t>(123);
    header.qform_code = fields.get<int16_t>(252);
    header.sform_code = fields.get<int16_t>(254);
    fields.get<float>(256, header.quaternion);
    fields.get<float>(268, header.q_offset);
    fields.get<float>(280, header.s_rows);
    header.spm_origin = {};
}

void parse_nifti2(const Fields& fields, NiftiHeader& header)
{
    header.datatype = fields.get<int16_t>(12);
    header.bitpix = fields.get<int16_t>(14);
    fields.get<int64_t>(16, header.dim);
    fields.get<double>(104, header.pixdim);
    header.vox_offset = static_cast<double>(fields.get<int64_t>(168));
    header.slope = fields.get<double>(176);
    header.intercept = fields.get<double>(184);
    header.qform_code = fields.get<int32_t>(344);
    header.sform_code = fields.get<int32_t>(348);
    fields.get<double>(352, header.quaternion);
    fields.get<double>(376, header.q_offset);
    fields.get<double>(400, header.s_rows);
    header.units = fields.get<int32_t>(500);
    header.intent = fields.get<int32_t>(504);
}

}  // namespace

bool is_nifti_header(const unsigned char* bytes, size_t count)
{
    if (count < nifti1_header_bytes)
        return false;
    for (const bool swapped : {false, true}) {
        const int64_t axes = Fields(bytes, swapped).get<int16_t>(40);
        if (has_length(bytes, nifti1_header_bytes, swapped) && (is_nifti1(bytes) || (axes >= 1 && axes <= 7)))
            return true;
        if (has_length(bytes, nifti2_header_bytes, swapped) && is_nifti2(bytes))
            return true;
    }
    return false;
}

NiftiHeader parse_nifti_header(const unsigned char* bytes, size_t count)
{
    NiftiHeader header;
    const bool second = is_nifti2(bytes);
    const auto length = static_cast<int32_t>(second ? nifti2_header_bytes : nifti1_header_bytes);
    header.swapped = !has_length(bytes, length, false);
    header.kind = second ? NiftiKind::nifti2 : is_nifti1(bytes) ? NiftiKind::nifti1 : NiftiKind::analyze;
    if (count < header.bytes())
        throw Error(CLEFT_ERROR_FORMAT, "its header is cut short");
    const Fields fields(bytes, header.swapped);
    if (header.kind == NiftiKind::nifti2)
        parse_nifti2(fields, header);
    else if (header.kind == NiftiKind::nifti1)
        parse_nifti1(fields, header);
    else
        parse_analyze(fields, header);
    header.single_file =
        header.kind != NiftiKind::analyze && bytes[(second ? mark_of_nifti2 : mark_of_nifti1) + 1] == '+';
    return header;
}

}  // namespace cleft::io
