// Takes the header of an NRRD file apart, field by field. What is not known is refused by its name.
#include "io/nrrd_header.hpp"

#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/header_values.hpp"
#include "io/text_source.hpp"

#include <algorithm>
#include <set>

namespace cleft::io
{

namespace
{

// NRRD_DIM_MAX of teem, which defines the format.
constexpr size_t kMostAxes = 16;
struct TypeName {
    Component component;
    std::vector<std::string_view> names;
};

// All names of "type" in the NRRD definition but "block", which has no numbers. "long" is not among
// them, as its size differs between systems.
const std::vector<TypeName>& type_names()
{
    static const std::vector<TypeName> all{
        {Component::int8, {"signed char", "int8", "int8_t"}},
        {Component::uint8, {"uchar", "unsigned char", "uint8", "uint8_t"}},
        {Component::int16, {"short", "short int", "signed short", "signed short int", "int16", "int16_t"}},
        {Component::uint16, {"ushort", "unsigned short", "unsigned short int", "uint16", "uint16_t"}},
        {Component::int32, {"int", "signed int", "int32", "int32_t"}},
        {Component::uint32, {"uint", "unsigned int", "uint32", "uint32_t"}},
        {Component::int64,
         {"longlong", "long long", "long long int", "signed long long", "signed long long int", "int64", "int64_t"}},
        {Component::uint64, {"ulonglong", "unsigned long long", "unsigned long long int", "uint64", "uint64_t"}},
        {Component::float32, {"float"}},
        {Component::float64, {"double"}}};
    return all;
}

Component component_named(const std::string& value)
{
    // The definition has one blank between words; hand-written headers have several.
    std::string name;  // with single blanks
    for (const std::string& word : words_of(in_small_letters(value)))
        name += (name.empty() ? "" : " ") + word;
    for (const TypeName& row : type_names())
        if (std::find(row.names.begin(), row.names.end(), name) != row.names.end())
            return row.component;
    refuse_field("type", value, "such voxels cannot be read");
}

VoxelData::Encoding encoding_named(const std::string& value)
{
    // bzip2 ("bz2") is part of the format. It is refused by the message below.
    const std::string name = in_small_letters(value);
    if (name == "raw")
        return VoxelData::Encoding::raw;
    if (name == "gz" || name == "gzip")
        return VoxelData::Encoding::deflated;
    if (name == "txt" || name == "text" || name == "ascii")
        return VoxelData::Encoding::text;
    if (name == "hex")
        return VoxelData::Encoding::hex;
    refuse_field("encoding", value, "raw, gzip, text and hex can be read");
}

class HeaderReader
{
public:
    explicit HeaderReader(const std::string& path) : path_(path), source_(path) {}

    NrrdHeader read()
    {
        std::string line;
        source_.next_line(line);
        // "NRRD000" and the version. Later versions only added fields, but an unknown one could
        // change the meaning of what follows.
        const bool known = line.size() == 8 && line.substr(0, 7) == "NRRD000" && line[7] >= '1' && line[7] <= '5';
        if (!known)
            throw Error(CLEFT_ERROR_FORMAT, "its version of NRRD, '" + line.substr(0, 12) + "', cannot be read");
        bool attached = false;
        // An empty line ends an attached header. "data file: LIST" ends it, too: the rest of the
        // file is names.
        while (!attached && !list_ && source_.next_line(line)) {
            attached = line.empty();
            if (!attached)
                take_line(line);
            // A binary file that begins with NRRD by chance, or by intent, must not be read to its
            // end in memory.
            if (source_.position() > kLongestTextHeader)
                throw Error(CLEFT_ERROR_FORMAT, "its header has no end");
        }
        if (list_)
            while (source_.next_line(line))
                if (!trimmed(line).empty())
                    header_.data.files.push_back(beside(path_, std::string(trimmed(line))));
        finish(attached);
        return std::move(header_);
    }

private:
    void take_line(const std::string& line)
    {
        // A comment.
        if (line[0] == '#')
            return;
        const size_t colon = line.find(':');
        if (colon == std::string::npos || colon == 0)
            throw Error(CLEFT_ERROR_FORMAT, "the line '" + line.substr(0, 40) + "' of its header is no field");
        // "key:=value" is a key/value pair and no field: anybody may add them.
        if (colon + 1 < line.size() && line[colon + 1] == '=') {
            header_.keys[line.substr(0, colon)] = line.substr(colon + 2);
            return;
        }
        std::string field;  // both "line skip" and "lineskip" are written
        for (const std::string& word : words_of(in_small_letters(line.substr(0, colon))))
            field += word;
        const std::string value(trimmed(line.substr(colon + 1)));
        // Of two values nobody knows the right one.
        if (!seen_.insert(field).second)
            refuse_field(line.substr(0, colon), value, "it stands there twice");
        // A field that is not known may change where voxels are or what they mean, so it is not
        // skipped.
        if (!take_layout(field, value) && !take_axes(field, value) && !take_space(field, value) && !is_ignored(field))
            refuse_field(line.substr(0, colon), value, "this field is not known");
    }

