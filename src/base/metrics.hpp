// What a stage reports about itself: named numbers in the order in which they were noted.
// Names are dotted, stage first: "background.repair.min_angle_before".
#pragma once

#include "base/array.hpp"

#include <string>
#include <utility>

namespace cleft
{

struct Metrics {
    Array<std::pair<std::string, double>> items;

    void set(const std::string& name, double value)
    {
        for (auto& item : items)
            if (item.first == name) {
                item.second = value;
                return;
            }
        items.emplace_back(name, value);
    }

    // The value noted under `name`, or `fallback`.
    double get(const std::string& name, double fallback = 0.0) const
    {
        for (const auto& item : items)
            if (item.first == name)
                return item.second;
        return fallback;
    }
};

}  // namespace cleft
