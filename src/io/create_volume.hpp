// The volume of the core that files stand for.
#pragma once

#include "cleft/cleft_io.h"
#include "io/meaning.hpp"

namespace cleft::io
{

// Hands a sentence about an input to the log of the context, as a warning.
// The sentence names the file. Throws Error where the context refuses it.
void report(cleft_context* context, const std::string& sentence);

// `sources` lie on one grid, that of `affine`. Their voxels are changed or freed. Notes on what they mean are reported.
// *out receives a handle that the caller owns. Throws Error with the file's name in it, or
// std::bad_alloc.
void create_volume(cleft_context* context, const cleft_options* options, std::vector<Source>& sources,
                   const std::array<double, 12>& affine, cleft_io_kind kind, cleft_volume** out);

}  // namespace cleft::io
