// Takes the state of vertices out of centres, and puts it in again.
#include "cleaving/snapped.hpp"

#include "base/parallel.hpp"
#include "cleaving/split_tet.hpp"

namespace cleft
{

namespace
{

// The number changes the time alone.
constexpr int64_t kCutsRestored = 512;

}  // namespace

Snapped snapped_of(const Centres& c)
{
    Snapped out;
    for (int32_t v = 0; v < c.points.count(); ++v)
        if (c.materials_of(v).size() > 1 || c.doubtful[v])
            out.vertices.push_back({v, c.point(v), c.materials_of(v), c.doubtful[v] != 0});
    for (int32_t t = 0; t < c.kept.count(); ++t)
        if (c.kept[t] != Centres::kNoMaterial)
            out.kept.push_back({t, c.kept[t]});
    return out;
}

void restore_snapped(Centres& c, const Snapped& snapped, const Run& run)
{
    Samples samples;
    SampleArena& arena = c.samples.new_arena();
    Array<uint8_t> has_snapped(c.points.size(), 0);
    for (const SnappedVertex& s : snapped.vertices) {
        c.doubtful[s.vertex] = s.is_doubtful ? 1 : 0;
        if (s.materials.size() < 2)
            continue;
        has_snapped[s.vertex] = 1;
        c.points[s.vertex] = s.x;
        c.materials[s.vertex] = s.materials;
        c.volume.sample(s.x, samples);
        c.samples.set(s.vertex, arena.add(samples));
    }
    for (const Snapped::Kept& kept : snapped.kept)
        c.kept[kept.tet] = kept.material;
    parallel_for(run, c.edges.count(), kCutsRestored, [&](int64_t begin, int64_t end) {
        Samples scratch;
        for (int64_t i = begin; i < end; ++i) {
            CutEdge& e = c.edges[i];
            if (has_snapped[e.lower] || has_snapped[e.upper])
                c.renew_cut(e, scratch);
        }
    });
    choose_fans(c, run);
}

}  // namespace cleft
