// Tetrahedra go to the ranks that own a corner, piece by piece; what a rank gets is its part.
#include "parts/mesh_part.hpp"

#include "base/quiet_run.hpp"
#include "base/stage.hpp"
#include "mesh/face_buckets.hpp"
#include "mesh/order.hpp"
#include "parts/share_triangles.hpp"
#include "parts/sorted_runs.hpp"

#include <algorithm>
#include <string>

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

// What arrives at this rank, and about how much: a point that several pieces have counts for each.
struct Arrived {
    explicit Arrived(const std::string& scratch) : tets(scratch), points(scratch) {}

    SortedRuns<SentTet> tets;
    SortedRuns<SentPoint> points;
    int64_t own_tets = 0, other_tets = 0, other_points = 0;
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

// Sends pieces to those who get something of them.
class Sender
{
public:
    Sender(const OwnedNumbers& owned, bool ghosts, Exchange& exchange)
        : owned_(owned), ghosts_(ghosts), exchange_(exchange)
    {
    }

    // The points have these numbers. All ranks call it together.
    void send(const LabelledMesh& piece, const int64_t* numbers, Arrived& arrived)
    {
        needed_.assign(to_size(exchange_.ranks()), Array<int32_t>());
        Array<SentTet> tets = exchange_.all_to_all(tets_by_rank(piece, numbers)).items;
        for (const SentTet& t : tets)
            ++(owned_.owner(t.corners[0]) == exchange_.rank() ? arrived.own_tets : arrived.other_tets);
        arrived.tets.add(std::move(tets));
        Array<SentPoint> points = exchange_.all_to_all(points_by_rank(piece, numbers)).items;
        for (const SentPoint& p : points)
            arrived.other_points += owned_.owner(p.number) != exchange_.rank();
        arrived.points.add(std::move(points));
    }

private:
    // To the owner, and to those whose ghosts they are. Notes the points of others that each rank needs for that.
    Array<Array<SentTet>> tets_by_rank(const LabelledMesh& piece, const int64_t* numbers)
    {
        Array<Array<SentTet>> out(to_size(exchange_.ranks()));
        for (int64_t t = 0; t < piece.tets.count(); ++t) {
            const Tet& local = piece.tets[t];
            WideTet corners{};
            for (size_t i = 0; i < 4; ++i)
                corners[i] = numbers[local[i]];
            const SentTet sent{least_corners_first(corners), piece.material[t]};
            const auto send_to = [&](int32_t rank) {
                out[rank].push_back(sent);
                for (const int32_t p : local)
                    if (owned_.owner(numbers[p]) != rank)
                        needed_[rank].push_back(p);
            };
            if (ghosts_)
                for_each_owner([&](size_t i) { return owned_.owner(corners[i]); }, send_to);
            else
                send_to(owned_.owner(sent.corners[0]));
        }
        return out;
    }

    Array<Array<SentPoint>> points_by_rank(const LabelledMesh& piece, const int64_t* numbers)
    {
        Array<Array<SentPoint>> out(to_size(exchange_.ranks()));
        const auto send_to = [&](int32_t rank, int32_t p) {
            const Vec3& x = piece.points[p];
            out[rank].push_back({numbers[p], {x[0], x[1], x[2]}});
        };
        for (int32_t p = 0; p < piece.points.count(); ++p)
            send_to(owned_.owner(numbers[p]), p);
        for (int32_t r = 0; r < exchange_.ranks(); ++r) {
            Array<int32_t>& points = needed_[r];
            std::sort(points.begin(), points.end());
            points.erase(std::unique(points.begin(), points.end()), points.end());
            for (const int32_t p : points)
                send_to(r, p);
        }
        return out;
    }

