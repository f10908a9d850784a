// What the volume says at the vertices of the background, kept short: root searches start from both ends of an edge.
#pragma once

#include "base/array.hpp"
#include "volume/material_set.hpp"
#include "volume/volume.hpp"

#include <algorithm>
#include <deque>
#include <limits>
#include <memory>

namespace cleft
{

// A float is enough: values only start a search, which samples the volume itself. It halves the memory.
struct MaterialValue {
    float value;
    uint16_t material;
};

// The values of one vertex. They stay where they are as long as the store does.
struct SampleSpan {
    const MaterialValue* first = nullptr;
    uint16_t count = 0;
};

// Values that one thread adds and drops while others read theirs: memory that never moves.
class SampleArena
{
public:
    SampleSpan add(const Samples& samples)
    {
        if (used_ + samples.size() > capacity_) {
            capacity_ = std::max(kLeastBlock, samples.size());
            blocks_.push_back(std::make_unique<MaterialValue[]>(capacity_));
            used_ = 0;
        }
        MaterialValue* first = blocks_.back().get() + used_;
        for (size_t i = 0; i < samples.size(); ++i)
            first[i] = {static_cast<float>(samples.value[i]), static_cast<uint16_t>(samples.material[i])};
        used_ += samples.size();
        return {first, static_cast<uint16_t>(samples.size())};
    }
    // Only the span that was added last can be dropped. Trials that fail are dropped at once, so they leave nothing
    // behind.
    void drop(const SampleSpan& span)
    {
        CLEFT_ASSERT(used_ >= span.count && blocks_.back().get() + (used_ - span.count) == span.first);
        used_ -= span.count;
    }

private:
    // Some hundred vertices have room in it.
    static constexpr size_t kLeastBlock = 2048;

    Array<std::unique_ptr<MaterialValue[]>> blocks_;
    size_t capacity_ = 0, used_ = 0;  // of the last block
};

class SampleStore
{
public:
    // The values of vertices 0 .. n-1 one after the other, `count` of each.
    SampleStore(Array<MaterialValue> values, const Array<uint16_t>& count) : values_(std::move(values))
    {
        spans_.reserve(count.size());
        const MaterialValue* first = values_.data();
        for (const uint16_t n : count) {
            spans_.push_back({first, n});
            first += n;
        }
    }
    // Spans point into the values, which a move takes along.
    SampleStore(SampleStore&&) = default;
    SampleStore(const SampleStore&) = delete;

    static void append(const Samples& samples, Array<MaterialValue>& values)
    {
        for (size_t i = 0; i < samples.size(); ++i)
            values.push_back({static_cast<float>(samples.value[i]), static_cast<uint16_t>(samples.material[i])});
    }

    // For the new values of vertices that move. One for each thread that moves some.
    SampleArena& new_arena() { return arenas_.emplace_back(); }

    SampleSpan of(int32_t vertex) const { return spans_[vertex]; }
    void set(int32_t vertex, const SampleSpan& span) { spans_[vertex] = span; }

    // Greatest value over A minus greatest value over B; a material without an entry has the value 0.
    double difference(int32_t vertex, const MaterialSet& a, const MaterialSet& b) const
    {
        const SampleSpan span = of(vertex);
        return greatest(span, a) - greatest(span, b);
    }

private:
    static double greatest(const SampleSpan& span, const MaterialSet& set)
    {
        double greatest = -std::numeric_limits<double>::infinity();
        for (const Material m : set)
            greatest = std::max(greatest, value(span, m));
        return greatest;
    }
    static double value(const SampleSpan& span, Material m)
    {
        for (uint16_t i = 0; i < span.count; ++i)
            if (span.first[i].material == m)
                return static_cast<double>(span.first[i].value);
        return 0;
    }

    Array<MaterialValue> values_;
    Array<SampleSpan> spans_;
    std::deque<SampleArena> arenas_;
};

}  // namespace cleft
