// Pictures as PNG files.
#pragma once

#include "base/run.hpp"
#include "io/render/canvas.hpp"

#include <string>

namespace cleft::io
{

// All or nothing. Without `has_cover` the file has three bytes a pixel; with it a fourth, the cover as opacity. The
// bytes do not depend on the threads of `run`. Throws Error(CLEFT_ERROR_FILE).
void write_png(const std::string& path, const Canvas& canvas, bool has_cover, const Run& run);

}  // namespace cleft::io
