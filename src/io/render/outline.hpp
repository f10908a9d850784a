// Edges at which what is drawn ends: beyond them lies what is farther away, or nothing.
#pragma once

#include "io/render/drawn_faces.hpp"

namespace cleft::io
{

// Three numbers a face: 1 if no other face that is drawn has the edge from corner e to the next one.
Array<char> outline_edges(const Array<DrawnFace>& faces, int64_t point_count, const Run& run);

}  // namespace cleft::io
