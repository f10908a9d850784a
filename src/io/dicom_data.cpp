// Takes DICOM files apart: explicit and implicit types, both byte orders, sequences, deflated and compressed files.
#include "io/dicom_data.hpp"

#include "io/ascii.hpp"
#include "io/byte_source.hpp"
#include "io/packed_bytes.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>

namespace cleft::io
{

namespace
{

// PS3.5, section 7.1.1 (undefined length) and section 7.5 (items and their two delimiters).
constexpr uint32_t kUndefinedLength = 0xFFFFFFFFu;
constexpr DicomTag kItemTag = 0xFFFEE000u;
constexpr DicomTag kItemEndTag = 0xFFFEE00Du;
constexpr DicomTag kSequenceEndTag = 0xFFFEE0DDu;
// Sequences in sequences: image objects nest a few levels deep. The bound protects the stack, as the reader recurses.
constexpr int kDeepest = 16;

[[noreturn]] void refuse_damaged(const std::string& what)
{
    throw Error(CLEFT_ERROR_FORMAT, "the DICOM file is damaged: " + what);
}

std::string name_of(DicomTag tag)
{
    char text[20];
    // The notation of PS3.6, by which a user finds the element in a data dictionary.
    std::snprintf(text, sizeof text, "(%04x,%04x)", tag >> 16, tag & 0xFFFFu);
    return text;
}

struct ElementHead {
    DicomTag tag = 0;
    char type[3] = "";
    uint32_t length = 0;
};

// Reads one data set element by element, as PS3.5, section 7.1 lays them out. It never goes beyond
// the bytes it was given.
class ElementReader
{
public:
    ElementReader(std::string_view bytes, DicomEncoding encoding) : bytes_(bytes), encoding_(encoding) {}

    bool at_end() const { return at_ == bytes_.size(); }
    size_t place() const { return at_; }

    // Tag, type (the standard calls it VR) and length of the next element. Items and delimiters
    // have no type in either encoding.
    ElementHead head()
    {
        ElementHead head;
        const uint32_t group = number(2);
        head.tag = group << 16 | number(2);
        if (encoding_.implicit || group == 0xFFFE) {
            head.length = number(4);
            return head;
        }
        std::memcpy(head.type, take(2, head.tag).data(), 2);
        // The types that PS3.5, section 7.1.2 (table 7.1-1) gives two reserved bytes and a length
        // of 32 bits. All others have a length of 16 bits.
        static const char* const long_types = "OB OD OF OL OV OW SQ SV UC UN UR UT UV";
        // All types are two capital letters. Anything else means that a length before it was wrong,
        // or that the file has implicit types.
        if (!is_capital(head.type[0]) || !is_capital(head.type[1]))
            refuse_damaged("the element " + name_of(head.tag) + " has no type");
        const bool is_long = std::strstr(long_types, head.type) != nullptr;
        if (is_long)
            take(2, head.tag);
        head.length = number(is_long ? 4 : 2);
        return head;
    }

    // The value behind a head that was just read. `depth` counts the sequences around it.
    DicomElement element(const ElementHead& head, int depth)
    {
        DicomElement element;
        // PS3.5, section 6.2.2: a sequence of type UN is encoded as Implicit VR Little Endian, in a
        // big-endian file too.
        const bool unknown = std::strcmp(head.type, "UN") == 0;
        element.inside = unknown ? DicomEncoding{true, false} : encoding_;
        element.in_words = std::strcmp(head.type, "OW") == 0;
        if (head.length != kUndefinedLength) {
            element.bytes = take(head.length, head.tag);
            // Pixel data of undefined length are encapsulated (PS3.5, section A.4): items that are
            // fragments of a code stream and not data sets.
        } else if (head.tag == kPixelsTag) {
            element.encapsulated = true;
            element.fragments = fragments();
        } else {
            const size_t start = at_;
            // The items inside follow the encoding of this element. The reader goes back to the
            // file's own behind it.
            const DicomEncoding before = encoding_;
            encoding_ = element.inside;
            const size_t end = skip_items(depth);
            encoding_ = before;
            element.bytes = bytes_.substr(start, end - start);
        }
        return element;
    }

    std::string_view take(size_t count, DicomTag tag)
    {
        // at_ never exceeds the size, so the difference cannot wrap, whatever length the file
        // claims.
        if (count > bytes_.size() - at_)
            refuse_damaged("the element " + name_of(tag) + " goes beyond the end of the file");
        const std::string_view taken = bytes_.substr(at_, count);
        at_ += count;
        return taken;
    }

