// Reads the fields of a MetaImage as text, and judges those that have several names or are not known.
#include "io/metaimage_header.hpp"

#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/header_values.hpp"
#include "io/text_source.hpp"

#include <algorithm>
#include <iterator>
#include <string_view>

namespace cleft::io
{

namespace
{

// Fields that are not taken for misspelt ones.
constexpr std::string_view kKnownFields[] = {
    // read here
    "ObjectType", "NDims", "DimSize", "ElementType", "ElementNumberOfChannels", "ElementSpacing", "ElementSize",
    "Offset", "Position", "Origin", "TransformMatrix", "Rotation", "Orientation", "BinaryData",
    "BinaryDataByteOrderMSB", "ElementByteOrderMSB", "CompressedData", "CompressedDataSize", "HeaderSize",
    "ElementDataFile", "ElementToIntensityFunctionSlope", "ElementToIntensityFunctionOffset",
    "ElementToIntensityFunctionIntercept",
    // of MetaIO, and say nothing of voxels and places
    "ObjectSubType", "Comment", "TransformType", "Name", "ID", "ParentID", "Color", "CenterOfRotation",
    "AnatomicalOrientation", "Modality", "SequenceID", "ElementMin", "ElementMax", "ElementNBits", "CompressionLevel",
    "DistanceUnits", "AcquisitionDate"};

}  // namespace

bool is_meta_list(const std::string& value) { return value.substr(0, 4) == "LIST"; }

MetaHeader read_meta_header(const std::string& path)
{
    TextSource source(path);
    MetaHeader header;
    std::string line;
    // ElementDataFile is the last field by definition: binary data follow it in .mha files.
    while (header.fields.count("ElementDataFile") == 0) {
        if (!source.next_line(line))
            throw Error(CLEFT_ERROR_FORMAT, "its header has no field 'ElementDataFile', or is cut short");
        if (source.position() > kLongestTextHeader)
            throw Error(CLEFT_ERROR_FORMAT, "its header has no end");
        if (trimmed(line).empty())
            continue;
        const size_t sign = line.find('=');
        const std::string key(trimmed(line.substr(0, sign)));
        if (sign == std::string::npos || key.empty())
            throw Error(CLEFT_ERROR_FORMAT, "the line '" + line.substr(0, 40) + "' of its header is no field");
        const std::string value(trimmed(line.substr(sign + 1)));
        // Of two values nobody knows the right one. Comments may be repeated.
        if (!header.fields.emplace(key, value).second && key != "Comment")
            refuse_field(key, value, "it stands there twice");
    }
    header.end = source.position();
    // Behind LIST, the names of the files follow, one a line.
    if (is_meta_list(header.fields["ElementDataFile"]))
        while (source.next_line(line))
            if (!trimmed(line).empty())
                header.list.emplace_back(trimmed(line));
    return header;
}

bool meta_truth_of(const MetaFields& fields, const std::string& key, bool otherwise)
{
    const auto found = fields.find(key);
    if (found == fields.end())
        return otherwise;
    const std::string value = in_small_letters(found->second);
    if (value == "true" || value == "t" || value == "1" || value == "yes")
        return true;
    if (value == "false" || value == "f" || value == "0" || value == "no")
        return false;
    refuse_field(key, found->second, "True or False is wanted");
}

const MetaFields::value_type* one_meta_field(const MetaFields& fields, std::initializer_list<const char*> keys)
{
    // Two that differ leave the place of the voxels open.
    const MetaFields::value_type* first = nullptr;
    for (const char* key : keys) {
        const auto found = fields.find(key);
        if (found == fields.end())
            continue;
        if (first && words_of(first->second) != words_of(found->second))
            refuse_field(key, found->second, "'" + first->first + "' says otherwise");
        if (!first)
            first = &*found;
    }
    return first;
}

void note_unknown_fields(const MetaFields& fields, std::vector<std::string>& notes)
{
    const auto is_known = [](const std::string& key) {
        return std::find(std::begin(kKnownFields), std::end(kKnownFields), key) != std::end(kKnownFields);
    };
    std::string names;
    size_t count = 0;
    for (const auto& [key, value] : fields)
        if (!is_known(key) && ++count <= 3)
            names += (names.empty() ? "'" : ", '") + key.substr(0, 40) + "'";
    if (count > 0)
        notes.push_back("fields of its header are not known, and not used: " + names +
                        (count > 3 ? " and " + std::to_string(count - 3) + " more" : ""));
}

}  // namespace cleft::io
