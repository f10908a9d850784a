// Making the tables of centres: sample the vertices, list the cut edges, then the simplices above them.
#include "cleaving/find_centres.hpp"

#include "base/collect.hpp"
#include "base/counting_sort.hpp"
#include "cleaving/split_tet.hpp"

#include <numeric>

namespace cleft
{

namespace
{

// What a thread does at once.
// None of these depend on one another, so the numbers change the time alone.
constexpr int64_t kVerticesSampled = 4096;
constexpr int64_t kCutsPlaced = 512;
constexpr int64_t kVerticesListed = 4096;
constexpr int64_t kTetsListed = 1 << 14;

struct SampledVertices {
    Array<MaterialSet> materials;
    Array<uint16_t> count;
    Array<MaterialValue> values;
};

SampledVertices sample_vertices(const Volume& volume, const Array<Vec3>& points, const Run& run)
{
    const auto n = points.count();
    SampledVertices out;
    out.materials = large_array<MaterialSet>(run, points.size());
    out.count.resize(points.size());
    Array<Array<MaterialValue>> chunks(chunk_count(n, kVerticesSampled));
    parallel_chunks(run, n, kVerticesSampled, [&](int64_t chunk, int64_t begin, int64_t end) {
        Samples samples;
        for (int64_t v = begin; v < end; ++v) {
            volume.sample(points[v], samples);
            out.materials[v] = MaterialSet(samples.material[samples.best()]);
            out.count[v] = static_cast<uint16_t>(samples.size());
            SampleStore::append(samples, chunks[chunk]);
        }
    });
    // In the order of chunks: vertex after vertex, as SampleStore expects.
    out.values = joined<MaterialValue>(
        run, chunks, [](auto& chunk) -> auto& { return chunk; });
    return out;
}

// Before anything has snapped a vertex has one material.
// Sixteen bits per vertex instead of a set keep the tables' passes over all tetrahedra in fast memory.
class Tables
{
public:
    Tables(Centres& centres, const Run& run)
        : c_(centres), run_(run), material_(large_array<uint16_t>(run, centres.points.count()))
    {
        parallel_for(run, material_.count(), kVerticesListed, [&](int64_t begin, int64_t end) {
            for (int64_t v = begin; v < end; ++v)
                material_[v] = static_cast<uint16_t>(c_.materials[v][0]);
        });
    }

    void build()
    {
        list_edges();
        list_mixed();
        list_faces();
        c_.fans.resize(c_.mixed.size());
        c_.kept = large_array<uint16_t>(run_, c_.tets.size(), Centres::kNoMaterial);
        c_.doubtful.assign(c_.points.size(), 0);
    }

private:
    Material material(int32_t v) const { return material_[v]; }

    bool has_one_material(const Tet& t) const
    {
        const Material m = material(t[0]);
        return m == material(t[1]) && m == material(t[2]) && m == material(t[3]);
    }

    template <class Visit>
    void for_each_cut(const Tet& t, const Visit& visit) const
    {
        if (has_one_material(t))
            return;
        const FixedArray<Material, 4> m = {material(t[0]), material(t[1]), material(t[2]), material(t[3])};
        for (size_t e = 0; e < 6; ++e) {
            const int i = kEdgeCorners[e][0], j = kEdgeCorners[e][1];
            if (m[i] != m[j])
                visit(e, std::min(t[i], t[j]), std::max(t[i], t[j]));
        }
    }

    // By the lower end, then by the few upper ends of each.
    void list_edges()
    {
        Groups<int64_t, int32_t> upper =
            group_by_key<int64_t, int32_t>(run_, c_.tets.count(), c_.points.count(), [&](int64_t t, const auto& give) {
                for_each_cut(c_.tets[t], [&](size_t, int32_t lower, int32_t high) { give(lower, high); });
            });
        first_edge_.resize(c_.points.size() + 1, 0);
        c_.edges = collect<CutEdge>(run_, c_.points.count(), kVerticesListed,
                                    [&](int64_t begin, int64_t end, Array<CutEdge>& edges) {
                                        for (int64_t v = begin; v < end; ++v) {
                                            const auto from = upper.values.begin() + upper.start[v],
                                                       to = upper.values.begin() + upper.start[v + 1];
                                            std::sort(from, to);
                                            const auto last = std::unique(from, to);
                                            for (auto u = from; u != last; ++u)
                                                edges.push_back({static_cast<int32_t>(v), *u, 0.5, true});
                                            first_edge_[v + 1] = static_cast<int32_t>(last - from);
                                        }
                                    });
        std::partial_sum(first_edge_.begin(), first_edge_.end(), first_edge_.begin());
    }

