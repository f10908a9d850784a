// Counts the values of a field, and compares neighbours.
#include "io/field_values.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>
#include <type_traits>

namespace cleft::io
{

namespace
{

// How often each value comes, for the first `many` different ones. Voxels of one value come in runs.
class ValueCounter
{
public:
    // An open hash table of fixed size, at most a quarter full: it needs no memory while it counts.
    ValueCounter() : slots_(4 * FieldValues::kMany) {}

    void add(double value)
    {
        // The first value always fails the comparison, as last_value_ is then NaN.
        if (value == last_value_) {
            ++*last_count_;
            return;
        }
        last_value_ = value;
        last_count_ = &count_of(value);
        ++*last_count_;
    }

    int64_t different() const { return different_; }

    std::vector<std::pair<double, int64_t>> sorted() const
    {
        std::vector<std::pair<double, int64_t>> all;
        for (const auto& slot : slots_)
            if (slot.second > 0)
                all.push_back(slot);
        // The order of the table depends on the hash. Sorted, it is that of the values.
        std::sort(all.begin(), all.end());
        return all;
    }

private:
    int64_t& count_of(double value)
    {
        uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        // Fibonacci hashing by 2^64 over the golden ratio. Small whole numbers differ in the
        // highest bits of a double alone, and the product spreads them.
        size_t at = static_cast<size_t>((bits * 0x9E3779B97F4A7C15u) >> 32) % slots_.size();
        while (slots_[at].second > 0 && slots_[at].first != value)
            at = (at + 1) % slots_.size();
        if (slots_[at].second > 0)
            return slots_[at].second;
        // Beyond the limit only the fact is of interest, so counts go to a place that nobody reads.
        if (different_ >= FieldValues::kMany) {
            different_ = FieldValues::kMany + 1;
            return beyond_;
        }
        ++different_;
        slots_[at].first = value;
        return slots_[at].second;
    }

    std::vector<std::pair<double, int64_t>> slots_;
    int64_t different_ = 0;
    int64_t beyond_ = 0;
    double last_value_ = std::numeric_limits<double>::quiet_NaN();
    int64_t* last_count_ = nullptr;
};

// Of whole numbers of at most 16 bits, which are most label maps: by a table, several times faster than one by one.
template <class T>
FieldValues values_by_table(const Image& image, int64_t field)
{
    constexpr int64_t kLowest = std::numeric_limits<T>::min();
    std::vector<int64_t> counts(size_t{1} << 8 * sizeof(T));
    const std::byte* voxels = image.voxels.get() + static_cast<size_t>(field * image.field_size()) * sizeof(T);
    for (int64_t v = 0; v < image.field_size(); ++v)
        ++counts[static_cast<size_t>(load<T>(voxels, v) - kLowest)];
    FieldValues values;
    values.voxels = image.field_size();
    for (size_t i = 0; i < counts.size(); ++i)
        if (counts[i] > 0)
            values.snapped_counts.emplace_back(static_cast<double>(static_cast<int64_t>(i) + kLowest), counts[i]);
    values.least = values.snapped_counts.front().first;
    values.greatest = values.snapped_counts.back().first;
    values.different = std::min(static_cast<int64_t>(values.snapped_counts.size()), FieldValues::kMany + 1);
    if (values.different > FieldValues::kMany)
        values.snapped_counts.clear();
    return values;
}

std::string place_of(const Image& image, int64_t field, int64_t voxel)
{
    return voxel_in_words(voxel, image.dims) +
           (image.fields > 1 ? " in the " + ordinal(field) + " frame" : std::string());
}

FieldValues values_one_by_one(const Image& image, int64_t field)
{
    FieldValues values;
    values.voxels = image.field_size();
    values.least = std::numeric_limits<double>::max();
    values.greatest = std::numeric_limits<double>::lowest();
    ValueCounter exact;
    ValueCounter rounded;
    for_each_value(image, field, [&](int64_t voxel, double value) {
        // The core would refuse it, too, but knows neither the file nor the frame.
        if (!std::isfinite(value))
            throw Error(CLEFT_ERROR_NOT_FINITE, place_of(image, field, voxel) + " is " +
                                                    (std::isnan(value) ? "not a number (NaN)" : "infinite"));
        values.least = std::min(values.least, value);
        values.greatest = std::max(values.greatest, value);
        const double nearest = snapped(value);
        const double off = std::abs(value - std::round(value));
        values.greatest_off = std::max(values.greatest_off, off);
        values.not_whole += off > 0 ? 1 : 0;
        values.fractions += off > 0 && nearest == value ? 1 : 0;
        // -0 becomes 0, since the hash is of the bits.
        exact.add(value + 0.0);
        rounded.add(nearest);
    });
    values.different = exact.different();
    if (rounded.different() <= FieldValues::kMany)
        values.snapped_counts = rounded.sorted();
    return values;
}

double most_frequent(const FieldValues& values)
{
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto& counts = values.snapped_counts;
    return counts.empty() ? values.least : std::max_element(counts.begin(), counts.end(), less)->first;
}

// Pairs of neighbours that are not both of the background, and how many of them differ.
template <class T>
class NeighbourPairs
{
public:
    NeighbourPairs(const std::byte* voxels, double background, bool rounding)
        : voxels_(voxels), background_(static_cast<Value>(background)), rounding_(rounding)
    {
    }

