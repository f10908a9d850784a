// Converts voxels to what the core takes, by what they mean, and hands them over.
#include "io/create_volume.hpp"

#include "base/error.hpp"
#include "io/entry.hpp"
#include "io/masks.hpp"
#include "io/text_scanner.hpp"
#include "io/voxel_access.hpp"
#include "io/voxels.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

using Affine = std::array<double, 12>;

// Names of labels that no voxel has are dropped.
void name_labels(cleft_context* context, const Image& image, cleft_volume* volume)
{
    // A segmentation lists all its segments, also those that were emptied. A name without voxels
    // would be refused by the core for another reason than its letters.
    const int32_t* const labels = cleft_volume_labels(volume);
    const int32_t* const end = labels + cleft_volume_label_count(volume);
    for (const auto& [label, name] : image.names)
        if (std::find(labels, end, label) != end &&
            // DICOM and NRRD do not guarantee UTF-8. A wrong name costs its label nothing else, so
            // it is reported and left out.
            cleft_volume_set_label_name(volume, label, name.c_str()) != CLEFT_OK)
            report(context, "the name of label " + std::to_string(label) + " is not UTF-8, and is left out");
}

void create_labels(cleft_context* context, const cleft_options* options, Image& image, const Affine& affine,
                   cleft_volume** out)
{
    make_labels(image);
    check(context, cleft_volume_create_labels(context, type_of(image.component), image.voxels.get(), image.dims.data(),
                                              affine.data(), options, out));
    name_labels(context, image, *out);
}

// One type for all: float, or double if one is double.
// The core takes one array type for all functions of a volume. Whole numbers become float; one file
// of double makes all of them double, so that it loses no digits.
void unify(std::vector<Source>& sources)
{
    bool wide = false;
    for (Source& source : sources) {
        unpack(source);
        make_floating(source.image);
        wide = wide || source.image.component == Component::float64;
    }
    if (wide)
        for (Source& source : sources)
            widen(source.image);
}

void create_functions(cleft_context* context, std::vector<Source>& sources, const Affine& affine, cleft_volume** out)
{
    unify(sources);
    std::vector<const void*> fields;
    // The fields of one file follow each other, so a file of four dimensions gives several
    // functions.
    for (const Source& source : sources)
        for (int64_t f = 0; f < source.image.fields; ++f)
            fields.push_back(source.image.voxels.get() +
                             static_cast<size_t>(f * source.image.field_size()) * size_of(source.image.component));
    const Image& first = sources.front().image;
    // The core's sentence speaks of functions by number. The path in front lets the user find the
    // file.
    const std::string who = "'" + sources.front().path + (sources.size() > 1 ? "' and others: " : "': ");
    check(context,
          cleft_volume_create_indicators(context, type_of(first.component), fields.data(),
                                         static_cast<int64_t>(fields.size()), first.dims.data(), affine.data(), nullptr,
                                         out),
          who.c_str());
}

}  // namespace

void report(cleft_context* context, const std::string& sentence)
{
    check(context, cleft_context_log(context, CLEFT_LOG_WARNING, sentence.c_str()));
}

void create_volume(cleft_context* context, const cleft_options* options, std::vector<Source>& sources,
                   const Affine& affine, cleft_io_kind kind, cleft_volume** out)
{
    std::vector<std::string> notes;
    // The fields point into `sources`, which must not be moved until the volume is made.
    const std::vector<Field> fields = fields_of(sources);
    const Meaning meaning = meaning_of(fields, kind, notes);
    Image masks;
    if (meaning == Meaning::masks) {
        masks = label_map_of_masks(fields, notes);
        sources.clear();  // frees their voxels before the volume takes memory
    }
    // Notes are reported before the volume is made, so that they also explain a failure that follows.
    for (const std::string& note : notes)
        report(context, note);
    if (meaning == Meaning::functions)
        create_functions(context, sources, affine, out);
    else if (meaning == Meaning::masks)
        create_labels(context, options, masks, affine, out);
    else
        naming_file(sources.front().path, [&] { create_labels(context, options, sources.front().image, affine, out); });
}

}  // namespace cleft::io
