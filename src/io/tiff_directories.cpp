// Walks the chain of directories of a TIFF file. libtiff follows what a file says: chains that run in a circle, tables
// that lie behind its end, tens of thousands of unknown tags. What would keep it busy for ever is refused here.
#include "io/tiff_directories.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/system_failure.hpp"

#include <algorithm>
#include <array>
#include <cstdio>
#include <memory>
#include <set>
#include <unordered_set>

namespace cleft::io
{

namespace
{

// libtiff counts directories in 16 bits in versions before 4.5.
constexpr size_t kMostPages = 65535;
constexpr size_t kMostTags = 1000;  // different ones in a file

class Walker
{
public:
    explicit Walker(const std::string& path) : file_(std::fopen(path.c_str(), "rb"), std::fclose)
    {
        if (!file_ || fseeko(file_.get(), 0, SEEK_END) != 0)
            throw_system_failure("it cannot be opened", errno);
        found_.file_bytes = static_cast<uint64_t>(ftello(file_.get()));
    }

    TiffDirectories walk()
    {
        std::unordered_set<uint64_t> seen;
        for (uint64_t offset = first_directory(); offset != 0;) {
            const std::string page = "the " + ordinal(static_cast<int64_t>(found_.list.size())) + " page";
            // Nothing in TIFF 6.0 forbids an offset that leads back. libtiff's own search for
            // circles is slow in older versions.
            if (!seen.insert(offset).second)
                throw Error(CLEFT_ERROR_FORMAT, "its pages run in a circle: the file is damaged");
            if (found_.list.size() == kMostPages)
                throw Error(CLEFT_ERROR_UNSUPPORTED, "it has more than " + std::to_string(kMostPages) + " pages");
            offset = directory(offset, page);
        }
        if (found_.list.empty())
            throw Error(CLEFT_ERROR_FORMAT, "it has no pages");
        return std::move(found_);
    }

private:
    uint64_t number(const unsigned char* bytes, size_t size) const
    {
        uint64_t value = 0;
        for (size_t i = 0; i < size; ++i)
            value = value << 8 | bytes[found_.big_endian ? i : size - 1 - i];
        return value;
    }

    std::vector<unsigned char> read(uint64_t offset, uint64_t bytes, const std::string& what)
    {
        // The sum could wrap around; the difference cannot.
        if (offset > found_.file_bytes || bytes > found_.file_bytes - offset)
            throw Error(CLEFT_ERROR_FORMAT,
                        what + " lies behind the end of the file: the file is cut short or damaged");
        std::vector<unsigned char> data(bytes);
        if (fseeko(file_.get(), static_cast<off_t>(offset), SEEK_SET) != 0 ||
            std::fread(data.data(), 1, bytes, file_.get()) != bytes)
            throw Error(CLEFT_ERROR_FILE, what + " cannot be read");
        return data;
    }

    uint64_t first_directory()
    {
        const std::vector<unsigned char> head = read(0, 8, "its header");
        found_.big_endian = head[0] == 'M';
        // 42 is TIFF 6.0. BigTIFF has 43, then the size of offsets (8) and two zero bytes.
        big_ = number(&head[2], 2) == 43;
        if (!big_)
            return number(&head[4], 4);
        if (number(&head[4], 2) != 8 || number(&head[6], 2) != 0)
            throw Error(CLEFT_ERROR_FORMAT, "its BigTIFF header is damaged");
        return number(read(8, 8, "its header").data(), 8);
    }

    // Returns where the next one begins.
    uint64_t directory(uint64_t offset, const std::string& page)
    {
        // TIFF 6.0, section 2: a directory is the number of entries, the entries of 12 bytes, and
        // the offset of the next. BigTIFF has wider numbers.
        const size_t count_bytes = big_ ? 8 : 2;
        const size_t entry_bytes = big_ ? 20 : 12;
        const uint64_t entries = number(read(offset, count_bytes, page).data(), count_bytes);
        if (entries == 0 || entries > kMostTags)
            throw Error(CLEFT_ERROR_FORMAT, page + " has " + std::to_string(entries) + " tags: the file is damaged");
        const uint64_t table_bytes = entries * entry_bytes;
        const std::vector<unsigned char> table = read(offset + count_bytes, table_bytes + (big_ ? 8 : 4), page);
        TiffDirectory made;
        for (uint64_t e = 0; e < entries; ++e)
            made.entries.push_back(entry(&table[e * entry_bytes], page));
        found_.list.push_back(std::move(made));
        return number(&table[table_bytes], big_ ? 8 : 4);
    }

