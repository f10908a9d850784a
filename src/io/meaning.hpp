// What the voxels of the files mean: labels, masks or functions. Nothing is guessed in silence: what is not certain is
// refused, or reported in a note.
#pragma once

#include "cleft/cleft_io.h"
#include "io/field_values.hpp"
#include "io/image.hpp"
#include "io/packed_mask.hpp"

#include <string>
#include <vector>

namespace cleft::io
{

enum class Meaning {
    labels,    // one field; rounded where its voxels are not quite whole
    masks,     // several fields of 0 and one other number
    functions  // one signed function, or several of which the largest wins
};

// A file with what it holds.
struct Source {
    std::string path;
    Image image;
    std::vector<FieldValues> values;  // of each field
    std::vector<PackedMask> masks;    // of each field, in place of the voxels of the image; or none
};

// Throws if a voxel is not finite. `may_pack`: masks are to need little memory, until unpack().
Source source_of(const std::string& path, Image image, bool may_pack);
// Gives the image its voxels back.
void unpack(Source& source);

// One field of a file.
// The source must outlive it.
struct Field {
    const Image* image;
    int64_t index;    // in the image
    std::string who;  // "'a.nii'", "the 3rd frame of 'a.nii'"
    FieldValues values;
    const PackedMask* mask;  // of the source; null: the voxels are in the image
};

// All fields of all files, in their order.
std::vector<Field> fields_of(const std::vector<Source>& sources);

// Notes are sentences that name the file. Throws Error(CLEFT_ERROR_FORMAT or CLEFT_ERROR_ARGUMENT).
Meaning meaning_of(const std::vector<Field>& fields, cleft_io_kind kind, std::vector<std::string>& notes);

// Throws if there is no such kind.
void check_kind(cleft_io_kind kind);

// A number of voxels, "1 voxel", "2 voxels".
std::string voxels_text(int64_t count);

}  // namespace cleft::io
