#include "fitting/meetings.hpp"

namespace cleft
{

Meetings find_meetings(const LocalMesh& mesh, const Run& run)
{
    const auto points = static_cast<size_t>(mesh.point_count());
    Meetings out(points, Meeting::none);
    std::vector<std::array<Material, 2>> first_two(points);
    for (int32_t t = 0; t < mesh.slot_count(); ++t) {
        run.check_at(t);
        if (!mesh.alive(t))
            continue;
        const Material m = mesh.material(t);
        for (const int32_t v : mesh.tet(t)) {
            Meeting& meeting = out[static_cast<size_t>(v)];
            auto& [first, second] = first_two[static_cast<size_t>(v)];
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