    // Where and how the voxels are stored. These three functions answer false if the field is none
    // of theirs.
    bool take_layout(const std::string& field, const std::string& value)
    {
        if (field == "dimension")
            take_dimension(value);
        else if (field == "type")
            header_.component = component_named(value);
        else if (field == "encoding")
            header_.data.encoding = encoding_named(value);
        else if (field == "endian")
            take_endian(value);
        else if (field == "lineskip")
            header_.data.lines = integer_of("line skip", value);
        else if (field == "byteskip")
            header_.data.skip = integer_of("byte skip", value);
        else if (field == "datafile")
            take_data_file(value);
        else
            return false;
        return true;
    }

    bool take_axes(const std::string& field, const std::string& value)
    {
        if (field == "sizes")
            header_.sizes = integers_of("sizes", value, axes(field));
        else if (field == "spacings")
            header_.spacings = reals_of("spacings", value, axes(field));
        else if (field == "axismins")
            header_.mins = reals_of("axis mins", value, axes(field));
        else if (field == "axismaxs")
            header_.maxs = reals_of("axis maxs", value, axes(field));
        else if (field == "centers" || field == "centerings")
            header_.centers = axis_words("centers", value);
        else if (field == "kinds")
            header_.kinds = axis_words("kinds", value);
        else
            return false;
        return true;
    }

    bool take_space(const std::string& field, const std::string& value)
    {
        if (field == "space") {
            header_.space = in_small_letters(value);
        } else if (field == "spacedimension") {
            header_.space_dimension = static_cast<size_t>(integer_of("space dimension", value));
        } else if (field == "spaceorigin") {
            auto vectors = nrrd_vectors("space origin", value);
            if (vectors.size() != 1 || !vectors[0])
                refuse_field("space origin", value, "one vector is wanted");
            header_.origin = *vectors[0];
        } else if (field == "spacedirections") {
            header_.directions = nrrd_vectors("space directions", value);
            if (header_.directions.size() != axes(field))
                refuse_field("space directions", value, "a vector for each axis is wanted");
        } else if (field == "measurementframe") {
            // It matters to tensors alone, and is not judged in other files.
            header_.measurement_frame = value;
        } else {
            return false;
        }
        return true;
    }

    // What does not change which voxel has which label, or where it is.
    bool is_ignored(const std::string& field)
    {
        // They map quantized values back to real ones. A label map was never quantized; the note
        // comes once for both.
        if ((field == "oldmin" || field == "oldmax") && seen_.count("oldmin") + seen_.count("oldmax") == 1)
            header_.notes.emplace_back("its fields 'old min' and 'old max' are not applied to the voxels");
        // "min" and "max" are of the values. Units and thicknesses do not change the places of
        // voxels.
        static const std::set<std::string> ignored{"content", "number",     "sampleunits", "min",    "max",  "oldmin",
                                                   "oldmax",  "spaceunits", "thicknesses", "labels", "units"};
        return ignored.count(field) > 0;
    }

    void take_dimension(const std::string& value)
    {
        const int64_t dimension = integer_of("dimension", value);
        if (dimension < 1 || dimension > static_cast<int64_t>(kMostAxes))
            refuse_field("dimension", value, "there are 1 to " + std::to_string(kMostAxes));
        dimension_ = static_cast<size_t>(dimension);
    }

    void take_endian(const std::string& value)
    {
        const std::string name = in_small_letters(value);
        if (name != "little" && name != "big")
            refuse_field("endian", value, "little or big is wanted");
        header_.data.big_endian = name == "big";
    }

    void take_data_file(const std::string& value)
    {
        const std::vector<std::string> words = words_of(value);
        if (words.empty())
            refuse_field("data file", value, "a name is wanted");
        // "LIST [<subdim>]": names follow, one a line.
        if (words[0] == "LIST" && words.size() <= 2) {
            list_ = true;
            if (words.size() == 2)
                file_axes_ = integer_of("data file", words[1]);
            // "<format> <min> <max> <step> [<subdim>]". A plain name may have blanks and "%", so the
            // number of words decides, too.
        } else if (value.find('%') != std::string::npos && (words.size() == 4 || words.size() == 5)) {
            for (const std::string& name :
                 names_of_pattern("data file", words[0], integer_of("data file", words[1]),
                                  integer_of("data file", words[2]), integer_of("data file", words[3])))
                header_.data.files.push_back(beside(path_, name));
            if (words.size() == 5)
                file_axes_ = integer_of("data file", words[4]);
            many_ = true;
        } else {
            header_.data.files.push_back(beside(path_, value));
        }
    }

