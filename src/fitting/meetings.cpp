// Counts the materials at each point from its star, up to three: more make no difference here.
#include "fitting/meetings.hpp"

#include "base/parallel.hpp"

namespace cleft
{

namespace
{

// Points that a thread looks at. The number changes the time alone.
constexpr int64_t kPointsAtOnce = 4096;

Meeting meeting_at(const LocalMesh& mesh, int32_t v)
{
    Meeting meeting = Meeting::none;
    Material first = 0, second = 0;
    for (const int32_t t : mesh.star(v)) {
        const Material m = mesh.material(t);
        if (meeting == Meeting::none) {
            meeting = Meeting::inside;
            first = m;
        } else if (meeting == Meeting::inside && m != first) {
            meeting = Meeting::interface;
            second = m;
        } else if (meeting == Meeting::interface && m != first && m != second) {
            return Meeting::line;
        }
    }
    return meeting;
}

}  // namespace

Meetings find_meetings(const LocalMesh& mesh, const Run& run)
{
    Meetings out(mesh.point_count());
    parallel_for(run, mesh.point_count(), kPointsAtOnce, [&](int64_t begin, int64_t end) {
        for (auto v = static_cast<int32_t>(begin); v < end; ++v)
            out[v] = meeting_at(mesh, v);
    });
    return out;
}

}  // namespace cleft