    // The bytes of the item behind an item's head.
    std::string_view item(uint32_t length, int depth)
    {
        if (length != kUndefinedLength)
            return take(length, kItemTag);
        const size_t start = at_;
        for (;;) {
            const size_t before = at_;
            const ElementHead inner = head();
            if (inner.tag == kItemEndTag)
                return bytes_.substr(start, before - start);
            // Elements are read only to find the end of the item. Nothing else tells where an item
            // of undefined length ends.
            element(inner, depth);
        }
    }

private:
    uint32_t number(size_t size)
    {
        const std::string_view taken = take(size, 0);
        uint32_t value = 0;
        for (size_t b = 0; b < size; ++b) {
            const size_t place = encoding_.big_endian ? size - 1 - b : b;
            value |= static_cast<uint32_t>(static_cast<unsigned char>(taken[b])) << (8 * place);
        }
        return value;
    }

    // Goes behind the end mark of a sequence of undefined length; answers where the mark begins.
    size_t skip_items(int depth)
    {
        if (depth > kDeepest)
            refuse_damaged("its sequences are nested too deep");
        for (;;) {
            const size_t before = at_;
            const ElementHead item_head = head();
            if (item_head.tag == kSequenceEndTag)
                return before;
            if (item_head.tag != kItemTag)
                refuse_damaged("a sequence has no end");
            item(item_head.length, depth + 1);
        }
    }

    std::vector<std::string_view> fragments()
    {
        std::vector<std::string_view> all;
        for (;;) {
            const ElementHead fragment = head();
            if (fragment.tag == kSequenceEndTag)
                return all;
            if (fragment.tag != kItemTag)
                refuse_damaged("its compressed pixels have no end");
            all.push_back(take(fragment.length, kPixelsTag));
        }
    }

