// Points and tetrahedra go to the ranks that own a corner; what a rank gets is its part.
#include "parts/mesh_part.hpp"

#include "base/stage.hpp"
#include "mesh/order.hpp"
#include "parts/number_points.hpp"

#include <algorithm>
#include <tuple>

namespace cleft
{

namespace
{

using WideTet = FixedArray<int64_t, 4>;

struct SentTet {
    WideTet corners;  // numbers in the whole mesh
    int32_t material;
    bool operator<(const SentTet& o) const { return corners < o.corners; }
};

struct SentPoint {
    int64_t number;
    double x[3];
    bool operator<(const SentPoint& o) const { return number < o.number; }
};

// What arrives at this rank.
struct Arrived {
    Array<SentTet> tets;
    Array<SentPoint> points;
};

// The ranks that own a corner, each once.
template <class Visit>
void for_each_owner(const WideTet& corners, const OwnedNumbers& owned, const Visit& visit)
{
    FixedArray<int32_t, 4> owners{};
    for (size_t i = 0; i < 4; ++i) {
        owners[i] = owned.owner(corners[i]);
        if (std::find(owners.begin(), owners.begin() + i, owners[i]) == owners.begin() + i)
            visit(owners[i]);
    }
}

template <class T>
void sort_and_drop_repeated(Array<T>& items)
{
    std::sort(items.begin(), items.end());
    const auto same = [](const T& a, const T& b) { return !(a < b) && !(b < a); };
    items.erase(std::unique(items.begin(), items.end(), same), items.end());
}

Arrived send(const LabelledMesh& piece, const NumberedPoints& numbers, Exchange& exchange)
{
    const OwnedNumbers owned(numbers.all, exchange.ranks());
    Array<Array<SentTet>> tets(to_size(exchange.ranks()));
    Array<Array<SentPoint>> points(to_size(exchange.ranks()));
    Array<Array<int32_t>> needed(to_size(exchange.ranks()));
    for (int64_t t = 0; t < piece.tets.count(); ++t) {
        const Tet& local = piece.tets[t];
        WideTet corners{};
        for (size_t i = 0; i < 4; ++i)
            corners[i] = numbers.of_points[local[i]];
        const SentTet sent{least_corners_first(corners), piece.material[t]};
        for_each_owner(corners, owned, [&](int32_t rank) {
            tets[rank].push_back(sent);
            needed[rank].insert(needed[rank].end(), local.begin(), local.end());
        });
    }
    for (int32_t r = 0; r < exchange.ranks(); ++r) {
        sort_and_drop_repeated(needed[r]);
        for (const int32_t p : needed[r]) {
            const Vec3& x = piece.points[p];
            points[r].push_back({numbers.of_points[p], {x[0], x[1], x[2]}});
        }
        needed[r] = Array<int32_t>();
    }
    Arrived arrived;
    arrived.tets = exchange.all_to_all(tets).items;
    tets = Array<Array<SentTet>>();
    arrived.points = exchange.all_to_all(points).items;
    std::sort(arrived.tets.begin(), arrived.tets.end());
    sort_and_drop_repeated(arrived.points);
    return arrived;
}

Share share_of(int64_t owned, Exchange& exchange)
{
    const Array<int64_t> counts = exchange.all_gather(owned);
    Share share{owned, 0, 0};
    for (int32_t r = 0; r < exchange.ranks(); ++r) {
        share.first += r < exchange.rank() ? counts[r] : 0;
        share.all += counts[r];
    }
    return share;
}

// Its own first.
void take_points(const Array<SentPoint>& arrived, const OwnedNumbers& owned, int32_t rank, MeshPart& part)
{
    for (const bool own : {true, false})
        for (const SentPoint& p : arrived) {
            const int32_t owner = owned.owner(p.number);
            if ((owner == rank) != own)
                continue;
            part.points.emplace_back(p.x[0], p.x[1], p.x[2]);
            part.numbers.push_back(p.number);
            part.owners.push_back(owner);
        }
    if (part.points.count() > INT32_MAX)
        throw Error(CLEFT_ERROR_TOO_LARGE, "a part has more than 2147483647 points: more ranks would share them");
}

// The local number of each point that this part has.
class LocalNumbers
{
public:
    explicit LocalNumbers(const MeshPart& part) : numbers_(part.numbers), owned_(part.of_points) {}

