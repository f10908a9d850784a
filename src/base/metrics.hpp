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

    // A later value replaces an earlier one of that name, so stages of repeated rounds report the last round. A list
    // and no map, for users read them in this order.
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