    // The NRRD definition puts "dimension" before all fields with a value for each axis.
    size_t axes(const std::string& field) const
    {
        if (dimension_ == 0)
            throw Error(CLEFT_ERROR_FORMAT, "its field 'dimension' must come before '" + field + "'");
        return dimension_;
    }

    std::vector<std::string> axis_words(const char* field, const std::string& value)
    {
        std::vector<std::string> words = words_of(in_small_letters(value));
        if (words.size() != axes(field))
            refuse_field(field, value, "a word for each axis is wanted");
        return words;
    }

    void finish(bool attached)
    {
        for (const char* field : {"dimension", "type", "sizes", "encoding"})
            if (seen_.count(field) == 0)
                throw Error(CLEFT_ERROR_FORMAT, std::string("its header has no field '") + field + "'");
        VoxelData& data = header_.data;
        // Text has no order of bytes. For hexadecimal data it is that of the bytes that the digits
        // stand for.
        const bool binary = data.encoding != VoxelData::Encoding::text;
        if (binary && size_of(header_.component) > 1 && seen_.count("endian") == 0)
            throw Error(CLEFT_ERROR_FORMAT, "its header has no field 'endian'");
        for (const int64_t size : header_.sizes)
            // checked_bytes() would refuse it, but without the name of the field.
            if (size < 1)
                refuse_field("sizes", std::to_string(size), "an axis must have a voxel");
        if (data.lines < 0)
            refuse_field("line skip", std::to_string(data.lines), "it must not be negative");
        if (seen_.count("datafile") == 0) {
            if (!attached)
                throw Error(CLEFT_ERROR_FORMAT, "its header is cut short: it has no end, and names no data file");
            data.files.push_back(path_);
            data.attached = true;
            data.offset = static_cast<int64_t>(source_.position());
        }
        place_from_the_end();
        if (list_ || many_)
            check_file_axes();
    }

    void place_from_the_end()
    {
        VoxelData& data = header_.data;
        // "byte skip: -1" takes the last bytes of the file. In compressed data the end is not
        // known.
        if (data.skip < -1 || (data.skip == -1 && data.encoding != VoxelData::Encoding::raw))
            refuse_field("byte skip", std::to_string(data.skip), "it may be -1 for raw data, and not less");
        if (data.skip == -1) {
            data.offset = -1;
            data.skip = 0;
            data.lines = 0;
        }
    }

    // Each file holds all of the first so many axes; if it holds all axes, they share the last one.
    void check_file_axes()
    {
        const auto dimension = static_cast<int64_t>(dimension_);
        // The default of <subdim> is one axis less than there are: a file for each slice.
        const int64_t held = file_axes_ == 0 ? dimension - 1 : file_axes_;
        if (held < 1 || held > dimension)
            refuse_field("data file", std::to_string(held), "a file holds between one and all axes");
        int64_t wanted = 1;
        for (size_t axis = static_cast<size_t>(held); axis < dimension_; ++axis)
            if (__builtin_mul_overflow(wanted, header_.sizes[axis], &wanted))
                throw Error(CLEFT_ERROR_TOO_LARGE, "there are too many voxels");
        const auto files = static_cast<int64_t>(header_.data.files.size());
        const bool right = held < dimension ? files == wanted : files > 0 && header_.sizes.back() % files == 0;
        if (!right)
            throw Error(CLEFT_ERROR_FORMAT,
                        "it names " + std::to_string(files) + " data files, which its sizes cannot be shared among");
    }

    std::string path_;
    TextSource source_;
    NrrdHeader header_;
    std::set<std::string> seen_;
    size_t dimension_ = 0;
    bool list_ = false;
    bool many_ = false;
    int64_t file_axes_ = 0;
};

}  // namespace

std::vector<std::optional<std::vector<double>>> nrrd_vectors(const std::string& field, std::string_view value)
{
    std::vector<std::optional<std::vector<double>>> vectors;
    // Blanks may stand between and inside vectors, or be missing between them, so words alone do
    // not split the value.
    for (std::string_view rest = trimmed(value); !rest.empty(); rest = trimmed(rest)) {
        if (rest.substr(0, 4) == "none") {
            vectors.emplace_back();
            rest.remove_prefix(4);
            continue;
        }
        const size_t end = rest.find(')');
        if (rest[0] != '(' || end == std::string_view::npos)
            refuse_field(field, value, "vectors such as (1,0,0), or none, are wanted");
        std::vector<double> vector;
        std::string_view inside = rest.substr(1, end - 1);
        for (size_t comma = 0; comma != std::string_view::npos; inside.remove_prefix(comma + 1)) {
            comma = inside.find(',');
            vector.push_back(real_of(field, trimmed(inside.substr(0, comma))));
            if (comma == std::string_view::npos)
                break;
        }
        vectors.emplace_back(std::move(vector));
        rest.remove_prefix(end + 1);
    }
    return vectors;
}

NrrdHeader read_nrrd_header(const std::string& path) { return HeaderReader(path).read(); }

}  // namespace cleft::io
