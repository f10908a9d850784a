// What the volume says at the vertices of the background, kept short: root searches start from both ends of an edge.
#pragma once

#include "base/array.hpp"
#include "volume/material_set.hpp"
#include "volume/volume.hpp"

#include <limits>

namespace cleft
{

// A float is enough: values only start a search, which samples the volume itself. It halves the memory.
struct MaterialValue {
    float value;
    uint16_t material;
};

class SampleStore
{
public:
    // The values of vertices 0 .. n-1 one after the other, `count` of each.
    SampleStore(Array<MaterialValue> values, const Array<uint16_t>& count) : values_(std::move(values))
    {
        spans_.reserve(count.size());
        size_t begin = 0;
        for (const uint16_t n : count) {
            spans_.push_back({begin, n});
            begin += n;
        }
    }

    static void append(const Samples& samples, Array<MaterialValue>& values)
    {
        for (size_t i = 0; i < samples.size(); ++i)
            values.push_back({static_cast<float>(samples.value[i]), static_cast<uint16_t>(samples.material[i])});
    }

    struct Span {
        size_t begin;
        uint16_t count;
    };

    // The values of a vertex that moved go to the end; the old ones stay, so that a span once read stays valid.
    Span add(const Samples& samples)
    {
        const Span span{values_.size(), static_cast<uint16_t>(samples.size())};
        append(samples, values_);
        return span;
    }
    // Forgets everything added from a span on.
    // Only the last span can be dropped. Trials that fail are dropped at once, so they leave nothing behind.
    void drop(const Span& span)
    {
        CLEFT_ASSERT(span.begin + span.count == values_.size());
        values_.resize(span.begin);
    }

    Span of(int32_t vertex) const { return spans_[vertex]; }
    void set(int32_t vertex, const Span& span) { spans_[vertex] = span; }

    // Greatest value over A minus greatest value over B; a material without an entry has the value 0.
    double difference(int32_t vertex, const MaterialSet& a, const MaterialSet& b) const
    {
        const Span span = of(vertex);
        return greatest(span, a) - greatest(span, b);
    }

private:
    double greatest(const Span& span, const MaterialSet& set) const
    {
        double greatest = -std::numeric_limits<double>::infinity();
        for (const Material m : set)
            greatest = std::max(greatest, value(span, m));
        return greatest;
    }
    double value(const Span& span, Material m) const
    {
        for (size_t i = span.begin; i < span.begin + span.count; ++i)
            if (values_[i].material == m)
                return static_cast<double>(values_[i].value);
        return 0;
    }

    Array<MaterialValue> values_;
    Array<Span> spans_;
};

}  // namespace cleft
