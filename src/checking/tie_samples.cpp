// The places are those of quadrature rules, so that they serve for means as well as for the greatest distance: on a
// curved surface, chords are furthest off in their middles, and a point that improving has moved is off by itself.
#include "checking/tie_samples.hpp"

#include <algorithm>
#include <tuple>

namespace cleft
{

namespace
{

// Simpson's rule and that of the triangle with seven places: both are exact for cubic functions.
constexpr double kEndWeight = 1. / 6, kMiddleWeight = 4. / 6;
constexpr double kCornerWeight = 3. / 60, kEdgeWeight = 8. / 60, kCentroidWeight = 27. / 60;

struct Places {
    Array<TieSample>& samples;
    const TieElement& element;
    double size;

    void add(std::array<int32_t, 3> corner, double share) const
    {
        std::sort(corner.begin(), corner.end());
        samples.push_back({element.of, {corner[0], corner[1], corner[2]}, share * size});
    }
};

void add_edge(const Places& places)
{
    const auto& c = places.element.corner;
    places.add({c[0], c[0], c[0]}, kEndWeight);
    places.add({c[1], c[1], c[1]}, kEndWeight);
    places.add({-1, c[0], c[1]}, kMiddleWeight);
}

void add_triangle(const Places& places)
{
    const auto& c = places.element.corner;
    for (int i = 0; i < 3; ++i) {
        places.add({c[i], c[i], c[i]}, kCornerWeight);
        places.add({-1, c[i], c[(i + 1) % 3]}, kEdgeWeight);
    }
    places.add({c[0], c[1], c[2]}, kCentroidWeight);
}

}  // namespace

Vec3 TieSample::place(const Array<Vec3>& points) const
{
    return corner[0] < 0 ? Vec3(0.5 * (points[corner[1]] + points[corner[2]]))
                         : Vec3((points[corner[0]] + points[corner[1]] + points[corner[2]]) / 3);
}

Array<TieSample> tie_samples(const Array<TieElement>& elements, const Array<Vec3>& points, const Placement& world)
{
    Array<TieSample> samples;
    samples.reserve(7 * elements.size());
    for (const TieElement& element : elements) {
        const Vec3 &a = points[element.corner[0]], &b = points[element.corner[1]], &c = points[element.corner[2]];
        if (element.of.is_line())
            add_edge({samples, element, (world.linear * (b - a)).norm()});
        else
            add_triangle({samples, element, 0.5 * world.area(b - a, c - a)});
    }
    // Stable, so that sums of weights have one order.
    std::stable_sort(samples.begin(), samples.end(), [](const TieSample& a, const TieSample& b) {
        return a.of != b.of ? a.of < b.of : a.corner < b.corner;
    });
    Array<TieSample> once;
    for (const TieSample& sample : samples)
        if (!once.empty() && once.back().of == sample.of && once.back().corner == sample.corner)
            once.back().weight += sample.weight;
        else
            once.push_back(sample);
    return once;
}

}  // namespace cleft
