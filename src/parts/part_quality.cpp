// Each rank measures what it owns. Percentiles are found by counting, so that no rank has the values of all.
#include "parts/part_quality.hpp"

#include "base/percentile.hpp"
#include "base/stage.hpp"
#include "mesh/quality_sums.hpp"
#include "parts/rank_sums.hpp"

#include <algorithm>
#include <cstring>

namespace cleft
{

namespace
{

// A value is found byte by byte, the highest first: so many values has a byte.
constexpr int64_t kBytesOfDigit = 256;

// The bits of doubles above 0 ascend with their values.
uint64_t bits_of(double value)
{
    uint64_t bits = 0;
    std::memcpy(&bits, &value, sizeof bits);
    return bits;
}

double of_bits(uint64_t bits)
{
    double value = 0;
    std::memcpy(&value, &bits, sizeof value);
    return value;
}

// A value that is looked for among those of all ranks.
struct Wanted {
    int64_t place;       // among the sorted values that begin with the bytes known
    uint64_t known = 0;  // its first bytes
};

// By wanted value and next byte: how many of the values begin with the bytes known of it.
Array<int64_t> counts_of_bytes(const Array<double>& values, const Array<Wanted>& wanted, int shift)
{
    Array<int64_t> counts(wanted.count() * kBytesOfDigit, 0);
    for (const double value : values) {
        const uint64_t begin = bits_of(value) >> shift;
        for (int64_t i = 0; i < wanted.count(); ++i)
            if (begin / kBytesOfDigit == wanted[i].known)
                ++counts[i * kBytesOfDigit + static_cast<int64_t>(begin % kBytesOfDigit)];
    }
    return counts;
}

// Those in these places among the sorted values of all ranks, which are above 0.
Array<double> values_at(const Array<int64_t>& places, const Array<double>& own, Exchange& exchange)
{
    Array<Wanted> wanted;
    for (const int64_t place : places)
        wanted.push_back({place});
    for (int shift = 56; shift >= 0; shift -= 8) {
        const Array<int64_t> counts = sums_of_ranks(counts_of_bytes(own, wanted, shift), exchange);
        for (int64_t i = 0; i < wanted.count(); ++i) {
            const int64_t* count = counts.data() + i * kBytesOfDigit;
            uint64_t byte = 0;
            for (; wanted[i].place >= count[byte]; ++byte)
                wanted[i].place -= count[byte];
            wanted[i].known = wanted[i].known * kBytesOfDigit + byte;
        }
    }
    Array<double> values;
    for (const Wanted& w : wanted)
        values.push_back(of_bits(w.known));
    return values;
}

// By kRatioShares.
Array<double> percentiles_of_all(const Array<double>& ratios, Exchange& exchange)
{
    const int64_t all = sum_of_ranks(ratios.count(), exchange);
    Array<double> percentiles(std::size(kRatioShares), 0.0);
    if (all == 0)
        return percentiles;
    Array<int64_t> places;
    for (const double share : kRatioShares) {
        const PercentilePlace place = PercentilePlace::of(all, share);
        places.push_back(place.below);
        places.push_back(place.above);
    }
    const Array<double> values = values_at(places, ratios, exchange);
    for (size_t i = 0; i < percentiles.size(); ++i)
        percentiles[i] = PercentilePlace::of(all, kRatioShares[i]).between(values[2 * i], values[2 * i + 1]);
    return percentiles;
}

}  // namespace

Quality part_quality(const MeshPart& part, Exchange& exchange, const Run& run)
{
    Steps steps(run, {{"measuring quality", 8}, {nullptr, 2}});
    const MeasuredTets own = measure_tets(part.points, part.tets, part.of_tets.owned, steps.next());
    steps.next();
    // Ranks are in the order of the tetrahedra.
    QualitySums all;
    for (const QualitySums& sums : exchange.all_gather(Array<QualitySums>{own.sums}))
        combine(sums, all);
    if (all.q.tets != part.of_tets.all)
        throw Error(CLEFT_ERROR_ARGUMENT, "the parts are not those of one mesh");
    return finished(all, percentiles_of_all(own.ratios, exchange));
}

Quality own_quality(const MeshPart& part, const Run& run)
{
    const MeasuredTets own = measure_tets(part.points, part.tets, part.of_tets.owned, run);
    Exchange alone = Exchange::alone();
    return finished(own.sums, percentiles_of_all(own.ratios, alone));
}

}  // namespace cleft