    std::string_view bytes_;
    DicomEncoding encoding_;
    size_t at_ = 0;
};

std::string without_padding(std::string_view bytes)
{
    // PS3.5, section 6.2: text is padded to an even length with a blank, UIDs with a zero byte.
    // Leading blanks mean nothing in the types that are read here.
    const size_t end = bytes.find_last_not_of(std::string_view(" \0", 2));
    const size_t start = bytes.find_first_not_of(' ');
    return end == std::string_view::npos ? std::string() : std::string(bytes.substr(start, end + 1 - start));
}

bool begins_with_type(std::string_view bytes)
{
    return bytes.size() > 5 && is_capital(bytes[4]) && is_capital(bytes[5]);
}

std::string inflated(std::string_view packed)
{
    auto data = unpacked_deflate(packed);
    if (!data)
        refuse_damaged("its deflated data cannot be unpacked");
    return std::move(*data);
}

// The elements of group 2 in front of the data, which always state their types. Answers how many bytes they have.
size_t read_meta(std::string_view bytes, std::string& transfer_syntax)
{
    // The file meta information of PS3.10, section 7.1 is always Explicit VR Little Endian,
    // whatever the rest of the file uses. Its own length element, (0002,0000), is wrong in some
    // files, so it is not used.
    size_t size = 0;
    while (size + 4 <= bytes.size() && bytes[size] == 2 && bytes[size + 1] == 0) {
        ElementReader reader(bytes.substr(size), DicomEncoding{});
        const ElementHead head = reader.head();
        const DicomElement element = reader.element(head, 0);
        // Transfer Syntax UID.
        if (head.tag == 0x00020010u)
            transfer_syntax = without_padding(element.bytes);
        size += reader.place();
    }
    return size;
}

}  // namespace

DicomData::DicomData(std::string_view bytes, DicomEncoding encoding) : encoding_(encoding)
{
    ElementReader reader(bytes, encoding);
    while (!reader.at_end()) {
        const ElementHead head = reader.head();
        // Group FFFE is of items and delimiters, which belong inside of sequences. Outside, they
        // show that the reader lost its place.
        if (head.tag >> 16 == 0xFFFEu)
            refuse_damaged("an item stands outside of a sequence");
        elements_[head.tag] = reader.element(head, 0);
    }
}

const DicomElement* DicomData::find(DicomTag tag) const
{
    const auto found = elements_.find(tag);
    return found == elements_.end() ? nullptr : &found->second;
}

std::string DicomData::text(DicomTag tag) const
{
    const DicomElement* element = find(tag);
    return element ? without_padding(element->bytes) : std::string();
}

std::vector<double> DicomData::numbers(DicomTag tag) const
{
    std::vector<double> all;
    const std::string list = text(tag);
    // A backslash separates the values of one element (PS3.5, section 6.4).
    for (size_t start = 0; !list.empty() && start <= list.size();) {
        const size_t end = std::min(list.find('\\', start), list.size());
        const std::string word = without_padding(list.substr(start, end - start));
        // A decimal string (DS) may have a leading plus sign, which from_chars() does not know.
        const char* from = word.c_str() + (word.substr(0, 1) == "+" ? 1 : 0);
        const char* const to = word.c_str() + word.size();
        double value = 0;
        const auto [stop, fault] = std::from_chars(from, to, value);
        all.push_back(value);
        if (fault != std::errc() || stop != to || !std::isfinite(value))
            refuse_damaged("the element " + name_of(tag) + " holds '" + ascii_of(word) + "', not a number");
        start = end + 1;
    }
    return all;
}

int64_t DicomData::short_number(DicomTag tag, int64_t otherwise) const
{
    const DicomElement* element = find(tag);
    // US has two bytes. A shorter value is that of an element that is there without a value (type
    // 2).
    if (!element || element->bytes.size() < 2)
        return otherwise;
    const int64_t first = static_cast<unsigned char>(element->bytes[0]);
    const int64_t second = static_cast<unsigned char>(element->bytes[1]);
    return encoding_.big_endian ? first << 8 | second : second << 8 | first;
}

std::vector<DicomData> DicomData::items(DicomTag tag) const
{
    std::vector<DicomData> all;
    const DicomElement* element = find(tag);
    if (!element)
        return all;
    ElementReader reader(element->bytes, element->inside);
    while (!reader.at_end()) {
        const ElementHead head = reader.head();
        if (head.tag != kItemTag)
            refuse_damaged("the sequence " + name_of(tag) + " holds what is no item");
        all.emplace_back(reader.item(head.length, 0), element->inside);
    }
    return all;
}

std::string ascii_of(std::string text)
{
    for (char& c : text)
        if (c < ' ' || c > '~')
            c = '?';
    return text;
}

bool is_dicom_head(std::string_view head)
{
    // PS3.10, section 7.1: a preamble of 128 bytes, then the prefix "DICM".
    if (head.size() >= 132 && head.substr(128, 4) == "DICM")
        return true;
    // Files without a preamble begin with a short element of group 2 or 8; element 0, the length of the group, has four
    // bytes. Other formats may begin with such a number of voxels.
    if (head.size() <= 8 || (head[0] != 2 && head[0] != 8) || head[1] != 0 || head[3] != 0)
        return false;
    return begins_with_type(head) || (head[6] == 0 && head[7] == 0 && (head[2] != 0 || (head[4] == 4 && head[5] == 0)));
}

DicomFile read_dicom_file(const std::string& path)
{
    DicomFile file;
    file.path = path;
    // Shared, since all elements refer to these bytes and the file may be copied or moved.
    auto bytes = std::make_shared<std::string>(read_whole_file(path));
    const bool marked = bytes->size() >= 132 && bytes->compare(128, 4, "DICM") == 0;
    std::string_view rest = std::string_view(*bytes).substr(marked ? 132 : 0);
    rest.remove_prefix(read_meta(rest, file.transfer_syntax));
    // Deflated Explicit VR Little Endian: all behind the meta information is one raw deflate stream
    // (PS3.5, section A.5).
    if (file.transfer_syntax == "1.2.840.10008.1.2.1.99") {
        bytes = std::make_shared<std::string>(inflated(rest));
        rest = *bytes;
        file.transfer_syntax = "1.2.840.10008.1.2.1";
    }
    DicomEncoding encoding;
    // Explicit VR Big Endian is retired since 2006, but files of older scanners still have it.
    encoding.big_endian = file.transfer_syntax == "1.2.840.10008.1.2.2";
    // A file without meta information does not name its syntax. The first element shows whether
    // types are written.
    encoding.implicit =
        file.transfer_syntax.empty() ? !begins_with_type(rest) : file.transfer_syntax == "1.2.840.10008.1.2";
    if (rest.empty())
        refuse_damaged("it ends behind its first bytes");
    file.bytes = bytes;
    file.data = DicomData(rest, encoding);
    return file;
}

}  // namespace cleft::io
