// POINT_DATA and CELL_DATA of legacy VTK: what arrays there are, of which type, and where their values begin.
#include "io/vtk_arrays.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/header_values.hpp"

#include <algorithm>
#include <map>

namespace cleft::io
{

namespace
{

struct VtkType {
    bool is_bit = false;
    bool is_numeric = true;
    Component component = Component::uint8;
};

// `long` has the size that it has on all systems but Windows. VTK writes its ids as 32-bit numbers.
VtkType type_named(const std::string& name)
{
    // dataType of "VTK File Formats" and the names of fixed size that newer versions of VTK write.
    // vtkIdType is written as int.
    static const std::map<std::string, Component> numbers{
        {"unsigned_char", Component::uint8}, {"char", Component::int8},
        {"signed_char", Component::int8},    {"unsigned_short", Component::uint16},
        {"short", Component::int16},         {"unsigned_int", Component::uint32},
        {"int", Component::int32},           {"unsigned_long", Component::uint64},
        {"long", Component::int64},          {"unsigned_long_long", Component::uint64},
        {"long_long", Component::int64},     {"vtkidtype", Component::int32},
        {"vtktypeint8", Component::int8},    {"vtktypeuint8", Component::uint8},
        {"vtktypeint16", Component::int16},  {"vtktypeuint16", Component::uint16},
        {"vtktypeint32", Component::int32},  {"vtktypeuint32", Component::uint32},
        {"vtktypeint64", Component::int64},  {"vtktypeuint64", Component::uint64},
        {"float", Component::float32},       {"double", Component::float64}};
    const std::string small = in_small_letters(name);
    VtkType type;
    if (small == "bit") {
        type.is_bit = true;
        return type;
    }
    if (small == "string") {
        type.is_numeric = false;
        return type;
    }
    const auto found = numbers.find(small);
    if (found == numbers.end())
        // An unknown type has an unknown size, so that the arrays behind it could not be found.
        throw Error(CLEFT_ERROR_FORMAT, "its type of values '" + name.substr(0, 40) + "' cannot be read");
    type.component = found->second;
    return type;
}

// Counts and components come from the file.
int64_t product(int64_t a, int64_t b)
{
    int64_t result = 0;
    if (__builtin_mul_overflow(a, b, &result))
        throw Error(CLEFT_ERROR_TOO_LARGE, "there are too many values");
    return result;
}

void skip_words(TextSource& source, int64_t count)
{
    for (int64_t i = 0; i < count; ++i)
        if (source.word().empty())
            throw Error(CLEFT_ERROR_FORMAT,
                        "it ends too early: " + counted(count - i, "value is", "values are") + " missing");
}

// A line of text each, or in binary files a length of one to eight bytes and the text.
void skip_strings(TextSource& source, bool binary, int64_t count)
{
    std::string line;
    for (int64_t i = 0; i < count; ++i) {
        if (!binary) {
            if (!source.next_line(line))
                throw Error(CLEFT_ERROR_FORMAT, "it ends within an array of texts");
            continue;
        }
        unsigned char first = 0;
        source.read(&first, 1);
        // VTK writes a length in 1, 2, 4 or 8 bytes. The two highest bits of the first byte tell
        // which: 3 for one byte, 0 for eight.
        uintmax_t length = first & 0x3f;
        for (int more = (1 << (3 - (first >> 6))) - 1; more > 0; --more) {
            unsigned char byte = 0;
            source.read(&byte, 1);
            length = length << 8 | byte;
        }
        source.skip(length);
    }
}

// Values are passed over without being stored, so that a file with many arrays costs memory for
// one.
void skip_values(TextSource& source, bool binary, const VtkType& type, int64_t count)
{
    if (!type.is_numeric)
        skip_strings(source, binary, count);
    else if (!binary)
        skip_words(source, count);
    else if (type.is_bit)
        source.skip(static_cast<uintmax_t>(count / 8 + (count % 8 > 0)));
    else
        source.skip(static_cast<uintmax_t>(product(count, static_cast<int64_t>(size_of(type.component)))));
}

// Goes through POINT_DATA and CELL_DATA once and notes where each array begins.
class ArrayFinder
{
public:
    ArrayFinder(TextSource& source, bool binary, int64_t points, int64_t cells)
        : source_(source), binary_(binary), points_(points), cells_(cells)
    {
    }

