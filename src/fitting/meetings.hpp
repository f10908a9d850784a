// How many materials meet at each point of a mesh.
#pragma once

#include "base/array.hpp"
#include "base/run.hpp"
#include "remeshing/local_mesh.hpp"

namespace cleft
{

enum class Meeting : uint8_t {
    none,       // a point that is in no tetrahedron
    inside,     // of one material
    interface,  // of two
    line        // of three or more: on a line where interfaces meet, or a corner
};

using Meetings = Array<Meeting>;  // by point

Meetings find_meetings(const LocalMesh& mesh, const Run& run);

}  // namespace cleft
