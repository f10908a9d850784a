// A DICOM file as a set of elements, read without trust: every length is checked before it is used.
#pragma once

#include "base/error.hpp"

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

// Group and number of an element, 0x00280010.
using DicomTag = uint32_t;

// Elements that several readers look at: Pixel Data, and the Shared and Per-Frame Functional Groups Sequences of
// enhanced multi-frame objects (PS3.3, section C.7.6.16).
constexpr DicomTag kPixelsTag = 0x7FE00010u;
constexpr DicomTag kSharedGroups = 0x52009229u;
constexpr DicomTag kFrameGroups = 0x52009230u;

// A file that DICOM's rules or ours do not allow.
[[noreturn]] inline void refuse_dicom(const std::string& sentence) { throw Error(CLEFT_ERROR_FORMAT, sentence); }

struct DicomEncoding {
    bool implicit = false;  // elements do not state their types
    bool big_endian = false;
};

struct DicomElement {
    std::string_view bytes;                   // of an ordinary element, or all of a sequence without its end mark
    std::vector<std::string_view> fragments;  // of compressed pixels; the first is the table of offsets
    bool encapsulated = false;
    bool in_words = false;  // of 16 bits (type OW)
    DicomEncoding inside;   // of the items
};

// Elements by their tags. It refers to the bytes that it was read from.
class DicomData
{
public:
    DicomData() = default;
    // Throws Error(CLEFT_ERROR_FORMAT) if an element goes beyond the bytes.
    DicomData(std::string_view bytes, DicomEncoding encoding);

    bool has(DicomTag tag) const { return elements_.count(tag) > 0; }
    // The element, or null. The pointer lives as long as this object.
    const DicomElement* find(DicomTag tag) const;
    // Without the blanks and zeros that pad it; "" if there is none.
    std::string text(DicomTag tag) const;
    // The numbers of a text "1\2.5"; throws if one is no number.
    std::vector<double> numbers(DicomTag tag) const;
    // A binary number of 16 bits; `otherwise` if there is none.
    int64_t short_number(DicomTag tag, int64_t otherwise) const;
    // The items of a sequence; none if there is none.
    std::vector<DicomData> items(DicomTag tag) const;
    bool is_big_endian() const { return encoding_.big_endian; }

private:
    std::map<DicomTag, DicomElement> elements_;
    DicomEncoding encoding_;
};

// A file that was taken apart, with the bytes that its elements point to.
struct DicomFile {
    std::string path;
    std::shared_ptr<const std::string> bytes;  // what `data` refers to
    std::string transfer_syntax;
    DicomData data;
};

// Text of a file for a message: what is not ASCII, or has no sign, becomes '?'.
// Messages may reach a terminal, where control characters of a file could do harm.
std::string ascii_of(std::string text);
// May the file be DICOM, by its first bytes?
bool is_dicom_head(std::string_view head);
// Throws Errors that do not name the file.
DicomFile read_dicom_file(const std::string& path);

}  // namespace cleft::io