    std::vector<VtkArray> find()
    {
        for (std::string keyword = take(); !keyword.empty(); keyword = take())
            take_attribute(in_small_letters(keyword), keyword);
        return std::move(arrays_);
    }

private:
    std::string take() { return std::string(source_.word()); }

    // The next word, which must be there.
    std::string name(const char* what)
    {
        std::string word = take();
        if (word.empty())
            throw Error(CLEFT_ERROR_FORMAT, std::string("it ends where ") + what + " is wanted");
        return word;
    }

    void end_line()
    {
        // In binary files the values begin behind this line, so nothing on it may be left unread.
        if (!source_.rest_is_blank())
            throw Error(CLEFT_ERROR_FORMAT, "there is more on a line of it than is known");
    }

    void take_attribute(const std::string& keyword, const std::string& shown)
    {
        // Attributes with a fixed number of components ("VTK File Formats", dataset attributes).
        static const std::map<std::string, int64_t> fixed{{"vectors", 3},   {"normals", 3},    {"tensors", 9},
                                                          {"tensors6", 6},  {"global_ids", 1}, {"pedigree_ids", 1},
                                                          {"edge_flags", 1}};
        if (keyword == "point_data" || keyword == "cell_data")
            begin_section(keyword == "cell_data");
        else if (keyword == "scalars")
            take_scalars();
        else if (keyword == "lookup_table")
            skip_table();
        else if (keyword == "color_scalars")
            take_colours();
        else if (keyword == "texture_coordinates")
            take_coordinates();
        else if (keyword == "field")
            take_field();
        else if (fixed.count(keyword) > 0)
            take_fixed(fixed.at(keyword), keyword == "global_ids" || keyword == "pedigree_ids");
        else
            throw Error(CLEFT_ERROR_FORMAT, "its keyword '" + shown.substr(0, 40) +
                                                "' is not known, or there are more values than it tells of");
    }

    void begin_section(bool on_cells)
    {
        on_cells_ = on_cells;
        tuples_ = vtk_count(source_, on_cells ? "CELL_DATA" : "POINT_DATA");
        const int64_t wanted = on_cells ? cells_ : points_;
        // The values would belong to other voxels than their order says.
        if (tuples_ != wanted)
            throw Error(CLEFT_ERROR_FORMAT, "its " + std::string(on_cells ? "CELL_DATA" : "POINT_DATA") + " are " +
                                                std::to_string(tuples_) + ", but its dimensions are " +
                                                std::to_string(wanted));
    }

    void add(const std::string& array_name, const VtkType& type, int64_t components)
    {
        VtkArray array;
        array.name = array_name;
        array.on_cells = on_cells_;
        array.tuples = tuples_;
        array.components = components;
        array.is_bit = type.is_bit;
        array.is_numeric = type.is_numeric;
        array.component = type.component;
        array.place = source_.position();
        skip_values(source_, binary_, type, product(tuples_, components));
        skip_vtk_metadata(source_, components);
        arrays_.push_back(array);
    }

    // SCALARS name type [components], and mostly LOOKUP_TABLE name on the next line.
    void take_scalars()
    {
        const std::string array_name = name("a name of SCALARS");
        const VtkType type = type_named(name("a type of SCALARS"));
        std::string rest;
        source_.next_line(rest);
        // The number of components may be left out and is then 1.
        const std::string_view given = trimmed(rest);
        const int64_t components = given.empty() ? 1 : integer_of("SCALARS", given);
        if (components < 1 || components > 64)
            refuse_field("SCALARS", given, "so many numbers a voxel are not known");
        // Looked at and not read as a word: in a binary file the values may begin here.
        if (source_.next_is("LOOKUP_TABLE") || source_.next_is("lookup_table"))
            source_.next_line(rest);
        add(array_name, type, components);
    }