    // A search through the few edges of one vertex; a hash table of all edges would be larger and slower.
    int32_t edge_between(int32_t lower, int32_t upper) const
    {
        int32_t e = first_edge_[lower];
        while (c_.edges[e].upper != upper)
            ++e;
        CLEFT_ASSERT(e < first_edge_[int64_t{lower} + 1]);
        return e;
    }

    // Counted first, so that each thread knows where its own go.
    void list_mixed()
    {
        const int64_t tets = c_.tets.count();
        Array<int64_t> first(chunk_count(tets, kTetsListed));
        parallel_chunks(run_, tets, kTetsListed, [&](int64_t chunk, int64_t begin, int64_t end) {
            first[chunk] = std::count_if(c_.tets.begin() + begin, c_.tets.begin() + end,
                                         [&](const Tet& t) { return !has_one_material(t); });
        });
        int64_t all = 0;
        for (int64_t& of_chunk : first)
            all += std::exchange(of_chunk, all);
        c_.mixed_of = large_array<int32_t>(run_, c_.tets.size());
        c_.mixed = large_array<MixedTet>(run_, all);
        parallel_chunks(run_, tets, kTetsListed, [&](int64_t chunk, int64_t begin, int64_t end) {
            auto next = static_cast<int32_t>(first[chunk]);
            for (int64_t t = begin; t < end; ++t) {
                const bool is_mixed = !has_one_material(c_.tets[t]);
                c_.mixed_of[t] = is_mixed ? next : -1;
                if (is_mixed)
                    c_.mixed[next++] = mixed_tet(static_cast<int32_t>(t));
            }
        });
    }

    MixedTet mixed_tet(int32_t t) const
    {
        MixedTet m{t, {-1, -1, -1, -1, -1, -1}, {-1, -1, -1, -1}};
        for_each_cut(c_.tets[t],
                     [&](size_t e, int32_t lower, int32_t upper) { m.edges[e] = edge_between(lower, upper); });
        return m;
    }

    // A face is listed by the first of its two tetrahedra. The second one finds it in the chain of the faces that have
    // the same lowest edge; two edges determine a face.
    void list_faces()
    {
        Array<int32_t> newest(c_.edges.size(), -1), older;
        for (size_t k = 0; k < c_.mixed.size(); ++k) {
            run_.check_at(k);
            MixedTet& m = c_.mixed[k];
            CutMask cuts = 0;
            for (size_t e = 0; e < 6; ++e)
                cuts |= static_cast<CutMask>(m.edges[e] >= 0) << e;
            for (size_t i = 0; i < 4; ++i) {
                if ((cuts & kFaceCuts[i]) != kFaceCuts[i])
                    continue;
                const TripleFace face = triple_face(m, i);
                int32_t& chain = newest[face.edges[0]];
                int32_t f = chain;
                while (f >= 0 && c_.faces[f].edges != face.edges)
                    f = older[f];
                if (f < 0) {
                    f = static_cast<int32_t>(c_.faces.size());
                    c_.faces.push_back(face);
                    older.push_back(chain);
                    chain = f;
                }
                m.faces[i] = f;
            }
        }
    }

    static TripleFace triple_face(const MixedTet& m, size_t opposite)
    {
        const int* corner = kFaceCorners[opposite];
        const auto edge = [&](int i, int j) { return m.edges[kEdgeBetween[i][j]]; };
        TripleFace face{{edge(corner[0], corner[1]), edge(corner[1], corner[2]), edge(corner[2], corner[0])}};
        std::sort(face.edges.begin(), face.edges.end());
        CLEFT_ASSERT(face.edges[0] >= 0);
        return face;
    }

    Centres& c_;
    const Run& run_;
    Array<uint16_t> material_;   // of each vertex
    Array<int32_t> first_edge_;  // of each lower vertex
};

}  // namespace

void list_centres(Centres& c, const Run& run) { Tables(c, run).build(); }

Centres find_centres(const Volume& volume, const TetMesh& background, const MetricField* metric, Steps& steps)
{
    const Run of_vertices = steps.next();
    SampledVertices sampled = sample_vertices(volume, background.points, of_vertices);
    Centres c{volume,
              background.tets,
              large_copy(of_vertices, background.points),
              std::move(sampled.materials),
              SampleStore(std::move(sampled.values), sampled.count),
              {},
              {},
              {},
              {},
              {},
              {},
              {}};
    const Run of_cuts = steps.next();
    c.metrics = metrics_at(background.points, metric, of_cuts);
    list_centres(c, of_cuts);
    parallel_for(of_cuts, c.edges.count(), kCutsPlaced, [&](int64_t begin, int64_t end) {
        Samples scratch;
        for (int64_t e = begin; e < end; ++e)
            c.place_cut(c.edges[e], scratch);
    });
    choose_fans(c, steps.next());
    return c;
}

}  // namespace cleft
