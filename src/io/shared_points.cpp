// Sorted by their coordinates, equal points lie beside each other.
#include "io/shared_points.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <array>
#include <numeric>
#include <string>

namespace cleft::io
{

namespace
{

// The part of each point.
std::vector<int32_t> parts_of(const std::vector<int64_t>& part_points)
{
    std::vector<int32_t> parts;
    for (size_t p = 0; p < part_points.size(); ++p)
        parts.insert(parts.end(), static_cast<size_t>(part_points[p]), static_cast<int32_t>(p));
    return parts;
}

// For each point the one that stands for it.
std::vector<int32_t> leaders_of(const std::vector<int32_t>& parts, const std::vector<double>& points)
{
    const auto place = [&](int32_t point) {
        const double* at = points.data() + 3 * static_cast<size_t>(point);
        return std::array<double, 3>{at[0], at[1], at[2]};
    };
    std::vector<int32_t> order(parts.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int32_t a, int32_t b) {
        const auto left = place(a), right = place(b);
        return left != right ? left < right : a < b;
    });
    std::vector<int32_t> leaders(parts.size());
    for (size_t i = 0, first = 0; i < order.size(); ++i) {
        const int32_t point = order[i];
        if (i == 0 || place(order[first]) != place(point))
            first = i;
        // Beside an equal point of its own part, it stays apart.
        const bool is_shared =
            i > first && parts[static_cast<size_t>(order[i - 1])] != parts[static_cast<size_t>(point)];
        leaders[static_cast<size_t>(point)] = is_shared ? order[first] : point;
    }
    return leaders;
}

}  // namespace

void join_shared_points(const std::vector<int64_t>& part_points, MeshData& mesh)
{
    const std::vector<int32_t> leaders = leaders_of(parts_of(part_points), mesh.points);
    std::vector<int32_t> numbers(leaders.size());
    int32_t count = 0;
    for (size_t i = 0; i < leaders.size(); ++i) {
        const auto leader = static_cast<size_t>(leaders[i]);
        // A leader comes before those that it stands for.
        numbers[i] = leader == i ? count++ : numbers[leader];
        if (leader == i)
            std::copy_n(mesh.points.data() + 3 * i, 3, mesh.points.data() + 3 * static_cast<size_t>(numbers[i]));
    }
    mesh.points.resize(3 * static_cast<size_t>(count));
    for (int32_t& corner : mesh.tets)
        corner = numbers[static_cast<size_t>(corner)];
}

void join_points_of_numbers(const std::vector<int64_t>& numbers, MeshData& mesh)
{
    std::vector<int32_t> order(numbers.size());
    std::iota(order.begin(), order.end(), 0);
    const auto number = [&](int32_t point) { return numbers[static_cast<size_t>(point)]; };
    std::sort(order.begin(), order.end(),
              [&](int32_t a, int32_t b) { return number(a) != number(b) ? number(a) < number(b) : a < b; });
    std::vector<double> points;
    std::vector<int32_t> joined(numbers.size());
    for (size_t i = 0; i < order.size(); ++i) {
        const double* const at = mesh.points.data() + 3 * static_cast<size_t>(order[i]);
        if (i == 0 || number(order[i]) != number(order[i - 1]))
            points.insert(points.end(), at, at + 3);
        else if (!std::equal(at, at + 3, points.end() - 3))
            throw Error(CLEFT_ERROR_FORMAT,
                        "pieces have point " + std::to_string(number(order[i])) + " of the mesh at different places");
        joined[static_cast<size_t>(order[i])] = static_cast<int32_t>(points.size() / 3 - 1);
    }
    mesh.points = std::move(points);
    for (int32_t& corner : mesh.tets)
        corner = joined[static_cast<size_t>(corner)];
}

}  // namespace cleft::io
