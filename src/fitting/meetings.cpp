// Counts the materials at each point in one pass over the tetrahedra, up to three: more make no difference here.
#include "fitting/meetings.hpp"

namespace cleft
{

Meetings find_meetings(const LocalMesh& mesh, const Run& run)
{
    Meetings out(mesh.point_count(), Meeting::none);
    Array<std::array<Material, 2>> first_two(mesh.point_count());
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        run.check_at(t);
        if (!mesh.alive(t))
            continue;
        const Material m = mesh.material(t);
        for (const int32_t v : mesh.tet(t)) {
            Meeting& meeting = out[v];
            auto& [first, second] = first_two[v];
            if (meeting == Meeting::none) {
                meeting = Meeting::inside;
                first = m;
            } else if (meeting == Meeting::inside && m != first) {
                meeting = Meeting::interface;
                second = m;
            } else if (meeting == Meeting::interface && m != first && m != second) {
                meeting = Meeting::line;
            }
        }
    }
    return out;
}

}  // namespace cleft
