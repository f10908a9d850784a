// Letters made of lines: text on pictures in any size, without a font of the system.
#pragma once

#include "io/render/canvas.hpp"

#include <string>

namespace cleft::io
{

// Are there strokes for all letters of a text? It is UTF-8; what is not, and letters of other scripts than Latin and
// Greek, show as a question mark.
bool can_draw(const std::string& text);

// In pixels, of text whose capitals are `height` pixels high.
double text_width(const std::string& text, double height);

// Draws text that begins at `left` and stands on `base`, in pixels from the corner of the canvas. What is beyond the
// canvas is left out.
void draw_text(const std::string& text, double left, double base, double height, Colour colour, Canvas& canvas);

}  // namespace cleft::io
