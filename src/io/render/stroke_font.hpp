// Letters made of lines: text on pictures in any size, without a font of the system.
#pragma once

#include "io/render/canvas.hpp"

#include <string>

namespace cleft::io
{

// In pixels, of text whose capitals are `height` pixels high. Text is UTF-8; what is not ASCII shows as a question
// mark.
double text_width(const std::string& text, double height);

// Draws text that begins at `left` and stands on `base`, in pixels from the corner of the canvas. What is beyond the
// canvas is left out.
void draw_text(const std::string& text, double left, double base, double height, Colour colour, Canvas& canvas);

}  // namespace cleft::io
