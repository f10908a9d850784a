// Addresses and sizes come from the file. Each is checked against the size of the file before it is used, and no
// structure is visited twice, so that damaged ones neither take memory nor lead in circles.
#include "io/hdf5_file.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/hdf5_cursor.hpp"

#include <algorithm>
#include <set>

namespace cleft::io
{

namespace
{

constexpr std::string_view kHdf5Mark("\x89HDF\r\n\x1a\n", 8);

struct HeaderBlock {
    uint64_t address, size;
};

// How a header writes its messages: by version, and whether it numbers them.
struct HeaderForm {
    bool is_second = false;
    bool has_order = false;
};

HeaderBlock first_block(const Hdf5File& file, uint64_t object, HeaderForm& form)
{
    // The longest beginning of a header: mark, version, flags, four times, two limits, a size of eight bytes.
    constexpr uint64_t kLongest = 34;
    file.check_extent(object, 16);
    const std::string beginning = file.bytes(object, std::min(kLongest, file.size() - object));
    Hdf5Cursor at(beginning);
    if (beginning.substr(0, 4) != "OHDR") {
        at.version(1, 1, "a header");
        at.skip(7);
        // The prefix is padded to 16 bytes.
        return {object + 16, at.number(4)};
    }
    at.skip(4);
    at.version(2, 2, "a header");
    const uint64_t flags = at.byte();
    form = {true, (flags & 0x04) != 0};
    at.skip((flags & 0x20 ? 16 : 0) + (flags & 0x10 ? 4 : 0));
    const uint64_t size = at.number(uint64_t{1} << (flags & 3));
    return {object + at.place(), size};
}

void take_messages(Hdf5Cursor at, HeaderForm form, std::vector<Hdf5Message>& messages, std::vector<HeaderBlock>& blocks)
{
    constexpr uint64_t kShared = 0x02;
    const size_t head_bytes = form.is_second ? (form.has_order ? 6 : 4) : 8;
    // What is left at the end is a gap.
    while (at.left() >= head_bytes) {
        const uint64_t type = at.number(form.is_second ? 1 : 2);
        const uint64_t size = at.number(2);
        const uint64_t flags = at.byte();
        at.skip(form.is_second ? (form.has_order ? 2 : 0) : 3);
        const std::string_view bytes = at.take(size);
        if (type == kHdf5Continuation) {
            Hdf5Cursor next(bytes);
            const uint64_t address = next.address();
            blocks.push_back({address, next.number(8)});
        } else if (type != 0) {
            if ((flags & kShared) && (type == kHdf5Datatype || type == kHdf5Dataspace || type == kHdf5Filters))
                throw Error(CLEFT_ERROR_UNSUPPORTED, "its data sets share types, which cannot be read");
            messages.push_back({type, std::string(bytes)});
        }
    }
}

}  // namespace

Hdf5File::Hdf5File(const std::string& path) : source_(path, Coding::plain), size_(source_.left()) { read_superblock(); }

void Hdf5File::read_superblock()
{
    // The longest one: that of version 1, with the entry of the root.
    constexpr uint64_t kSuperblockBytes = 100;
    const std::string bytes = this->bytes(0, std::min(kSuperblockBytes, size_));
    if (bytes.substr(0, kHdf5Mark.size()) != kHdf5Mark)
        throw Error(CLEFT_ERROR_FORMAT, "this is no HDF5 file");
    Hdf5Cursor at(bytes);
    at.skip(kHdf5Mark.size());
    const uint64_t version = at.version(0, 3, "a superblock");
    const bool is_old = version < 2;
    at.skip(is_old ? 4 : 0);
    const uint64_t address_bytes = at.byte(), length_bytes = at.byte();
    if (address_bytes != 8 || length_bytes != 8)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "its HDF5 addresses do not have 64 bits");
    at.skip(version == 0 ? 9 : version == 1 ? 13 : 1);
    if (at.address() != 0)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "its HDF5 addresses do not begin with the file");
    at.skip(8);
    const uint64_t end = at.address();
    if (end > size_)
        throw Error(
            CLEFT_ERROR_FORMAT,
            "it ends too early: " + counted(static_cast<int64_t>(end - size_), "byte is", "bytes are") + " missing");
    at.skip(is_old ? 16 : 0);
    root_ = at.address();
}

void Hdf5File::check_extent(uint64_t address, uint64_t count) const
{
    if (address > size_ || count > size_ - address)
        Hdf5Cursor::damaged();
}

std::string Hdf5File::bytes(uint64_t address, uint64_t count) const
{
    check_extent(address, count);
    std::string bytes(count, '\0');
    source_.read_at(address, bytes.data(), count);
    return bytes;
}

void Hdf5File::read(uint64_t address, uint64_t count, void* to) const
{
    check_extent(address, count);
    source_.read_at(address, to, count);
}

std::vector<Hdf5Message> Hdf5File::messages(uint64_t object) const
{
    HeaderForm form;
    std::vector<Hdf5Message> messages;
    std::vector<HeaderBlock> blocks{first_block(*this, object, form)};
    std::set<uint64_t> seen;
    for (size_t b = 0; b < blocks.size(); ++b) {
        const HeaderBlock block = blocks[b];
        if (!seen.insert(block.address).second)
            Hdf5Cursor::damaged();
        const std::string bytes = this->bytes(block.address, block.size);
        std::string_view text = bytes;
        if (form.is_second && b > 0) {
            Hdf5Cursor(text).expect("OCHK");
            // A checksum ends the block.
            text = text.substr(4, text.size() - std::min<size_t>(text.size(), 8));
        }
        take_messages(Hdf5Cursor(text), form, messages, blocks);
    }
    return messages;
}

void Hdf5File::visit_tree(uint64_t address, uint64_t type, uint64_t key_bytes, const LeafVisit& body) const
{
    std::set<uint64_t> seen;
    constexpr uint64_t kHeadBytes = 24;
    // Levels count down to the leaves, so the recursion is of 256 calls at most.
    const auto visit = [&](const auto& again, uint64_t node, uint64_t level_above) -> void {
        const std::string head = bytes(node, kHeadBytes);
        Hdf5Cursor at(head);
        at.expect("TREE");
        const uint64_t node_type = at.byte(), level = at.byte(), entries = at.number(2);
        if (node_type != type || level >= level_above || !seen.insert(node).second)
            Hdf5Cursor::damaged();
        const std::string pairs = bytes(node + kHeadBytes, entries * (key_bytes + 8));
        Hdf5Cursor pair(pairs);
        for (uint64_t i = 0; i < entries; ++i) {
            const std::string_view key = pair.take(key_bytes);
            const uint64_t child = pair.address();
            if (level > 0)
                again(again, child, level);
            else
                body(key, child);
        }
    };
    visit(visit, address, 256);
}

}  // namespace cleft::io
