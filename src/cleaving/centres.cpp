// Finds places of centres, and which of them are still there, from the cuts that are left.
#include "cleaving/centres.hpp"

namespace cleft
{

CutMask Centres::cuts(const MixedTet& m) const
{
    CutMask mask = 0;
    for (size_t e = 0; e < 6; ++e)
        mask |= static_cast<CutMask>(is_cut(m.edges[e])) << e;
    return mask;
}

bool Centres::has_quadruple(const MixedTet& m) const
{
    const bool had_one = std::all_of(m.faces.begin(), m.faces.end(), [](int32_t f) { return f >= 0; });
    return had_one && cuts(m) == kAllCuts;
}

Vec3 Centres::triple_point(const TripleFace& f) const
{
    const auto cut = [&](size_t i) { return cut_point(edges[f.edges[i]]); };
    // Differences first: if all cuts share a coordinate, the triple point has exactly that one.
    const Vec3 a = cut(0);
    return a + ((cut(1) - a) + (cut(2) - a)) / 3;
}

Vec3 Centres::quadruple_point(const MixedTet& m) const
{
    Vec3 sum(0, 0, 0);
    for (const int32_t e : m.edges)
        sum += cut_point(edges[e]);
    return sum / 6;
}

void Centres::place_cut(CutEdge& e, Samples& scratch) const
{
    const MaterialSet &a = materials_of(e.lower), &b = materials_of(e.upper);
    CLEFT_ASSERT(disjoint(a, b));
    const EdgeTie tie{
        point(e.lower), point(e.upper), a, b, samples.difference(e.lower, a, b), samples.difference(e.upper, a, b)};
    e.t = find_cut(volume, tie, scratch);
    // Cuts keep off the ends of their edges. Lemma 1 of stencil.hpp needs centres inside their simplices.
    CLEFT_ASSERT(e.t >= kLeastCut && e.t <= kGreatestCut);
}

}  // namespace cleft
