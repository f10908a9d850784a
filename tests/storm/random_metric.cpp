// Noise, fields that change along an axis, and single tensors; lengths differ up to 20 times, on random axes.
#include "storm/random_metric.hpp"

#include "support/random.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>

namespace storm
{

namespace
{

using cleft_test::Random;
using Tensor = std::array<double, 6>;  // xx, xy, xz, yy, yz, zz
using Rows = std::array<std::array<double, 3>, 3>;

constexpr double kMostStretch = 20;

// Lengths along axes that three angles turn.
struct Shape {
    std::array<double, 3> lengths{}, angles{};
};

Random random_for(uint64_t seed) { return Random(seed ^ 0x6d65747269630000u); }

Shape random_shape(Random& random, double least)
{
    Shape shape;
    const double stretch = std::pow(kMostStretch, random.unit());
    shape.lengths[0] = least * random.between(0.7, 4);
    shape.lengths[1] = shape.lengths[0] * std::pow(stretch, random.unit());
    shape.lengths[2] = shape.lengths[0] * stretch;
    for (double& angle : shape.angles)
        angle = random.between(-3.2, 3.2);
    return shape;
}

Shape between(const Shape& a, const Shape& b, double part)
{
    Shape shape;
    for (size_t i = 0; i < 3; ++i) {
        shape.lengths[i] = std::pow(a.lengths[i], 1 - part) * std::pow(b.lengths[i], part);
        shape.angles[i] = (1 - part) * a.angles[i] + part * b.angles[i];
    }
    return shape;
}

Tensor tensor_of(const Shape& shape)
{
    Rows rows = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    for (size_t axis = 0; axis < 3; ++axis) {
        const double c = std::cos(shape.angles[axis]), s = std::sin(shape.angles[axis]);
        const size_t p = (axis + 1) % 3, q = (axis + 2) % 3;
        for (auto& row : rows) {
            const double x = row[p], y = row[q];
            row[p] = c * x - s * y;
            row[q] = s * x + c * y;
        }
    }
    const auto entry = [&](size_t i, size_t j) {
        double sum = 0;
        for (size_t k = 0; k < 3; ++k)
            sum += rows[i][k] * rows[j][k] / (shape.lengths[k] * shape.lengths[k]);
        return sum;
    };
    return {entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)};
}

// What the library has to refuse, or takes at its limits.
void spoil(std::vector<double>& tensors, Random& random)
{
    double* const tensor = tensors.data() + 6 * random.below(tensors.size() / 6);
    switch (random.below(4)) {
        case 0:
            tensor[random.below(6)] = std::numeric_limits<double>::quiet_NaN();
            break;
        case 1:
            tensor[0] = -tensor[0];
            break;
        case 2:
            tensor[3] *= std::pow(10, random.between(-9, 9));
            break;
        default: {
            const double scale = std::pow(10, random.between(-9, 9));
            std::for_each(tensor, tensor + 6, [&](double& value) { value *= scale; });
            break;
        }
    }
}

void set_background(Case& made, const std::string& kind)
{
    for (auto& [name, value] : made.options)
        if (name == "background")
            value = kind;
    made.text += ", background " + kind;
}

}  // namespace

bool has_metric(uint64_t seed) { return random_for(seed).below(12) == 0; }

void set_metric(Case& made, uint64_t seed, double least)
{
    Random random = random_for(seed);
    random.bits();  // what has_metric() took
    const uint64_t kind = random.below(3);
    static const char* const kNames[] = {"a metric of noise", "a metric that changes", "one metric"};
    made.text += std::string(", ") + kNames[kind];
    const Shape first = random_shape(random, least), last = random_shape(random, least);
    const size_t axis = random.below(3);
    const int64_t count = kind == 2 ? 1 : made.voxel_count();
    const std::array<int64_t, 3> strides = {1, made.dims[0], made.dims[0] * made.dims[1]};
    for (int64_t v = 0; v < count; ++v) {
        const auto place = static_cast<double>(v / strides[axis] % made.dims[axis]);
        const Shape shape = kind == 0 ? random_shape(random, least)
                                      : between(first, last, place / static_cast<double>(made.dims[axis]));
        for (const double entry : tensor_of(shape))
            made.tensors.push_back(entry);
    }
    if (random.below(8) == 0) {
        spoil(made.tensors, random);
        made.text += ", spoiled";
    }
    made.way = Way::metric;
    made.is_staged = random.below(3) == 0;
    made.is_combined = random.below(4) == 0;
    made.text += std::string(made.is_staged ? ", staged" : "") + (made.is_combined ? ", combined" : "");
    if (random.below(8) > 0)  // lattices and octrees refuse nearly all metrics
        set_background(made, "particles");
}

}  // namespace storm
