// Concludes from the values of the voxels, and from what the caller asks for, what files mean.
#include "io/meaning.hpp"

#include "base/error.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "io/field_shape.hpp"
#include "io/text_scanner.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

std::string different_text(const FieldValues& values)
{
    return values.different > FieldValues::kMany ? "more than " + std::to_string(FieldValues::kMany)
                                                 : std::to_string(values.different);
}

std::string range_text(const FieldValues& values)
{
    return number_text(values.least) + " to " + number_text(values.greatest);
}

[[noreturn]] void refuse(const Field& field, const std::string& sentence)
{
    throw Error(CLEFT_ERROR_FORMAT, field.who + ": " + sentence);
}

// Each refusal ends with the two ways out, in the words of the library and of the command.
constexpr const char* kAsk =
    "ask for kind labels (--as labels: rounded) or indicators (--as indicators: inside above 0)";

void note_rounding(const Field& field, std::vector<std::string>& notes)
{
    const FieldValues& values = field.values;
    if (values.not_whole > 0)
        notes.push_back(field.who + ": the labels of " + voxels_text(values.not_whole) +
                        " are not whole numbers, but up to " + number_text(values.greatest_off) +
                        " off: they are rounded to the nearest");
}

// The share of differing neighbours. It is a half in distances rounded to whole numbers, and near 1 in pictures.
constexpr double kBusy = 0.4;
// A function that is rounded takes as many values as this: two on each side, and 0.
constexpr int64_t kFewestDistances = 5;
// Pictures of 16 levels and fewer are taken for segmentations, as thresholding makes them.
constexpr int64_t kFewestGreys = 17;

// Whole numbers are labels, unless they change from voxel to voxel as nothing does that was segmented.
void check_label_map(const Field& field, std::vector<std::string>& notes)
{
    const FieldValues& values = field.values;
    // Few values are labels, whatever their pattern. The comparison of neighbours below takes a
    // pass over the field, so it comes second.
    if (values.different < (values.is_signed() ? kFewestDistances : kFewestGreys))
        return;
    const double differing = differing_neighbours(*field.image, field.index, values);
    // With few values the share alone does not decide: a fine pattern of labels differs everywhere,
    // too.
    if (differing < kBusy || (values.different < kFewestGreys && !goes_step_by_step(*field.image, field.index, values)))
        return;
    const std::string what = different_text(values) + " different whole numbers from " + range_text(values) + ", and " +
                             number_text(std::round(100 * differing)) + " % of its neighbouring voxels differ";
    // Negative numbers make three readings possible, so nothing is chosen. Without them it is no
    // signed function, and labels are read with a note.
    if (values.is_signed())
        refuse(field, "it may be a label map, a grey image or a distance function, with " + what + ": " + kAsk);
    notes.push_back(field.who + ": it looks like a grey image rather than a label map: it has " + what);
}

// A signed function has values on both sides of 0 that change from voxel to voxel.
void check_signed_function(const Field& field)
{
    // A function that is constant far from its boundary has a small share of differing neighbours,
    // but still thousands of values. Interpolated labels have fewer.
    constexpr int64_t kMany = 1000;
    const FieldValues& values = field.values;
    if (!values.is_signed())
        refuse(field, "it holds fractions from " + range_text(values) +
                          ", but neither whole labels nor a signed function (values below and above 0): " + kAsk);
    const bool smooth =
        values.different >= kFewestGreys && differing_neighbours(*field.image, field.index, values) >= kBusy;
    if (!smooth && values.different <= kMany)
        refuse(field, "it may be a label map or a function, with " + different_text(values) + " values from " +
                          range_text(values) + " that are not all whole numbers: " + kAsk);
    // Last, as it takes two passes over the field.
    if (rests_on_labels(*field.image, field.index, values))
        refuse(field, "it may be a label map that was interpolated, as many of its values from " + range_text(values) +
                          " lie near whole numbers or at 0, or a function: " + kAsk);
}

Meaning meaning_of_one(const Field& field, std::vector<std::string>& notes)
{
    if (!field.values.is_whole()) {
        check_signed_function(field);
        return Meaning::functions;
    }
    check_label_map(field, notes);
    note_rounding(field, notes);
    return Meaning::labels;
}

void note_one_side(const Field& field, std::vector<std::string>& notes)
{
    // Inside is where the function is above 0, so 0 counts as outside.
    if (field.values.least > 0 || field.values.greatest <= 0)
        notes.push_back(field.who + ": the function is " + (field.values.least > 0 ? "above" : "nowhere above") +
                        " 0 everywhere: there is one label alone");
}

[[noreturn]] void refuse_label_maps(const std::vector<Field>& fields, const Field& field)
{
    const std::string holds = field.who + " holds the whole numbers from " + range_text(field.values);
    const std::string functions =
        "as functions, of which the largest wins, they are read by kind \"indicators\" "
        "(--as indicators)";
    // One image for all fields: the frames of one file. The advice differs from that for several
    // files.
    if (fields.front().image == fields.back().image)
        throw Error(CLEFT_ERROR_FORMAT,
                    holds +
                        ", which are labels, and a label map has three dimensions: write one frame to a file of its "
                        "own (nibabel: image.slicer[..., 0]); " +
                        functions);
    throw Error(CLEFT_ERROR_FORMAT, holds +
                                        ", as a label map does, but one of several files is a mask (0 and one other "
                                        "number) or a function; " +
                                        functions);
}