    void take_fixed(int64_t components, bool is_id)
    {
        const std::string array_name = name("a name");
        const VtkType type = type_named(name("a type"));
        end_line();
        add(array_name, type, components);
        // Ids number the points or cells and are never labels, whatever their values are.
        arrays_.back().is_id = is_id;
    }

    void take_colours()
    {
        const std::string array_name = name("a name of COLOR_SCALARS");
        const int64_t components = vtk_count(source_, "COLOR_SCALARS");
        end_line();
        // VtkType{} is of bytes, which is how binary files store colours.
        add(array_name, VtkType{}, components);
        arrays_.back().is_colour = true;
    }

    void take_coordinates()
    {
        const std::string array_name = name("a name of TEXTURE_COORDINATES");
        const int64_t components = vtk_count(source_, "TEXTURE_COORDINATES");
        const VtkType type = type_named(name("a type"));
        end_line();
        add(array_name, type, components);
    }

    void skip_table()
    {
        name("a name of LOOKUP_TABLE");
        const int64_t colours = vtk_count(source_, "LOOKUP_TABLE");
        end_line();
        // A table has four numbers, red, green, blue and alpha, for each colour.
        skip_values(source_, binary_, VtkType{}, product(colours, 4));
    }

    void take_field()
    {
        name("a name of FIELD");
        const int64_t count = vtk_count(source_, "FIELD");
        for (int64_t i = 0; i < count; ++i) {
            const std::string array_name = name("an array of FIELD");
            const int64_t components = vtk_count(source_, "FIELD");
            const int64_t tuples = vtk_count(source_, "FIELD");
            const VtkType type = type_named(name("a type"));
            end_line();
            // An array of another length belongs to neither points nor cells.
            if (tuples != tuples_)
                throw Error(CLEFT_ERROR_FORMAT, "its array '" + array_name.substr(0, 40) + "' has " +
                                                    counted(tuples, "value") + ", but " +
                                                    counted(tuples_, "is wanted", "are wanted"));
            add(array_name, type, components);
        }
    }

    TextSource& source_;
    bool binary_;
    int64_t points_;
    int64_t cells_;
    bool on_cells_ = false;
    int64_t tuples_ = 0;
    std::vector<VtkArray> arrays_;
};

}  // namespace

int64_t vtk_count(TextSource& source, const char* what)
{
    const int64_t count = integer_of(what, source.word());
    if (count < 0)
        refuse_field(what, std::to_string(count), "it must not be negative");
    return count;
}

Component vtk_number_type(const std::string& type)
{
    const VtkType found = type_named(type);
    if (found.is_bit || !found.is_numeric)
        throw Error(CLEFT_ERROR_FORMAT, "its coordinates are of the type '" + type + "'; numbers are wanted");
    return found.component;
}

void skip_vtk_metadata(TextSource& source, int64_t components)
{
    if (in_small_letters(source.peek()) != "metadata")
        return;
    source.word();
    std::string line;
    source.next_line(line);  // the rest of its own
    while (source.next_line(line) && !trimmed(line).empty())
        if (in_small_letters(trimmed(line)) == "component_names")
            // A component without a name has an empty line, which does not end the block.
            for (int64_t i = 0; i < components && source.next_line(line); ++i)
                ;
}

void skip_vtk_field(TextSource& source, bool binary)
{
    source.word();
    const int64_t count = vtk_count(source, "FIELD");
    for (int64_t i = 0; i < count; ++i) {
        source.word();
        const int64_t components = vtk_count(source, "FIELD");
        const int64_t tuples = vtk_count(source, "FIELD");
        const VtkType type = type_named(std::string(source.word()));
        source.rest_is_blank();
        skip_values(source, binary, type, product(components, tuples));
        skip_vtk_metadata(source, components);
    }
}

std::vector<VtkArray> find_vtk_arrays(TextSource& source, bool binary, int64_t points, int64_t cells)
{
    return ArrayFinder(source, binary, points, cells).find();
}

}  // namespace cleft::io
