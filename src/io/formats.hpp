// The table of formats: what is told to users, and what an extension stands for.
#pragma once

#include "cleft/cleft_io.h"

#include <string>

namespace cleft::io
{

int32_t format_count();
// `index` is in 0 .. format_count() - 1 and not checked. The rows live as long as the library.
const cleft_io_format_description& format_row(int32_t index);

// The row of a mesh format, or null.
const cleft_io_format_description* find_format(cleft_io_format format);
// The first mesh format that has the extension of the path and one of the directions, or null.
const cleft_io_format_description* format_of_path(const std::string& path, int32_t directions);
// Does a format of volumes have the extension of the path?
bool is_volume_path(const std::string& path);
// ".vtu .vtk ...": for messages.
std::string extensions_with(int32_t direction);

}  // namespace cleft::io