    TiffEntry entry(const unsigned char* at, const std::string& page)
    {
        // Bytes of the types 1 to 12 of TIFF 6.0, 13 (IFD) and 16 to 18 of BigTIFF. 0: no such
        // type.
        constexpr std::array<uint8_t, 19> kSizes{0, 1, 1, 2, 4, 8, 1, 1, 2, 4, 8, 4, 8, 4, 0, 0, 8, 8, 8};
        const size_t inline_bytes = big_ ? 8 : 4;
        const uint64_t type = number(at + 2, 2);
        const uint64_t size = type < kSizes.size() ? kSizes[type] : 0;
        TiffEntry made;
        made.tag = static_cast<uint16_t>(number(at, 2));
        made.count = number(at + 4, inline_bytes);
        const unsigned char* place = at + 4 + inline_bytes;
        // BYTE, SHORT, LONG and LONG8. A value shorter than its field stands at the beginning of
        // it, in either order of bytes.
        const bool whole = type == 1 || type == 3 || type == 4 || type == 16;
        made.value = number(place, made.count == 1 && whole && size <= inline_bytes ? size : inline_bytes);
        // Longer data lie elsewhere, and the field has their offset.
        if (size != 0 && made.count > inline_bytes / size)
            check_data(made, size, page);
        // libtiff keeps a description of each unknown tag, and looks for it one by one.
        tags_.insert(made.tag);
        if (tags_.size() > kMostTags)
            throw Error(CLEFT_ERROR_FORMAT,
                        "it has more than " + std::to_string(kMostTags) + " kinds of tags: the file is damaged");
        return made;
    }

    // Data of tags may be shared by pages, but not so often that reading them takes for ever.
    void check_data(const TiffEntry& entry, uint64_t size, const std::string& page)
    {
        // Some writers give all pages one description. 16 times the file is far beyond that; the
        // slack is for small files.
        constexpr uint64_t kMostShares = 16;
        constexpr uint64_t kSlack = uint64_t{1} << 20;
        if (entry.value > found_.file_bytes || entry.count > (found_.file_bytes - entry.value) / size)
            throw Error(CLEFT_ERROR_FORMAT, "tag " + std::to_string(entry.tag) + " of " + page +
                                                " lies behind the end of the file: the file is cut short or damaged");
        tag_bytes_ += entry.count * size;
        if (tag_bytes_ > kMostShares * found_.file_bytes + kSlack)
            throw Error(CLEFT_ERROR_FORMAT, "the tags of its pages lie over each other: the file is damaged");
    }

    std::unique_ptr<std::FILE, int (*)(std::FILE*)> file_;
    TiffDirectories found_;
    bool big_ = false;
    std::set<uint16_t> tags_;
    uint64_t tag_bytes_ = 0;
};

}  // namespace

bool TiffDirectory::has(uint16_t tag) const { return count(tag) != 0; }

uint64_t TiffDirectory::count(uint16_t tag) const
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const TiffEntry& entry) { return entry.tag == tag; });
    return found == entries.end() ? 0 : found->count;
}

uint64_t TiffDirectory::value(uint16_t tag, uint64_t otherwise) const
{
    const auto found =
        std::find_if(entries.begin(), entries.end(), [&](const TiffEntry& entry) { return entry.tag == tag; });
    return found == entries.end() || found->count != 1 ? otherwise : found->value;
}

// Tag 254 has bits, its forerunner 255 has numbers.
bool TiffDirectory::is_thumbnail() const { return (value(254, 0) & 1) != 0 || value(255, 1) == 2; }

bool TiffDirectory::is_mask() const { return (value(254, 0) & 4) != 0; }

TiffDirectories tiff_directories(const std::string& path) { return Walker(path).walk(); }

}  // namespace cleft::io
