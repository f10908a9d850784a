// Points and tetrahedra go to the ranks that own a corner; what a rank gets is its part.
#include "parts/mesh_part.hpp"

#include "base/stage.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/order.hpp"
#include "parts/number_points.hpp"

#include <algorithm>
#include <string>
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

struct SentTriangle {
    int32_t side;
    std::array<int32_t, 2> regions;
    FixedArray<int64_t, 3> corners;  // numbers in the whole mesh
    bool operator<(const SentTriangle& o) const
    {
        return std::tie(side, regions, corners) < std::tie(o.side, o.regions, o.corners);
    }
};

// What arrives at this rank.
struct Arrived {
    Array<SentTet> tets;
    Array<SentPoint> points;
};

// The owners of the corners of a tetrahedron, each once.
template <class Owner, class Visit>
void for_each_owner(const Owner& owner, const Visit& visit)
{
    FixedArray<int32_t, 4> owners{};
    for (size_t i = 0; i < 4; ++i) {
        owners[i] = owner(i);
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
        for_each_owner([&](size_t i) { return owned.owner(corners[i]); },
                       [&](int32_t rank) {
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
    for (const bool own : {true, false})
        for (const SentTet& t : arrived) {
            const int32_t owner = owned.owner(t.corners[0]);
            if ((owner == rank) != own)
                continue;
            Tet tet{};
            for (size_t i = 0; i < 4; ++i)
                tet[i] = local.of(t.corners[i]);
            part.tets.push_back(tet);
            part.material.push_back(t.material);
            part.tet_owners.push_back(owner);
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

// The owner of a tetrahedron is that of its first corner, and so is the order of the numbers: the lower of two has the
// first corner of lower number.
int32_t owner_of_lower(const MeshPart& part, int32_t a, int32_t b)
{
    const int32_t first = part.tets[a][0], second = part.tets[b][0];
    return part.owners[part.numbers[first] < part.numbers[second] ? first : second];
}

// By rank: the triangles whose corner of the least number is owned. All tetrahedra there have arrived, so both sides
// are known.
Array<Array<SentTriangle>> found_triangles(const BoundingBox& box, const MeshPart& part, const Exchange& exchange,
                                           const Run& run)
{
    const Interfaces all = extract_interfaces({part.points, part.tets, part.material}, box.lo, box.hi, run);
    Array<Array<SentTriangle>> out(to_size(exchange.ranks()));
    const auto add = [&](const Triangle& corners, const std::array<int32_t, 2>& regions, int32_t side, int32_t owner) {
        const Triangle t = least_first(part, corners);
        if (part.owners[t[0]] == exchange.rank())
            out[owner].push_back({side, regions, {part.numbers[t[0]], part.numbers[t[1]], part.numbers[t[2]]}});
    };
    for (int64_t i = 0; i < all.triangles.count(); ++i)
        add(all.triangles[i], all.pairs[i], -1, owner_of_lower(part, all.tets[i][0], all.tets[i][1]));
    for (int64_t i = 0; i < all.hull.count(); ++i)
        add(all.hull[i], {all.hull_region[i], all.hull_region[i]}, static_cast<int32_t>(all.hull_side[i]),
            part.tet_owners[all.hull_tet[i]]);
    return out;
}

void take_triangles(const BoundingBox& box, MeshPart& part, Exchange& exchange, const Run& run)
{
    Array<SentTriangle> arrived = exchange.all_to_all(found_triangles(box, part, exchange, run)).items;
    std::sort(arrived.begin(), arrived.end());
    const LocalNumbers local(part);
    part.triangles.reserve(arrived.size());
    for (const SentTriangle& t : arrived)
        part.triangles.push_back(
            {{local.of(t.corners[0]), local.of(t.corners[1]), local.of(t.corners[2])}, t.regions, t.side});
    part.of_triangles = share_of(part.triangles.count(), exchange);
}

// Of its own by counting; the others come from their owners, in the order in which this rank has them: by owners, and
// by number for each of these.
void take_tet_numbers(MeshPart& part, bool ghosts, Exchange& exchange)
{
    part.tet_numbers.resize(part.of_tets.owned);
    std::iota(part.tet_numbers.begin(), part.tet_numbers.end(), part.of_tets.first);
    if (!ghosts)
        return;
    Array<Array<int64_t>> seen(to_size(exchange.ranks()));
    for (int64_t t = 0; t < part.of_tets.owned; ++t)
        for_each_owner([&](size_t i) { return part.owners[part.tets[t][i]]; },
                       [&](int32_t rank) {
                           if (rank != exchange.rank())
                               seen[rank].push_back(part.tet_numbers[t]);
                       });
    const Array<int64_t> others = exchange.all_to_all(seen).items;
    CLEFT_ASSERT(part.of_tets.owned + others.count() == part.tets.count());
    part.tet_numbers.insert(part.tet_numbers.end(), others.begin(), others.end());
}

// Leaves the tetrahedra that are owned, and the points that are owned or at one of these. All triangles bound these.
void drop_ghosts(MeshPart& part)
{
    part.tets.resize(part.of_tets.owned);
    part.material.resize(part.of_tets.owned);
    part.tet_owners.resize(part.of_tets.owned);
    Array<int32_t> new_number(part.points.size(), -1);
    for (const Tet& tet : part.tets)
        for (const int32_t p : tet)
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

void check_size_of_part(int64_t points, int64_t tets)
{
    const auto check = [](int64_t count, int64_t most, const std::string& what) {
        if (count > most)
            throw Error(CLEFT_ERROR_TOO_LARGE, "a part has " + std::to_string(count) + " " + what +
                                                   ", with ghosts, and may have at most " + std::to_string(most) +
                                                   ": more ranks would share them");
    };
    check(tets, kMostTetsOfMesh, "tetrahedra");
    check(points, INT32_MAX, "points");
}

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
    // Before ghosts are dropped, if nobody wants them: triangles are found among all.
    check_size_of_part(arrived.points.count(), arrived.tets.count());
    MeshPart part;
    take_points(arrived.points, owned, rank, part);
    part.of_points = {owned.first(rank + 1) - owned.first(rank), owned.first(rank), numbers.all};
    take_tets(arrived.tets, LocalNumbers(part), owned, rank, part);
    part.of_tets = share_of(part.of_tets.owned, exchange);
    take_triangles(box, part, exchange, stage.next());
    if (!ghosts)
        drop_ghosts(part);
    take_tet_numbers(part, ghosts, exchange);
    return part;
}

}  // namespace cleft