    const OwnedNumbers& owned_;
    bool ghosts_;
    Exchange& exchange_;
    Array<Array<int32_t>> needed_;  // by rank: points of the piece that others own
};

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

// The numbers of its own follow each other, so each has its place. Others come behind them.
void take_points(const Arrived& arrived, const OwnedNumbers& owned, int32_t rank, MeshPart& part)
{
    const Share& own = part.of_points;
    part.points.reserve(own.owned + arrived.other_points);
    part.numbers.reserve(own.owned + arrived.other_points);
    part.owners.reserve(own.owned + arrived.other_points);
    part.points.resize(own.owned);
    part.numbers.resize(own.owned);
    part.owners.resize(own.owned, rank);
    arrived.points.visit_all([&](const SentPoint& p) {
        const Vec3 x(p.x[0], p.x[1], p.x[2]);
        if (const int32_t owner = owned.owner(p.number); owner != rank) {
            part.points.push_back(x);
            part.numbers.push_back(p.number);
            part.owners.push_back(owner);
        } else {
            part.points[p.number - own.first] = x;
            part.numbers[p.number - own.first] = p.number;
        }
    });
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

void take_tets(const Arrived& arrived, const LocalNumbers& local, const OwnedNumbers& owned, int32_t rank,
               MeshPart& part)
{
    const int64_t all = arrived.own_tets + arrived.other_tets;
    part.tets.resize(all);
    part.material.resize(all);
    part.tet_owners.resize(all);
    int64_t own = 0, other = arrived.own_tets;
    arrived.tets.visit_all([&](const SentTet& t) {
        const int32_t owner = owned.owner(t.corners[0]);
        const int64_t at = owner == rank ? own++ : other++;
        for (size_t i = 0; i < 4; ++i)
            part.tets[at][i] = local.of(t.corners[i]);
        part.material[at] = t.material;
        part.tet_owners[at] = owner;
    });
    CLEFT_ASSERT(own == arrived.own_tets && other == all);
    part.of_tets.owned = own;
}

void take_triangles(const Array<SentTriangle>& arrived, const LocalNumbers& local, Exchange& exchange, MeshPart& part)
{
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

// What a rank works with at a time: a piece, with labels in the place of materials; an empty one where it has no more.
// Nobody needs it afterwards.
LabelledMesh taken_piece(const MeshPieces& pieces, int32_t i, const Array<UserLabel>& labels)
{
    if (i >= pieces.count)
        return {};
    LabelledMesh piece = std::exchange(pieces.at(i), LabelledMesh());
    for (Material& m : piece.material)
        m = number_of(labels[m]);
    return piece;
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

MeshPart share_mesh(const MeshPieces& pieces, const Array<UserLabel>& labels, const BoundingBox& box, bool ghosts,
                    Exchange& exchange, const Run& run)
{
    Stage stage(run, "sharing", {{"sharing: numbers", 3}, {"sharing: pieces", 5}, {"sharing: parts", 2}});
    stage.next();
    const NumberedPoints numbers = number_points(pieces, box, exchange);
    const OwnedNumbers owned(numbers.all, exchange.ranks());
    const int32_t rank = exchange.rank();
    Arrived arrived(exchange.scratch());
    SharedTriangles triangles(box, owned, exchange);
    Sender sender(owned, ghosts, exchange);
    const Array<int64_t> counts = exchange.all_gather(int64_t{pieces.count});
    const auto rounds = static_cast<int32_t>(*std::max_element(counts.begin(), counts.end()));
    Steps steps(stage.next(), Array<Step>(rounds, {nullptr, 1}));
    for (int32_t i = 0; i < rounds; ++i) {
        const LabelledMesh piece = taken_piece(pieces, i, labels);
        const int64_t* of_piece = i < pieces.count ? numbers.of_piece(i) : nullptr;
        sender.send(piece, of_piece, arrived);
        triangles.add(piece, of_piece, uncounted(steps.next()));
    }
    stage.next();
    MeshPart part;
    part.of_points = {owned.first(rank + 1) - owned.first(rank), owned.first(rank), numbers.all};
    check_size_of_part(part.of_points.owned + arrived.other_points, arrived.own_tets + arrived.other_tets);
    take_points(arrived, owned, rank, part);
    const LocalNumbers local(part);
    take_tets(arrived, local, owned, rank, part);
    part.of_tets = share_of(part.of_tets.owned, exchange);
    take_triangles(triangles.take(), local, exchange, part);
    take_tet_numbers(part, ghosts, exchange);
    return part;
}

}  // namespace cleft
