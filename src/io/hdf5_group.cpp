// Groups have two forms: a tree of names in a heap, which HDF5 writes by default, and links in the header.
#include "io/hdf5_group.hpp"

#include "base/error.hpp"
#include "io/hdf5_cursor.hpp"
#include "io/hdf5_values.hpp"

namespace cleft::io
{

namespace
{

using Members = std::map<std::string, uint64_t>;

// The text at an offset of a heap, which ends with a zero.
std::string name_in(const std::string& heap, uint64_t offset)
{
    const size_t end = offset < heap.size() ? heap.find('\0', offset) : std::string::npos;
    if (end == std::string::npos)
        Hdf5Cursor::damaged();
    return heap.substr(offset, end - offset);
}

std::string read_heap(const Hdf5File& file, uint64_t address)
{
    const std::string head = file.bytes(address, 32);
    Hdf5Cursor at(head);
    at.expect("HEAP");
    at.skip(4);
    const uint64_t size = at.number(8);
    at.skip(8);
    return file.bytes(at.address(), size);
}

void add_table_members(const Hdf5File& file, Hdf5Cursor message, Members& members)
{
    constexpr uint64_t kEntryBytes = 40;
    const uint64_t tree = message.address();
    const std::string heap = read_heap(file, message.address());
    file.visit_tree(tree, 0, 8, [&](std::string_view, uint64_t node) {
        const std::string head = file.bytes(node, 8);
        Hdf5Cursor at(head);
        at.expect("SNOD");
        at.skip(2);
        const uint64_t entries = at.number(2);
        const std::string table = file.bytes(node + 8, entries * kEntryBytes);
        for (Hdf5Cursor entry(table); entry.left() > 0; entry.skip(kEntryBytes - 16)) {
            const uint64_t name = entry.number(8);
            // What is linked by a path has no address.
            const uint64_t object = entry.address();
            if (object != kNoHdf5Address)
                members.emplace(name_in(heap, name), object);
        }
    });
}

void add_link(Hdf5Cursor at, Members& members)
{
    at.version(1, 1, "a link");
    const uint64_t flags = at.byte();
    const uint64_t type = flags & 0x08 ? at.byte() : 0;
    at.skip((flags & 0x04 ? 8 : 0) + (flags & 0x10 ? 1 : 0));
    const uint64_t length = at.number(uint64_t{1} << (flags & 3));
    const std::string name(at.take(length));
    if (type == 0)
        members.emplace(name, at.address());
}

void refuse_heap_of_links(Hdf5Cursor at)
{
    at.version(0, 0, "links");
    const uint64_t flags = at.byte();
    at.skip(flags & 0x01 ? 8 : 0);
    if (at.address() != kNoHdf5Address)
        throw Error(CLEFT_ERROR_UNSUPPORTED,
                    "a group has more than eight members in the newest form of HDF5, which cannot be read; write it "
                    "with the default settings of HDF5");
}

struct Attribute {
    Hdf5Type type;
    std::vector<uint64_t> dims;
    std::string_view value;
};

// False if it has another name.
bool get_attribute(const std::string& message, const std::string& wanted, Attribute& out)
{
    Hdf5Cursor at(message);
    const uint64_t version = at.version(1, 3, "an attribute");
    const uint64_t flags = at.byte();
    const uint64_t name_bytes = at.number(2), type_bytes = at.number(2), space_bytes = at.number(2);
    at.skip(version == 3 ? 1 : 0);
    // In version 1, each part is padded to eight bytes.
    const auto padded = [&](uint64_t bytes) { return version == 1 ? (bytes + 7) / 8 * 8 : bytes; };
    const std::string_view name = at.take(padded(name_bytes));
    if (name.substr(0, name.find('\0')) != wanted)
        return false;
    if (version > 1 && (flags & 3))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "the attribute '" + wanted + "' shares a type, which cannot be read");
    out.type = hdf5_type(Hdf5Cursor(at.take(padded(type_bytes))));
    out.dims = hdf5_dims(Hdf5Cursor(at.take(padded(space_bytes))));
    out.value = at.take(at.left());
    return true;
}

// The bytes of the attribute belong to the messages.
Attribute find_attribute(const std::vector<Hdf5Message>& messages, const std::string& name)
{
    Attribute attribute;
    for (const Hdf5Message& message : messages)
        if (message.type == kHdf5Attribute && get_attribute(message.bytes, name, attribute))
            return attribute;
    throw Error(CLEFT_ERROR_FORMAT, "the attribute '" + name + "' is missing");
}

}  // namespace

Members hdf5_members(const Hdf5File& file, uint64_t group)
{
    Members members;
    for (const Hdf5Message& message : file.messages(group)) {
        const Hdf5Cursor at(message.bytes);
        if (message.type == kHdf5SymbolTable)
            add_table_members(file, at, members);
        else if (message.type == kHdf5Link)
            add_link(at, members);
        else if (message.type == kHdf5LinkInfo)
            refuse_heap_of_links(at);
    }
    return members;
}

std::string hdf5_text_attribute(const Hdf5File& file, uint64_t object, const std::string& name)
{
    const std::vector<Hdf5Message> messages = file.messages(object);
    const Attribute found = find_attribute(messages, name);
    if (found.type.kind != Hdf5Kind::text || hdf5_count(found.dims) != 1)
        throw Error(CLEFT_ERROR_FORMAT, "the attribute '" + name + "' is no text of fixed length");
    Hdf5Cursor value(found.value);
    const std::string text(value.take(found.type.bytes));
    // Filled up by zeros or by blanks.
    const std::string until_zero = text.substr(0, text.find('\0'));
    return until_zero.substr(0, until_zero.find_last_not_of(' ') + 1);
}

std::vector<int64_t> hdf5_integer_attribute(const Hdf5File& file, uint64_t object, const std::string& name)
{
    const std::vector<Hdf5Message> messages = file.messages(object);
    const Attribute found = find_attribute(messages, name);
    const uint64_t count = hdf5_count(found.dims);
    if (found.type.kind != Hdf5Kind::integer || count > found.value.size() / found.type.bytes)
        throw Error(CLEFT_ERROR_FORMAT, "the attribute '" + name + "' is no list of whole numbers");
    std::vector<int64_t> numbers(count);
    convert_hdf5(found.type, found.value.data(), count, numbers.data());
    return numbers;
}

}  // namespace cleft::io