    int32_t of(int64_t number) const
    {
        if (number >= owned_.first && number < owned_.first + owned_.owned)
            return static_cast<int32_t>(number - owned_.first);
        const auto found = std::lower_bound(numbers_.begin() + owned_.owned, numbers_.end(), number);
        CLEFT_ASSERT(found != numbers_.end() && *found == number);
        return static_cast<int32_t>(found - numbers_.begin());
    }

private:
    const Array<int64_t>& numbers_;
    const Share& owned_;
};

void take_tets(const Array<SentTet>& arrived, const LocalNumbers& local, const OwnedNumbers& owned, int32_t rank,
               MeshPart& part)
{
    if (arrived.count() > INT32_MAX)
        throw Error(CLEFT_ERROR_TOO_LARGE, "a part has more than 2147483647 tetrahedra: more ranks would share them");
    for (const bool own : {true, false})
        for (const SentTet& t : arrived) {
            if ((owned.owner(t.corners[0]) == rank) != own)
                continue;
            Tet tet{};
            for (size_t i = 0; i < 4; ++i)
                tet[i] = local.of(t.corners[i]);
            part.tets.push_back(tet);
            part.material.push_back(t.material);
            part.of_tets.owned += own;
        }
}

// The corner of the least number first, as triangles of a whole mesh have it.
Triangle least_first(const MeshPart& part, Triangle corners)
{
    std::rotate(corners.begin(),
                std::min_element(corners.begin(), corners.end(),
                                 [&](int32_t a, int32_t b) { return part.numbers[a] < part.numbers[b]; }),
                corners.end());
    return corners;
}

// Those whose corner of the least number is owned: all tetrahedra there have arrived, so both sides are known.
void find_triangles(const BoundingBox& box, int32_t rank, MeshPart& part, const Run& run)
{
    const Interfaces all = extract_interfaces({part.points, part.tets, part.material}, box.lo, box.hi, run);
    const auto add = [&](const Triangle& corners, const std::array<int32_t, 2>& regions, int32_t side) {
        const Triangle t = least_first(part, corners);
        if (part.owners[t[0]] == rank)
            part.triangles.push_back({t, regions, side});
    };
    for (int64_t i = 0; i < all.triangles.count(); ++i)
        add(all.triangles[i], all.pairs[i], -1);
    for (int64_t i = 0; i < all.hull.count(); ++i)
        add(all.hull[i], {all.hull_region[i], all.hull_region[i]}, static_cast<int32_t>(all.hull_side[i]));
    const auto key = [&](const PartTriangle& t) {
        return std::tuple(t.side, t.regions, part.numbers[t.corners[0]], part.numbers[t.corners[1]],
                          part.numbers[t.corners[2]]);
    };
    std::sort(part.triangles.begin(), part.triangles.end(),
              [&](const PartTriangle& a, const PartTriangle& b) { return key(a) < key(b); });
}

// Leaves the tetrahedra that are owned, and the points that are owned or at one of these.
void drop_ghosts(MeshPart& part)
{
    part.tets.resize(part.of_tets.owned);
    part.material.resize(part.of_tets.owned);
    Array<int32_t> new_number(part.points.size(), -1);
    for (const Tet& tet : part.tets)
        for (const int32_t p : tet)
            new_number[p] = 0;
    for (const PartTriangle& t : part.triangles)
        for (const int32_t p : t.corners)
            new_number[p] = 0;
    int32_t kept = 0;
    for (int64_t p = 0; p < part.points.count(); ++p) {
        if (p >= part.of_points.owned && new_number[p] < 0)
            continue;
        part.points[kept] = part.points[p];
        part.numbers[kept] = part.numbers[p];
        part.owners[kept] = part.owners[p];
        new_number[p] = kept++;
    }
    part.points.resize(kept);
    part.numbers.resize(kept);
    part.owners.resize(kept);
    for (Tet& tet : part.tets)
        for (int32_t& p : tet)
            p = new_number[p];
    for (PartTriangle& t : part.triangles)
        for (int32_t& p : t.corners)
            p = new_number[p];
}

}  // namespace

MeshPart share_mesh(LabelledMesh piece, const BoundingBox& box, bool ghosts, Exchange& exchange, const Run& run)
{
    Stage stage(run, "sharing", {{"sharing: numbers", 3}, {"sharing: parts", 4}, {"sharing: triangles", 3}});
    stage.next();
    const NumberedPoints numbers = number_points(piece.points, box, exchange);
    stage.next();
    const Arrived arrived = send(piece, numbers, exchange);
    piece = LabelledMesh();
    const OwnedNumbers owned(numbers.all, exchange.ranks());
    const int32_t rank = exchange.rank();
    MeshPart part;
    take_points(arrived.points, owned, rank, part);
    part.of_points = {owned.first(rank + 1) - owned.first(rank), owned.first(rank), numbers.all};
    take_tets(arrived.tets, LocalNumbers(part), owned, rank, part);
    part.of_tets = share_of(part.of_tets.owned, exchange);
    find_triangles(box, rank, part, stage.next());
    part.of_triangles = share_of(part.triangles.count(), exchange);
    if (!ghosts)
        drop_ghosts(part);
    return part;
}

}  // namespace cleft
