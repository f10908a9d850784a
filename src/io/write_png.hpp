// Pictures as PNG files.
#pragma once

#include "io/render/canvas.hpp"

#include <string>

namespace cleft::io
{

// All or nothing. Without `has_cover` the file has three bytes a pixel; with it a fourth, the cover as opacity. Throws
// Error(CLEFT_ERROR_FILE).
void write_png(const std::string& path, const Canvas& canvas, bool has_cover);

}  // namespace cleft::io
