// Finds which label values a volume has, and replaces them by dense numbers. Hash tables only look values up: the order
// of the numbers comes from the voxels.
#include "volume/label_values.hpp"

#include "base/parallel.hpp"

#include <algorithm>
#include <limits>
#include <type_traits>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace cleft
{

namespace
{

// Voxels between two looks for too many labels and for a cancel: a grey-scale image is refused early, not at its end.
constexpr int64_t kVoxelsListed = int64_t{1} << 18;

// Sets and maps over all values of a small type are arrays; 32-bit values are hashed.
// An array of 65,536 entries is faster than a hash, and 32-bit values have too many for an array.
template <class Value>
constexpr bool kIsSmall = sizeof(Value) <= 2;

template <class Value>
constexpr size_t kValueCount = size_t{1} << (8 * (kIsSmall<Value> ? sizeof(Value) : 0));

template <class Value>
std::make_unsigned_t<Value> slot(Value value)
{
    return static_cast<std::make_unsigned_t<Value>>(value);
}

// Different values in the order in which they came.
template <class Value>
class ValueSet
{
public:
    ValueSet() : seen_(kValueCount<Value>, 0) {}
    void insert(Value value)
    {
        bool is_new = false;
        if constexpr (kIsSmall<Value>)
            is_new = std::exchange(seen_[slot(value)], uint8_t{1}) == 0;
        else
            is_new = hashed_.insert(value).second;
        if (is_new)
            values_.push_back(value);
    }
    const Array<Value>& values() const { return values_; }

private:
    Array<uint8_t> seen_;
    std::unordered_set<Value> hashed_;
    Array<Value> values_;
};

template <class Value, class Label>
class ValueMap
{
public:
    explicit ValueMap(const Array<UserLabel>& labels) : place_(kValueCount<Value>, 0)
    {
        for (size_t i = 0; i < labels.size(); ++i) {
            const auto value = static_cast<Value>(number_of(labels[i]));
            if constexpr (kIsSmall<Value>)
                place_[slot(value)] = static_cast<Label>(i);
            else
                hashed_.emplace(value, static_cast<Label>(i));
        }
    }
    Label at(Value value) const
    {
        if constexpr (kIsSmall<Value>)
            return place_[slot(value)];
        else
            return hashed_.at(value);
    }

private:
    Array<Label> place_;
    std::unordered_map<Value, Label> hashed_;
};

}  // namespace

void refuse_label_count()
{
    throw Error(CLEFT_ERROR_ARGUMENT, "the volume has more than 65535 different labels; is it a grey-scale image?");
}

template <class Value>
Array<UserLabel> distinct_labels(const Value* voxels, int64_t n, const Run& run)
{
    // One thread, since the numbers follow from which voxel comes first.
    ValueSet<Value> set;
    Value last = voxels[0];
    set.insert(last);
    for (int64_t begin = 0; begin < n; begin += kVoxelsListed) {
        run.report(static_cast<double>(begin) / static_cast<double>(n));
        // Labels come in runs: look at the first voxel of each.
        for (int64_t i = begin; i < std::min(n, begin + kVoxelsListed); ++i)
            if (voxels[i] != last) {
                last = voxels[i];
                set.insert(last);
            }
        if (set.values().size() > kGreatestLabelCount)
            refuse_label_count();
    }
    const Array<Value>& values = set.values();
    if constexpr (std::is_same_v<Value, uint32_t>)
        if (const uint32_t greatest = *std::max_element(values.begin(), values.end()); greatest > uint32_t{INT32_MAX})
            throw Error(CLEFT_ERROR_ARGUMENT, "label " + std::to_string(greatest) + " is greater than 2147483647");
    Array<UserLabel> labels;
    labels.reserve(values.size());
    for (const Value value : values)
        labels.push_back(UserLabel{static_cast<int32_t>(value)});
    return labels;
}

template <class Value, class Label>
void dense_materials(const Value* voxels, int64_t n, const Array<UserLabel>& labels, Label* out, const Run& run)
{
    const ValueMap<Value, Label> map(labels);
    parallel_for(run, n, kVoxelsListed, [&](int64_t begin, int64_t end) {
        Value last = voxels[begin];
        Label place = map.at(last);
        for (int64_t i = begin; i < end; ++i) {
            if (voxels[i] != last) {
                last = voxels[i];
                place = map.at(last);
            }
            out[i] = place;
        }
    });
}

#define CLEFT_INSTANTIATE(Value)                                                                         \
    template Array<UserLabel> distinct_labels(const Value*, int64_t, const Run&);                        \
    template void dense_materials(const Value*, int64_t, const Array<UserLabel>&, uint8_t*, const Run&); \
    template void dense_materials(const Value*, int64_t, const Array<UserLabel>&, uint16_t*, const Run&)
CLEFT_INSTANTIATE(uint8_t);
CLEFT_INSTANTIATE(uint16_t);
CLEFT_INSTANTIATE(int16_t);
CLEFT_INSTANTIATE(uint32_t);
CLEFT_INSTANTIATE(int32_t);
#undef CLEFT_INSTANTIATE

}  // namespace cleft