    // The pairs of `count` voxels from `start` on, each with the one `step` voxels behind it.
    void add(int64_t start, int64_t count, int64_t step)
    {
        int64_t pairs = 0;
        int64_t differing = 0;
        for (int64_t v = start; v < start + count; ++v) {
            const Value value = value_at(v);
            const Value neighbour = value_at(v + step);
            const bool differ = value != neighbour;
            // Bitwise or, without a branch, lets the compiler take many voxels at once.
            pairs += (differ | (value != background_)) ? 1 : 0;
            differing += differ ? 1 : 0;
        }
        pairs_ += pairs;
        differing_ += differing;
    }

    double share_of_differing() const
    {
        return pairs_ > 0 ? static_cast<double>(differing_) / static_cast<double>(pairs_) : 0;
    }

private:
    // Whole numbers are compared as they are, many at a time; a background taken from doubles fits up to 32 bits.
    static constexpr bool kAsTheyAre = std::is_integral_v<T> && sizeof(T) <= 4;
    using Value = std::conditional_t<kAsTheyAre, T, double>;

    Value value_at(int64_t voxel) const
    {
        const T value = load<T>(voxels_, voxel);
        if constexpr (kAsTheyAre)
            return value;
        else
            return rounding_ ? snapped(static_cast<double>(value)) : static_cast<double>(value);
    }

    const std::byte* voxels_;
    Value background_;
    bool rounding_;
    int64_t pairs_ = 0;
    int64_t differing_ = 0;
};

}  // namespace

double snapped(double value)
{
    // See the header for 1/50. Four units of single precision cover a product of two rounded
    // factors.
    constexpr double kRounding = 1.0 / 50;
    constexpr double kPrecision = 4 * static_cast<double>(FLT_EPSILON);
    const double whole = std::round(value);
    // A quarter at most: beyond it, the nearest whole number is no longer certain.
    const double allowed = std::min(0.25, std::max(kRounding, kPrecision * std::abs(value)));
    return std::abs(value - whole) <= allowed ? whole + 0.0 : value;  // no -0
}

bool FieldValues::is_mask() const
{
    if (!is_whole() || snapped_counts.empty() || snapped_counts.size() > 2)
        return false;
    return snapped_counts.front().first == 0 || (snapped_counts.size() == 1 && snapped_counts.front().first > 0);
}

FieldValues values_of(const Image& image, int64_t field)
{
    return with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        // A table for 16 bits has 65,536 counters; one for 32 bits would be larger than most
        // fields.
        if constexpr (sizeof(T) <= 2)
            return values_by_table<T>(image, field);
        else
            return values_one_by_one(image, field);
    });
}

double differing_neighbours(const Image& image, int64_t field, const FieldValues& values)
{
    const int64_t row = image.dims[0];
    const int64_t slice = row * image.dims[1];
    const int64_t size = image.field_size();
    return with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        const std::byte* voxels = image.voxels.get() + static_cast<size_t>(field * size) * sizeof(T);
        NeighbourPairs<T> pairs(voxels, most_frequent(values), values.is_whole());
        // Rows one by one, so that the last voxel of a row is not compared with the first of the
        // next.
        for (int64_t start = 0; start < size; start += row)
            pairs.add(start, row - 1, 1);
        for (int64_t start = 0; start < size; start += slice)
            pairs.add(start, slice - row, row);
        pairs.add(0, size - slice, slice);
        return pairs.share_of_differing();
    });
}

}  // namespace cleft::io
