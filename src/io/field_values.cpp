// Counts the values of a field, and compares neighbours.
#include "io/field_values.hpp"

#include "base/error.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <limits>

namespace cleft::io
{

namespace
{

// How often each value comes, for the first `many` different ones. Voxels of one value come in runs.
class ValueCounter
{
public:
    ValueCounter() : slots_(4 * FieldValues::many) {}

    void add(double value)
    {
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
        std::sort(all.begin(), all.end());
        return all;
    }

private:
    int64_t& count_of(double value)
    {
        uint64_t bits = 0;
        std::memcpy(&bits, &value, sizeof bits);
        size_t at = static_cast<size_t>((bits * 0x9E3779B97F4A7C15u) >> 32) % slots_.size();
        while (slots_[at].second > 0 && slots_[at].first != value)
            at = (at + 1) % slots_.size();
        if (slots_[at].second > 0)
            return slots_[at].second;
        if (different_ >= FieldValues::many) {
            different_ = FieldValues::many + 1;
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

std::string place_of(const Image& image, int64_t field, int64_t voxel)
{
    const auto text = [](int64_t number) { return std::to_string(number); };
    return "voxel (" + text(voxel % image.dims[0]) + ", " + text(voxel / image.dims[0] % image.dims[1]) + ", " +
           text(voxel / (image.dims[0] * image.dims[1])) + ")" +
           (image.fields > 1 ? " of frame " + text(field) : std::string());
}

double most_frequent(const FieldValues& values)
{
    const auto less = [](const auto& a, const auto& b) { return a.second < b.second; };
    const auto& counts = values.snapped_counts;
    return counts.empty() ? values.least : std::max_element(counts.begin(), counts.end(), less)->first;
}

}  // namespace

double snapped(double value)
{
    constexpr double rounding = 1.0 / 50;
    constexpr double precision = 4 * static_cast<double>(FLT_EPSILON);
    const double whole = std::round(value);
    const double allowed = std::min(0.25, std::max(rounding, precision * std::abs(value)));
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
    FieldValues values;
    values.voxels = image.field_size();
    values.least = std::numeric_limits<double>::max();
    values.greatest = std::numeric_limits<double>::lowest();
    ValueCounter exact;
    ValueCounter rounded;
    for_each_value(image, field, [&](int64_t voxel, double value) {
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
        exact.add(value + 0.0);
        rounded.add(nearest);
    });
    values.different = exact.different();
    if (rounded.different() <= FieldValues::many)
        values.snapped_counts = rounded.sorted();
    return values;
}

double differing_neighbours(const Image& image, int64_t field, const FieldValues& values)
{
    const double background = most_frequent(values);
    const bool rounding = values.is_whole();
    int64_t pairs = 0;
    int64_t differ = 0;
    with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        const std::byte* first = image.voxels.get() + static_cast<size_t>(field * image.field_size()) * sizeof(T);
        const auto value_at = [&](int64_t voxel) {
            const auto value = static_cast<double>(load<T>(first, voxel));
            return rounding ? snapped(value) : value;
        };
        const auto compare = [&](double value, int64_t other) {
            const double neighbour = value_at(other);
            if (value == background && neighbour == background)
                return;
            ++pairs;
            differ += value != neighbour ? 1 : 0;
        };
        const int64_t row = image.dims[0];
        const int64_t slice = row * image.dims[1];
        for (int64_t v = 0; v < image.field_size(); ++v) {
            const double value = value_at(v);
            if (v % row + 1 < row)
                compare(value, v + 1);
            if (v % slice + row < slice)
                compare(value, v + row);
            if (v + slice < image.field_size())
                compare(value, v + slice);
        }
    });
    return pairs > 0 ? static_cast<double>(differ) / static_cast<double>(pairs) : 0;
}

}  // namespace cleft::io
