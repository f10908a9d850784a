// Making the tables of centres: sample the vertices, list the cut edges, then the simplices above them.
#include "cleaving/find_centres.hpp"

#include "base/large_pages.hpp"
#include "base/parallel.hpp"
#include "cleaving/split_tet.hpp"

namespace cleft
{

namespace
{

// What a thread does at once.
constexpr int64_t kVerticesSampled = 4096;
constexpr int64_t kCutsPlaced = 512;

struct SampledVertices {
    std::vector<MaterialSet> materials;
    std::vector<uint16_t> count;
    std::vector<MaterialValue> values;
};

SampledVertices sample_vertices(const Volume& volume, const std::vector<Vec3>& points, const Run& run)
{
    const auto n = static_cast<int64_t>(points.size());
    SampledVertices out;
    out.materials = large_vector<MaterialSet>(points.size());
    out.count.resize(points.size());
    std::vector<std::vector<MaterialValue>> chunks(static_cast<size_t>(chunk_count(n, kVerticesSampled)));
    parallel_chunks(run, n, kVerticesSampled, [&](int64_t chunk, int64_t begin, int64_t end) {
        Samples samples;
        for (auto v = static_cast<size_t>(begin); v < static_cast<size_t>(end); ++v) {
            volume.sample(points[v], samples);
            out.materials[v] = MaterialSet(samples.material[samples.best()]);
            out.count[v] = static_cast<uint16_t>(samples.size());
            SampleStore::append(samples, chunks[static_cast<size_t>(chunk)]);
        }
    });
    for (auto& chunk : chunks) {
        out.values.insert(out.values.end(), chunk.begin(), chunk.end());
        chunk = {};
    }
    return out;
}

std::vector<Vec3> copy_of(const std::vector<Vec3>& points)
{
    std::vector<Vec3> copy;
    reserve_large(copy, points.size());
    copy.assign(points.begin(), points.end());
    return copy;
}

// Before anything has snapped a vertex has one material.
class Tables
{
public:
    Tables(Centres& centres, const Run& run) : c_(centres), run_(run), material_(centres.points.size())
    {
        for (size_t v = 0; v < material_.size(); ++v)
            material_[v] = static_cast<uint16_t>(c_.materials[v][0]);
    }

    void build()
    {
        list_edges();
        list_mixed();
        list_faces();
        c_.fans.resize(c_.mixed.size());
        c_.kept = large_vector<uint16_t>(c_.tets.size(), Centres::kNoMaterial);
        c_.doubtful.assign(c_.points.size(), 0);
    }

private:
    Material material(int32_t v) const { return material_[static_cast<size_t>(v)]; }

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
        const std::array<Material, 4> m = {material(t[0]), material(t[1]), material(t[2]), material(t[3])};
        for (size_t e = 0; e < 6; ++e) {
            const auto i = static_cast<size_t>(kEdgeCorners[e][0]), j = static_cast<size_t>(kEdgeCorners[e][1]);
            if (m[i] != m[j])
                visit(e, std::min(t[i], t[j]), std::max(t[i], t[j]));
        }
    }

    // A counting sort by the lower end, then a sort of the few upper ends of each.
    void list_edges()
    {
        const size_t n = c_.points.size();
        std::vector<int64_t> slot(n + 1, 0);
        for (size_t t = 0; t < c_.tets.size(); ++t) {
            run_.check_at(t);
            for_each_cut(c_.tets[t], [&](size_t, int32_t lower, int32_t) { ++slot[static_cast<size_t>(lower) + 1]; });
        }
        for (size_t v = 0; v < n; ++v)
            slot[v + 1] += slot[v];
        std::vector<int32_t> upper = large_vector<int32_t>(static_cast<size_t>(slot[n]));
        for (size_t t = 0; t < c_.tets.size(); ++t) {
            run_.check_at(t);
            for_each_cut(c_.tets[t], [&](size_t, int32_t lower, int32_t high) {
                upper[static_cast<size_t>(slot[static_cast<size_t>(lower)]++)] = high;
            });
        }
        // Each slot is now where the next one began.
        first_edge_.resize(n + 1, 0);
        int64_t begin = 0;
        for (size_t v = 0; v < n; ++v) {
            const auto from = upper.begin() + begin, to = upper.begin() + slot[v];
            std::sort(from, to);
            for (auto u = from; u != to; ++u)
                if (u == from || *u != *(u - 1))
                    c_.edges.push_back({static_cast<int32_t>(v), *u, 0.5, true});
            begin = slot[v];
            first_edge_[v + 1] = static_cast<int32_t>(c_.edges.size());
        }
    }

    int32_t edge_between(int32_t lower, int32_t upper) const
    {
        int32_t e = first_edge_[static_cast<size_t>(lower)];
        while (c_.edges[static_cast<size_t>(e)].upper != upper)
            ++e;
        return e;
    }

    void list_mixed()
    {
        c_.mixed_of = large_vector(c_.tets.size(), -1);
        reserve_large(c_.mixed, static_cast<size_t>(std::count_if(c_.tets.begin(), c_.tets.end(),
                                                                  [&](const Tet& t) { return !has_one_material(t); })));
        for (size_t t = 0; t < c_.tets.size(); ++t) {
            run_.check_at(t);
            MixedTet m{static_cast<int32_t>(t), {-1, -1, -1, -1, -1, -1}, {-1, -1, -1, -1}};
            bool has_cut = false;
            for_each_cut(c_.tets[t], [&](size_t e, int32_t lower, int32_t upper) {
                m.edges[e] = edge_between(lower, upper);
                has_cut = true;
            });
            if (has_cut) {
                c_.mixed_of[t] = static_cast<int32_t>(c_.mixed.size());
                c_.mixed.push_back(m);
            }
        }
    }

    // A face is listed by the first of its two tetrahedra. The second one finds it in the chain of the faces that have
    // the same lowest edge; two edges determine a face.
    void list_faces()
    {
        std::vector<int32_t> newest(c_.edges.size(), -1), older;
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
                int32_t& chain = newest[static_cast<size_t>(face.edges[0])];
                int32_t f = chain;
                while (f >= 0 && c_.faces[static_cast<size_t>(f)].edges != face.edges)
                    f = older[static_cast<size_t>(f)];
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
        const auto edge = [&](int i, int j) { return m.edges[static_cast<size_t>(kEdgeBetween[i][j])]; };
        TripleFace face{{edge(corner[0], corner[1]), edge(corner[1], corner[2]), edge(corner[2], corner[0])}};
        std::sort(face.edges.begin(), face.edges.end());
        return face;
    }

    Centres& c_;
    const Run& run_;
    std::vector<uint16_t> material_;   // of each vertex
    std::vector<int32_t> first_edge_;  // of each lower vertex
};

}  // namespace

void list_centres(Centres& c, const Run& run) { Tables(c, run).build(); }

Centres find_centres(const Volume& volume, const TetMesh& background, Steps& steps)
{
    SampledVertices sampled = sample_vertices(volume, background.points, steps.next());
    Centres c{volume,
              background.tets,
              copy_of(background.points),
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
    list_centres(c, of_cuts);
    parallel_for(of_cuts, static_cast<int64_t>(c.edges.size()), kCutsPlaced, [&](int64_t begin, int64_t end) {
        Samples scratch;
        for (int64_t e = begin; e < end; ++e)
            c.place_cut(c.edges[static_cast<size_t>(e)], scratch);
    });
    choose_fans(c, steps.next());
    return c;
}

}  // namespace cleft