// A constant is a function of one material everywhere, as users give for the background.
bool may_be_function(const FieldValues& values) { return !values.is_whole() || values.snapped_counts.size() == 1; }

// A shell that turns a pattern into names makes files of slices of what was meant as one volume.
void check_no_slices(const std::vector<Field>& fields)
{
    if (std::all_of(fields.begin(), fields.end(), [](const Field& field) { return field.image->dims[2] == 1; }))
        throw Error(CLEFT_ERROR_FORMAT, fields.front().who +
                                            " and the other files are single slices: as those of one volume, give one "
                                            "pattern in quotes, such as 'slices/*.png'; as masks or functions of one "
                                            "slice, ask for kind labels or indicators (--as labels, --as indicators)");
}

Meaning meaning_of_several(const std::vector<Field>& fields, cleft_io_kind kind, std::vector<std::string>& notes)
{
    if (kind == CLEFT_IO_KIND_AUTO && fields.front().image != fields.back().image)
        check_no_slices(fields);
    const auto is_mask = [](const Field& field) { return field.values.is_mask(); };
    // Masks first: 0 and 1 are also a label map and a function, but several files of them mean
    // masks with any kind.
    if (std::all_of(fields.begin(), fields.end(), is_mask)) {
        for (const Field& field : fields)
            note_rounding(field, notes);
        return Meaning::masks;
    }
    if (kind == CLEFT_IO_KIND_LABELS && fields.front().image != fields.back().image)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "a label map is one file (or masks: 0 and one other number), but there are "
                    "several, and " +
                        std::find_if_not(fields.begin(), fields.end(), is_mask)->who + " is no mask");
    for (const Field& field : fields)
        if (kind == CLEFT_IO_KIND_LABELS || (!is_mask(field) && !may_be_function(field.values)))
            refuse_label_maps(fields, field);
    return Meaning::functions;
}

}  // namespace

std::string voxels_text(int64_t count)
{
    std::string text = std::to_string(count);
    // Thousands are separated, as counts of voxels have seven digits and more.
    for (size_t at = text.size(); at > 3; at -= 3)
        text.insert(at - 3, ",");
    return text + (count == 1 ? " voxel" : " voxels");
}

void check_kind(cleft_io_kind kind)
{
    // Callers in C may pass any number.
    if (kind < CLEFT_IO_KIND_AUTO || kind > CLEFT_IO_KIND_INDICATORS)
        throw Error(CLEFT_ERROR_ARGUMENT, "there is no kind " + std::to_string(kind));
}

Source source_of(const std::string& path, Image image, bool may_pack)
{
    Source source{path, std::move(image), {}, {}};
    naming_file(path, [&] {
        for (int64_t f = 0; f < source.image.fields; ++f)
            source.values.push_back(values_of(source.image, f));
    });
    for (int64_t f = 0; may_pack && f < source.image.fields; ++f)
        if (const auto mask = PackedMask::of(source.image, f, source.values[static_cast<size_t>(f)]))
            source.masks.push_back(*mask);
    if (source.masks.size() == source.values.size())
        source.image.voxels.reset();
    else
        source.masks.clear();  // the voxels stay, which hold all fields
    return source;
}

void unpack(Source& source)
{
    if (source.masks.empty())
        return;
    allocate_voxels(source.image);
    for (size_t f = 0; f < source.masks.size(); ++f)
        source.masks[f].unpack(source.image, static_cast<int64_t>(f));
    source.masks.clear();
}

std::vector<Field> fields_of(const std::vector<Source>& sources)
{
    std::vector<Field> fields;
    for (const Source& source : sources)
        for (size_t f = 0; f < source.values.size(); ++f) {
            const auto index = static_cast<int64_t>(f);
            const std::string file = "'" + source.path + "'";
            const std::string who = source.values.size() > 1 ? "the " + ordinal(index) + " frame of " + file : file;
            const PackedMask* const mask = source.masks.empty() ? nullptr : &source.masks[f];
            fields.push_back({&source.image, index, who, source.values[f], mask});
        }
    return fields;
}

Meaning meaning_of(const std::vector<Field>& fields, cleft_io_kind kind, std::vector<std::string>& notes)
{
    const bool one = fields.size() == 1;
    // What the caller states is not judged, but reported where it makes one label of everything.
    if (kind == CLEFT_IO_KIND_INDICATORS) {
        if (one)
            note_one_side(fields.front(), notes);
        return Meaning::functions;
    }
    if (!one)
        return meaning_of_several(fields, kind, notes);
    if (kind == CLEFT_IO_KIND_AUTO)
        return meaning_of_one(fields.front(), notes);
    note_rounding(fields.front(), notes);
    return Meaning::labels;
}

}  // namespace cleft::io
