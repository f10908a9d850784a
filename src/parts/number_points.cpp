// A sort over ranks: pieces of the curve go to one rank each, which sorts and counts what it gets.
#include "parts/number_points.hpp"

#include "base/large_pages.hpp"
#include "mesh/curve_order.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

struct OnCurve {
    uint64_t place;
    double x[3];
    bool operator<(const OnCurve& o) const
    {
        return place != o.place ? place < o.place : std::lexicographical_compare(x, x + 3, o.x, o.x + 3);
    }
};

// So many places for each rank, from each rank: pieces of the curve are then equal within some percent. The numbers do
// not depend on where the pieces end.
constexpr int64_t kSamples = 32;

// Where the pieces of the curve end: rank r sorts what is before ends[r].
Array<uint64_t> ends_of_pieces(const Array<OnCurve>& sorted, Exchange& exchange)
{
    struct Sample {
        uint64_t place;
        double weight;  // points that it stands for
    };
    Array<Sample> own;
    const int64_t count = std::min(sorted.count(), kSamples * exchange.ranks());
    for (int64_t s = 0; s < count; ++s)
        own.push_back({sorted[s * sorted.count() / count].place,
                       static_cast<double>(sorted.count()) / static_cast<double>(count)});
    Array<Sample> samples = exchange.all_gather(own);
    std::sort(samples.begin(), samples.end(), [](const Sample& a, const Sample& b) { return a.place < b.place; });
    double all = 0;
    for (const Sample& sample : samples)
        all += sample.weight;
    Array<uint64_t> ends;
    double before = 0;
    for (const Sample& sample : samples) {
        while (ends.count() < exchange.ranks() - 1 && before >= all / exchange.ranks() * double(ends.count() + 1))
            ends.push_back(sample.place);
        before += sample.weight;
    }
    ends.resize(exchange.ranks(), UINT64_MAX);
    return ends;
}

// The points of all pieces on the curve.
Array<OnCurve> places_of(const MeshPieces& pieces, const BoundingBox& box, Array<int64_t>& start)
{
    Array<OnCurve> places;
    for (int32_t i = 0; i < pieces.count; ++i) {
        start.push_back(places.count());
        const Array<Vec3>& points = pieces.read(i).points;
        make_room(places, points.size());
        for (const Vec3& x : points)
            places.push_back({place_on_curve(x, box), {x[0], x[1], x[2]}});
    }
    return places;
}

// `order`: where each was before.
Array<OnCurve> sorted_places(const Array<OnCurve>& places, Array<int64_t>& order)
{
    order.resize(places.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int64_t a, int64_t b) { return places[a] < places[b]; });
    Array<OnCurve> sorted;
    sorted.reserve(places.size());
    for (const int64_t p : order)
        sorted.push_back(places[p]);
    return sorted;
}

bool are_one(const OnCurve& a, const OnCurve& b) { return !(a < b) && !(b < a); }

// By place in `received`: the number of the point among the different ones of all ranks.
Array<int64_t> numbers_of(const Array<OnCurve>& received, int64_t& all, Exchange& exchange)
{
    Array<int64_t> order(received.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int64_t a, int64_t b) { return received[a] < received[b]; });
    Array<int64_t> numbers(received.size());
    int64_t different = 0;
    for (int64_t i = 0; i < order.count(); ++i) {
        different += i == 0 || !are_one(received[order[i - 1]], received[order[i]]);
        numbers[order[i]] = different - 1;
    }
    const Array<int64_t> counts = exchange.all_gather(different);
    const int64_t before = std::accumulate(counts.begin(), counts.begin() + exchange.rank(), int64_t{0});
    all = std::accumulate(counts.begin(), counts.end(), int64_t{0});
    for (int64_t& number : numbers)
        number += before;
    return numbers;
}

}  // namespace

NumberedPoints number_points(const MeshPieces& pieces, const BoundingBox& box, Exchange& exchange)
{
    NumberedPoints out;
    Array<int64_t> order;
    Array<OnCurve> sorted = sorted_places(places_of(pieces, box, out.start), order);
    const Array<uint64_t> ends = ends_of_pieces(sorted, exchange);
    Array<int64_t> counts(to_size(exchange.ranks()), 0);
    int32_t piece = 0;
    for (const OnCurve& point : sorted) {
        while (piece < exchange.ranks() - 1 && point.place >= ends[piece])
            ++piece;
        ++counts[piece];
    }
    Received<OnCurve> received = exchange.all_to_all(sorted, counts);
    sorted = Array<OnCurve>();
    const Array<int64_t> numbers = numbers_of(received.items, out.all, exchange);
    received.items = Array<OnCurve>();
    // Back on the way that the points came.
    Array<int64_t> came(to_size(exchange.ranks()));
    for (int32_t r = 0; r < exchange.ranks(); ++r)
        came[r] = received.start[r + 1] - received.start[r];
    const Array<int64_t> back = exchange.all_to_all(numbers, came).items;
    out.of_points.resize(order.size());
    for (int64_t i = 0; i < order.count(); ++i)
        out.of_points[order[i]] = back[i];
    return out;
}

}  // namespace cleft
