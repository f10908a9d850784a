// The lemmas of cleaving/stencil.hpp, proved by going through all cases.
#include "cleaving/stencil_table.hpp"

#include "mesh/quality.hpp"
#include "support/cmocka.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <map>
#include <set>

using namespace cleft;
using cleft_test::Random;

namespace
{

using Points = FixedArray<Vec3, kStencilPoints>;

// All orders of the six cuts.
std::vector<CutRanks> all_ranks()
{
    CutRanks ranks = {0, 1, 2, 3, 4, 5};
    std::vector<CutRanks> all;
    do
        all.push_back(ranks);
    while (std::next_permutation(ranks.begin(), ranks.end()));
    return all;
}

// Corners of some tetrahedron, and centres anywhere inside their simplices.
Points random_points(Random& random)
{
    Points x;
    const FixedArray<Vec3, 4> corners = {Vec3(0, 0, 0), Vec3(1, 0.1, 0), Vec3(0.2, 1.1, 0), Vec3(0.3, 0.2, 0.9)};
    for (size_t p = 0; p < kStencilPoints; ++p) {
        double sum = 0;
        Vec3 at(0, 0, 0);
        for (size_t i = 0; i < 4; ++i)
            if (kCarrier[p] >> i & 1u) {
                const double weight = random.between(0.02, 1);
                at += weight * corners[i];
                sum += weight;
            }
        x[p] = at / sum;
    }
    return x;
}

double volume_of(const Points& x, const StencilTet& t) { return orient(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6; }

template <size_t N>
FixedArray<uint8_t, N> sorted(FixedArray<uint8_t, N> a)
{
    std::sort(a.begin(), a.end());
    return a;
}

bool has_all_different_points(const StencilTet& t)
{
    const StencilTet s = sorted(t);
    return std::adjacent_find(s.begin(), s.end()) == s.end();
}

// Faces inside the fan come twice; those that come once are the triangles of the split surface.
bool fills_surface(const FixedArray<StencilTet, 24>& tets, int count, const SplitSurface& surface)
{
    std::map<StencilTriangle, int> seen;
    for (size_t i = 0; i < static_cast<size_t>(count); ++i)
        for (size_t out = 0; out < 4; ++out) {
            StencilTriangle face{};
            for (size_t k = 0, n = 0; k < 4; ++k)
                if (k != out)
                    face[n++] = tets[i][k];
            ++seen[sorted(face)];
        }
    std::set<StencilTriangle> hull, expected;
    for (const auto& [face, times] : seen) {
        if (times > 2)
            return false;
        if (times == 1)
            hull.insert(face);
    }
    for (size_t i = 0; i < surface.first[4]; ++i)
        expected.insert(sorted(surface.triangles[i]));
    return hull == expected;
}

void every_pattern_and_order_fans_with_positive_volumes(void**)
{
    Random random(1);
    for (const CutRanks& ranks : all_ranks())
        for (CutMask cuts = 0; cuts <= kAllCuts; ++cuts) {
            const SplitSurface surface = split_surface(cuts, diagonals(cuts, ranks));
            const Apexes candidates = apexes(cuts, surface);
            assert_true(candidates.count > 0);
            const Points x = random_points(random);
            const double whole = volume_of(x, {0, 1, 2, 3});
            for (size_t a = 0; a < static_cast<size_t>(candidates.count); ++a) {
                FixedArray<StencilTet, 24> tets;
                const int count = fan(surface, candidates.point[a], tets);
                double sum = 0;
                for (size_t i = 0; i < static_cast<size_t>(count); ++i) {
                    assert_true(has_all_different_points(tets[i]));
                    assert_true(volume_of(x, tets[i]) > 1e-9);
                    sum += volume_of(x, tets[i]);
                }
                assert_true(std::abs(sum - whole) < 1e-12);
                assert_true(fills_surface(tets, count, surface));
            }
        }
}

// The closed simplex has its boundary too: half of the time a share is nothing.
Points points_of_closed_simplices(Random& random)
{
    Points x = random_points(random);
    for (size_t p = 4; p < kStencilPoints; ++p) {
        Vec3 at(0, 0, 0);
        double sum = 0;
        while (sum == 0)
            for (size_t i = 0; i < 4; ++i)
                if (kCarrier[p] >> i & 1u && random.below(2)) {
                    const double weight = random.between(0, 1);
                    at += weight * x[i];
                    sum += weight;
                }
        x[p] = at / sum;
    }
    return x;
}

// What lies beneath both lemmas: with one point in each closed simplex, the 24 tetrahedra of a corner, an edge, a face
// and the whole, each in the next, are never negative and add up. In barycentric coordinates each has the volume
// (share of j in the edge's point) (of k in the face's) (of l in the tetrahedron's).
void flags_are_never_negative_and_add_up(void**)
{
    Random random(3);
    const auto point_of = [](unsigned corners) {
        return static_cast<size_t>(std::find(kCarrier.begin(), kCarrier.end(), corners) - kCarrier.begin());
    };
    for (int trial = 0; trial < 20000; ++trial) {
        const Points x = points_of_closed_simplices(random);
        const double whole = volume_of(x, {0, 1, 2, 3});
        FixedArray<size_t, 4> order = {0, 1, 2, 3};
        double sum = 0;
        do {
            const unsigned edge = 1u << order[0] | 1u << order[1], face = edge | 1u << order[2];
            const bool even = orient(x[order[0]], x[order[1]], x[order[2]], x[order[3]]) > 0;
            const double volume =
                orient(x[order[0]], x[point_of(edge)], x[point_of(face)], x[kQuadruplePoint]) / (even ? 6 : -6);
            assert_true(volume > -1e-15);
            sum += volume;
        } while (std::next_permutation(order.begin(), order.end()));
        assert_true(std::abs(sum - whole) < 1e-12);
    }
}

// Lemma 2 names the apex: the greatest cut, where no face has three cuts.
void greatest_cut_is_an_apex_without_triple_points(void**)
{
    int cases = 0;
    for (const CutRanks& ranks : all_ranks())
        for (CutMask cuts = 1; cuts <= kAllCuts; ++cuts) {
            const bool has_triple =
                std::any_of(kFaceCuts.begin(), kFaceCuts.end(), [&](CutMask face) { return (cuts & face) == face; });
            if (has_triple)
                continue;
            size_t greatest = 6;
            for (size_t e = 0; e < 6; ++e)
                if (cuts >> e & 1u && (greatest == 6 || ranks[e] > ranks[greatest]))
                    greatest = e;
            const Apexes found = apexes(cuts, split_surface(cuts, diagonals(cuts, ranks)));
            const auto end = found.point.begin() + found.count;
            assert_true(std::find(found.point.begin(), end, kCutPoint + greatest) != end);
            ++cases;
        }
    assert_true(cases > 0);
}

// Without a total order the rule fails: cuts that beat each other in a ring leave no apex. This is the cyclic choice of
// figure 2 of the paper, and shows that the check above can fail.
void cyclic_diagonals_leave_no_apex(void**)
{
    // Cuts on 01, 12, 23, 30; each face has two. Ranks are those of the face, not of the tetrahedron.
    const CutMask cuts = 1u << 0 | 1u << 3 | 1u << 5 | 1u << 2;
    const FixedArray<size_t, 4> ring = {0, 3, 5, 2};
    SplitSurface surface;
    for (size_t k = 0; k < 4; ++k) {
        CutRanks ranks{};
        ranks[ring[k]] = 1;  // beats the next one
        const size_t next = ring[(k + 1) % 4];
        const SplitSurface split = split_surface(cuts, diagonals(cuts, ranks));
        for (size_t face = 0; face < 4; ++face)
            if ((kFaceCuts[face] >> ring[k] & 1u) && (kFaceCuts[face] >> next & 1u))
                for (size_t i = 0; i < 3; ++i)
                    surface.triangles[3 * face + i] = split.triangles[split.first[face] + i];
    }
    surface.first = {0, 3, 6, 9, 12};
    assert_int_equal(apexes(cuts, surface).count, 0);
}

// The table has the fan of every apex, and no other.
void table_lists_the_fans_of_all_apexes(void**)
{
    const auto in_order = [](const StencilTet* begin, const StencilTet* end) {
        std::set<StencilTet> tets;
        for (const StencilTet* t = begin; t != end; ++t)
            tets.insert(sorted(*t));
        return tets;
    };
    const StencilTable table;
    for (const CutRanks& ranks : all_ranks())
        for (CutMask cuts = 0; cuts <= kAllCuts; ++cuts) {
            const Diagonals choice = diagonals(cuts, ranks);
            const SplitSurface surface = split_surface(cuts, choice);
            const Apexes candidates = apexes(cuts, surface);
            std::set<std::set<StencilTet>> expected, found;
            for (size_t a = 0; a < static_cast<size_t>(candidates.count); ++a) {
                FixedArray<StencilTet, 24> tets;
                const int count = fan(surface, candidates.point[a], tets);
                expected.insert(in_order(tets.data(), tets.data() + count));
            }
            const StencilTable::Range range = table.stencils(cuts, choice);
            for (uint16_t s = range.begin; s < range.end; ++s)
                found.insert(in_order(table.tets(s).begin(), table.tets(s).end()));
            assert_true(found == expected);
            assert_int_equal(range.end - range.begin, found.size());
        }
}

// What a face splits into depends on the face alone: not on which face of a tetrahedron it is, how its corners are
// numbered there, or what the other three edges have.
void both_sides_split_a_shared_face_alike(void**)
{
    // Global names: corners 0 .. 2 of the face, its side k is opposite corner k; 3 is the other corner.
    using NamedTriangle = FixedArray<int, 3>;
    const std::array<FixedArray<uint8_t, 3>, 6> orders = {
        {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
    for (unsigned face_cuts = 0; face_cuts < 8; ++face_cuts)
        for (const auto& order : orders) {
            std::set<std::set<NamedTriangle>> seen;
            FixedArray<int, 4> name = {0, 1, 2, 3};  // of local corners
            do
                for (unsigned other_cuts = 0; other_cuts < 8; ++other_cuts) {
                    CutMask cuts = 0;
                    CutRanks ranks{};
                    FixedArray<int, kStencilPoints> names{};
                    for (size_t e = 0; e < 6; ++e) {
                        const int i = name[static_cast<size_t>(kEdgeCorners[e][0])],
                                  j = name[static_cast<size_t>(kEdgeCorners[e][1])];
                        const bool of_face = i != 3 && j != 3;
                        const auto side = static_cast<size_t>(of_face ? 3 - i - j : std::min(i, j));
                        cuts |= ((of_face ? face_cuts : other_cuts) >> side & 1u) << e;
                        ranks[e] = static_cast<uint8_t>(of_face ? 2 * order[side] : 2 * side + 1);
                        names[kCutPoint + e] = 10 + static_cast<int>(side) + (of_face ? 0 : 10);
                    }
                    const auto face = static_cast<size_t>(std::find(name.begin(), name.end(), 3) - name.begin());
                    for (size_t i = 0; i < 4; ++i)
                        names[i] = name[i];
                    names[kTriplePoint + face] = 30;
                    const SplitSurface surface = split_surface(cuts, diagonals(cuts, ranks));
                    std::set<NamedTriangle> triangles;
                    for (size_t i = surface.first[face]; i < surface.first[face + 1]; ++i) {
                        NamedTriangle t{};
                        for (size_t k = 0; k < 3; ++k)
                            t[k] = names[surface.triangles[i][k]];
                        std::sort(t.begin(), t.end());
                        triangles.insert(t);
                    }
                    seen.insert(triangles);
                }
            while (std::next_permutation(name.begin(), name.end()));
            assert_int_equal(seen.size(), 1);
        }
}

}  // namespace

int main()
{
    const CMUnitTest tests[] = {
        cmocka_unit_test(every_pattern_and_order_fans_with_positive_volumes),
        cmocka_unit_test(flags_are_never_negative_and_add_up),
        cmocka_unit_test(greatest_cut_is_an_apex_without_triple_points),
        cmocka_unit_test(cyclic_diagonals_leave_no_apex),
        cmocka_unit_test(table_lists_the_fans_of_all_apexes),
        cmocka_unit_test(both_sides_split_a_shared_face_alike),
    };
    return cmocka_run_group_tests(tests, nullptr, nullptr);
}
