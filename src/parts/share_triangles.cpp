// The owner of a triangle is that of its tetrahedron, or of the one of lower number. That is the owner of the least
// corner of the two, since the least corner decides the number.
#include "parts/share_triangles.hpp"

#include "base/large_pages.hpp"
#include "mesh/interfaces.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// As triangles of a whole mesh have them.
FixedArray<int64_t, 3> numbers_of_corners(const Triangle& t, const int64_t* numbers)
{
    FixedArray<int64_t, 3> out{numbers[t[0]], numbers[t[1]], numbers[t[2]]};
    std::rotate(out.begin(), std::min_element(out.begin(), out.end()), out.end());
    return out;
}

int64_t least_number(const Tet& tet, const int64_t* numbers)
{
    return std::min({numbers[tet[0]], numbers[tet[1]], numbers[tet[2]], numbers[tet[3]]});
}

template <class T>
void append(const Array<T>& items, Array<T>& to)
{
    make_room(to, items.size());
    to.insert(to.end(), items.begin(), items.end());
}

}  // namespace

SharedTriangles::SharedTriangles(const BoundingBox& box, const OwnedNumbers& owned, Exchange& exchange)
    : box_(box), owned_(owned), exchange_(exchange)
{
}

void SharedTriangles::add(const LabelledMesh& piece, const int64_t* numbers, const Run& run)
{
    const Interfaces found = extract_interfaces({piece.points, piece.tets, piece.material}, box_.lo, box_.hi, run);
    const auto least = [&](int32_t t) { return least_number(piece.tets[t], numbers); };
    ByRank to_owner(to_size(exchange_.ranks()));
    for (int64_t i = 0; i < found.triangles.count(); ++i) {
        const int64_t lower = std::min(least(found.tets[i][0]), least(found.tets[i][1]));
        to_owner[owned_.owner(lower)].push_back({-1, found.pairs[i], numbers_of_corners(found.triangles[i], numbers)});
    }
    for (int64_t i = 0; i < found.hull.count(); ++i) {
        const auto corners = numbers_of_corners(found.hull[i], numbers);
        const int32_t region = found.hull_region[i];
        const int64_t of_tet = least(found.hull_tet[i]);
        if (found.hull_side[i] == Side::other)
            cut_.push_back({corners, of_tet, region});
        else
            to_owner[owned_.owner(of_tet)].push_back(
                {static_cast<int32_t>(found.hull_side[i]), {region, region}, corners});
    }
    append(exchange_.all_to_all(to_owner).items, arrived_);
}

Array<SharedTriangles::HalfCut> SharedTriangles::match(Array<HalfCut> halves, ByRank& to_owner) const
{
    std::sort(halves.begin(), halves.end());
    Array<HalfCut> single;
    for (int64_t first = 0, next = 0; first < halves.count(); first = next) {
        while (next < halves.count() && halves[next].face() == halves[first].face())
            ++next;
        if (next - first > 2)
            throw Error(CLEFT_ERROR_INTERNAL, "pieces of a mesh overlap: a face has more than two tetrahedra");
        if (next - first == 1) {
            single.push_back(halves[first]);
            continue;
        }
        const bool in_order = halves[first].region < halves[first + 1].region;
        const HalfCut &lesser = halves[in_order ? first : first + 1], &greater = halves[in_order ? first + 1 : first];
        if (lesser.region != greater.region)
            to_owner[owned_.owner(std::min(lesser.least_of_tet, greater.least_of_tet))].push_back(
                {-1, {lesser.region, greater.region}, lesser.corners});
    }
    return single;
}

Array<SentTriangle> SharedTriangles::take()
{
    ByRank to_owner(to_size(exchange_.ranks()));
    Array<Array<HalfCut>> single(to_size(exchange_.ranks()));
    for (const HalfCut& half : match(std::move(cut_), to_owner))
        single[owned_.owner(half.corners[0])].push_back(half);
    for (const HalfCut& hull : match(exchange_.all_to_all(single).items, to_owner))
        to_owner[owned_.owner(hull.least_of_tet)].push_back(
            {static_cast<int32_t>(Side::other), {hull.region, hull.region}, hull.corners});
    append(exchange_.all_to_all(to_owner).items, arrived_);
    std::sort(arrived_.begin(), arrived_.end());
    return std::move(arrived_);
}

}  // namespace cleft
