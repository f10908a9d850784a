// Takes in the values of indicator functions, and makes sentinels a little more than the band they lie around.
#include "volume/indicator_values.hpp"

#include "base/counted.hpp"
#include "base/number_text.hpp"
#include "base/ordinal.hpp"
#include "base/parallel.hpp"
#include "base/stage.hpp"
#include "volume/limits.hpp"

#include <algorithm>
#include <cmath>

namespace cleft
{

namespace
{

// Values per chunk: small enough that the error of the lowest chunk, which is the one reported, comes soon.
constexpr int64_t kValuesChecked = int64_t{1} << 16;

// What the values of a field, or of several, are like.
struct Range {
    double greatest = 0;  // magnitude of those within the limit
    int64_t far = 0;      // number of those beyond

    void add(const Range& other)
    {
        greatest = std::max(greatest, other.greatest);
        far += other.far;
    }
};

template <class Value>
Range range_of(const Value* values, const Grid& grid, size_t field, const Run& run)
{
    Array<Range> parts(chunk_count(grid.size(), kValuesChecked));
    parallel_chunks(run, grid.size(), kValuesChecked, [&](int64_t chunk, int64_t begin, int64_t end) {
        Range& part = parts[chunk];
        for (int64_t i = begin; i < end; ++i) {
            const double magnitude = std::abs(static_cast<double>(values[i]));
            if (!std::isfinite(magnitude))
                throw Error(CLEFT_ERROR_NOT_FINITE, "the " + ordinal(static_cast<int64_t>(field)) +
                                                        " indicator function is NaN or infinite at " +
                                                        voxel_in_words(i, grid.dims));
            if (magnitude > kGreatestValue)
                ++part.far;
            else
                part.greatest = std::max(part.greatest, magnitude);
        }
    });
    Range whole;
    for (const Range& part : parts)
        whole.add(part);
    return whole;
}

void warn_of_far_values(int64_t count, double far, const Run& run)
{
    run.warn(counted(count, "value of the indicator functions is", "values of the indicator functions are") +
             " beyond " + number_text(kGreatestValue) + " and taken as far away: as " + number_text(far) +
             " with the same sign");
}

}  // namespace

template <class Value>
Array<Array<float>> bounded_values(const Array<const Value*>& fields, const Grid& grid, const Run& run)
{
    Range range;
    Steps steps(run, {{nullptr, 1}, {nullptr, 1}});
    const Run of_ranges = steps.next();
    for (size_t k = 0; k < fields.size(); ++k)
        range.add(range_of(fields[k], grid, k, of_ranges));
    // A field of sentinels alone has no magnitude of its own; 1 keeps their signs.
    const double far = range.greatest > 0 ? kFarValue * range.greatest : 1;
    if (range.far > 0)
        warn_of_far_values(range.far, far, run);
    Array<Array<float>> out;
    const Run of_copies = steps.next();
    for (size_t k = 0; k < fields.size(); ++k) {
        of_copies.report(static_cast<double>(k) / static_cast<double>(fields.size()));
        out.emplace_back(grid.size());
        parallel_for(run, grid.size(), kValuesChecked, [&, values = fields[k]](int64_t begin, int64_t end) {
            for (int64_t i = begin; i < end; ++i) {
                const auto f = static_cast<double>(values[i]);
                out[k][i] = static_cast<float>(std::abs(f) > kGreatestValue ? std::copysign(far, f) : f);
            }
        });
    }
    return out;
}

template Array<Array<float>> bounded_values(const Array<const float*>&, const Grid&, const Run&);
template Array<Array<float>> bounded_values(const Array<const double*>&, const Grid&, const Run&);

}  // namespace cleft
