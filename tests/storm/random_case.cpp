// Grids (thin, stretched, sheared, mirrored, far away, tiny, huge), contents (noise, checkers, sheets, rods, grains,
// balls, ties, plateaus, sentinels, what is not finite) and options, each chosen at random.
#include "storm/random_case.hpp"

#include "storm/random_metric.hpp"
#include "support/random.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>
#include <iterator>
#include <limits>
#include <sstream>

namespace storm
{

namespace
{

using cleft_test::Random;
using Voxel = std::array<int64_t, 3>;

std::string number(double value)
{
    std::ostringstream text;
    text.precision(17);
    text << value;
    return text.str();
}

double distance_to(const std::array<double, 3>& place, const Voxel& v)
{
    return std::hypot(static_cast<double>(v[0]) - place[0], static_cast<double>(v[1]) - place[1],
                      static_cast<double>(v[2]) - place[2]);
}

class Maker
{
public:
    explicit Maker(uint64_t seed) : seed_(seed), random_(seed * 0x9e3779b97f4a7c15u + 1) {}

    Case make()
    {
        set_dims();
        set_affine();
        if (random_.below(3) > 0)
            set_labels();
        else
            set_functions();
        set_options();
        set_way();
        if (has_metric(seed_))
            set_metric(made_, seed_, least_spacing_);
        return std::move(made_);
    }

    Case make_for_parts()
    {
        set_dims();
        make_long();
        set_affine();
        set_labels();
        set_options();
        set_block_options();
        set_ranks();
        return std::move(made_);
    }

private:
    bool one_in(uint64_t n) { return random_.below(n) == 0; }
    int64_t pick(int64_t least, int64_t greatest)
    {
        return least + static_cast<int64_t>(random_.below(static_cast<uint64_t>(greatest - least + 1)));
    }
    void describe(const std::string& words) { made_.text += (made_.text.empty() ? "" : ", ") + words; }

    void set_dims()
    {
        for (int64_t& n : made_.dims)
            n = one_in(4) ? pick(1, 3) : one_in(4) ? pick(1, 20) : pick(1, 9);  // small ones, for the storm to be long
        describe(std::to_string(made_.dims[0]) + " x " + std::to_string(made_.dims[1]) + " x " +
                 std::to_string(made_.dims[2]));
    }

    // So long that there are several blocks, and at times so long that no rank needs all planes.
    void make_long()
    {
        auto& [x, y, z] = made_.dims;
        z = one_in(2) ? pick(12, 60) : one_in(2) ? pick(100, 250) : pick(1, 20);
        if (z >= 100) {
            x = std::min<int64_t>(x, 4);
            y = std::min<int64_t>(y, 4);
        }
        describe("or rather " + std::to_string(x) + " x " + std::to_string(y) + " x " + std::to_string(z));
    }

    void set_affine()
    {
        const double scale = one_in(4) ? std::pow(10, random_.between(-16, 16)) : 1;
        const double stretch = one_in(40) ? 2000 : one_in(3) ? 50 : one_in(2) ? 6 : 1;
        std::array<double, 3> spacing{};
        for (double& h : spacing)
            h = scale * std::pow(stretch, random_.unit());
        least_spacing_ = *std::min_element(spacing.begin(), spacing.end());
        const bool sheared = one_in(5), far = one_in(5);
        const double distance = least_spacing_ * std::pow(10, random_.between(2, 15));
        for (size_t axis = 0; axis < 3; ++axis) {
            const double sign = one_in(4) ? -1 : 1;
            for (size_t row = 0; row < 3; ++row) {
                const double turned = row == axis ? 1 : sheared ? random_.between(-0.3, 0.3) : 0;
                made_.affine[4 * row + axis] = sign * spacing[axis] * turned;
            }
            made_.affine[4 * axis + 3] = far ? distance * random_.between(-1, 1) : 0;
        }
        if (one_in(6))  // axes of the voxels in another order than the world's
            for (size_t axis = 0; axis < 3; ++axis)
                std::swap(made_.affine[axis], made_.affine[4 + axis]);
        describe("spacing " + number(spacing[0]) + " " + number(spacing[1]) + " " + number(spacing[2]) +
                 (sheared ? ", sheared" : "") + (far ? ", as far as " + number(distance) : ""));
    }

    int32_t any_label()
    {
        switch (random_.below(8)) {
            case 0:
                return std::numeric_limits<int32_t>::min();
            case 1:
                return std::numeric_limits<int32_t>::max();
            case 2:
                return -1;
            case 3:
                return static_cast<int32_t>(random_.bits());
            default:
                return static_cast<int32_t>(pick(-3, 40));
        }
    }

    // The number of a material at a voxel, for a pattern.
    size_t pattern_at(uint64_t pattern, size_t materials, const Voxel& v)
    {
        const auto n = static_cast<int64_t>(materials);
        switch (pattern) {
            case 0:  // noise
                return random_.below(materials);
            case 1:  // a checkerboard
                return static_cast<size_t>((v[0] + v[1] + v[2]) % n);
            case 2:  // sheets
                return static_cast<size_t>(v[sheet_axis_] / thickness_ % n);
            case 3:  // rods
                return v[0] % 4 == 2 && v[1] % 4 == 2 ? 1 + static_cast<size_t>(v[2] % (n - 1 > 0 ? n - 1 : 1)) : 0;
            case 4: {  // sparse noise: voxels of their own
                return one_in(9) ? random_.below(materials) : 0;
            }
            default: {  // grains
                size_t nearest = 0;
                double least = DBL_MAX;
                for (size_t m = 0; m < materials; ++m) {
                    const auto& s = seeds_[m];
                    const double d = distance_to(s, v);
                    if (d < least) {
                        least = d;
                        nearest = m;
                    }
                }
                return nearest;
            }
        }
    }

    void prepare_pattern(size_t materials)
    {
        sheet_axis_ = random_.below(3);
        thickness_ = pick(1, 3);
        seeds_.resize(materials);
        for (auto& s : seeds_)
            for (size_t axis = 0; axis < 3; ++axis)
                s[axis] = random_.between(-1, static_cast<double>(made_.dims[axis]));
    }

    template <class Value>
    void for_each_voxel(const Value& value)
    {
        for (int64_t k = 0; k < made_.dims[2]; ++k)
            for (int64_t j = 0; j < made_.dims[1]; ++j)
                for (int64_t i = 0; i < made_.dims[0]; ++i)
                    value(Voxel{i, j, k});
    }

    void set_labels()
    {
        const auto materials = static_cast<size_t>(one_in(3) ? pick(1, 40) : pick(1, 6));
        const uint64_t pattern = random_.below(6);
        prepare_pattern(materials);
        std::vector<int32_t> names;
        for (size_t m = 0; m < materials; ++m)
            names.push_back(any_label());
        for_each_voxel([&](const Voxel& v) {
            made_.labels.push_back(names[std::min(pattern_at(pattern, materials, v), materials - 1)]);
        });
        static const char* const kNames[] = {"noise", "checkers", "sheets", "rods", "sparse noise", "grains"};
        describe(std::string(kNames[pattern]) + " of " + std::to_string(materials) + " labels");
    }

    void set_functions()
    {
        const auto count = static_cast<size_t>(one_in(3) ? 1 : pick(2, 6));
        const uint64_t kind = random_.below(7);
        static const char* const kNames[] = {"distances", "noise",      "ties",      "plateaus",
                                             "sentinels", "not finite", "huge noise"};
        sentinel_ = one_in(2) ? double{FLT_MAX} : std::pow(10, random_.between(0, 38));
        scale_ = one_in(3) ? std::pow(10, random_.between(-44, 37)) : 1;
        prepare_pattern(count + 1);
        made_.functions.resize(count);
        for_each_voxel([&](const Voxel& v) {
            for (size_t f = 0; f < count; ++f)
                made_.functions[f].push_back(static_cast<float>(std::clamp(
                    scale_ * static_cast<double>(function_at(kind, f, v)), -double{FLT_MAX}, double{FLT_MAX})));
        });
        if (kind == 5)
            made_.functions[random_.below(count)][random_.below(static_cast<uint64_t>(made_.voxel_count()))] =
                one_in(2) ? std::numeric_limits<float>::infinity() : std::numeric_limits<float>::quiet_NaN();
        describe(std::to_string(count) + " functions: " + kNames[kind]);
    }

    float function_at(uint64_t kind, size_t f, const Voxel& v)
    {
        const auto& s = seeds_[f];
        const double distance = 4 - distance_to(s, v);
        switch (kind) {
            case 1:
                return static_cast<float>(random_.between(-1, 1));
            case 2:  // all equal in half of the volume
                return v[0] % 2 == 0 ? 0.5f : static_cast<float>(distance);
            case 3:  // few values
                return static_cast<float>(std::clamp(std::floor(distance), -1.0, 1.0));
            case 4:
                return static_cast<float>(std::abs(distance) < 2 ? distance : std::copysign(sentinel_, distance));
            case 6:
                return static_cast<float>(sentinel_ * random_.between(-1, 1));
            default:
                return static_cast<float>(distance);
        }
    }

    void set_options()
    {
        static const char* const kBackgrounds[] = {"particles", "lattice", "octree"};
        option("background", kBackgrounds[random_.below(std::size(kBackgrounds))]);
        if (one_in(4))
            option("size", number(least_spacing_ * random_.between(0.7, 6)));
        if (one_in(5))
            option("gradation", number(random_.between(0.05, 1)));
        if (one_in(6))
            option("feature_scale", number(random_.between(0.5, 3)));
        if (one_in(6))
            option("size_min", number(least_spacing_ * random_.between(0.5, 3)));
        if (one_in(6))
            option("interface_size", number(least_spacing_ * random_.between(0.7, 4)));
        if (one_in(6))
            option("keep_thin", "1");
        if (one_in(4))
            option("smooth", std::to_string(pick(2, 6)));
        if (one_in(4))
            option("snap", one_in(2) ? "safe" : "none");
        if (one_in(3))
            option("improve", one_in(2) ? "off" : "best");
        if (one_in(6))
            option("steps", std::to_string(pick(0, 12)));
        if (one_in(6))
            option("seed", std::to_string(pick(0, 1000)));
        if (one_in(8))
            option("strict", "1");
        // Improving what was not snapped takes a hundred times as long; a number is met in several meshes.
        const bool snaps = made_.text.find("snap") == std::string::npos;
        if (snaps && one_in(4))
            option("tets", std::to_string(pick(1, 6000)));
        option("max_tets", std::to_string(pick(100, snaps ? 40000 : 4000)));
        if (!made_.labels.empty() && one_in(5))
            made_.label_sizes.emplace_back(made_.labels[0], least_spacing_ * random_.between(0.7, 4));
        if (!made_.labels.empty() && one_in(5))
            made_.strip.push_back(made_.labels[random_.below(made_.labels.size())]);
    }

    void set_way()
    {
        switch (random_.below(8)) {
            case 0:
                made_.way = Way::sizing;
                for (int64_t v = 0; v < made_.voxel_count(); ++v)
                    made_.sizes.push_back(least_spacing_ * random_.between(0.7, 4));
                if (one_in(3))
                    made_.sizes[random_.below(made_.sizes.size())] *= std::pow(10, random_.between(-9, 9));
                describe("own sizes");
                break;
            case 1:
                made_.way = Way::background;
                describe("own background");
                break;
            case 2:
                made_.way = Way::stages;
                describe("stages");
                break;
            default:
                break;
        }
        made_.constant_size = least_spacing_ * random_.between(0.8, 5);
        made_.threads = one_in(4) ? 3 : 1;
        if (one_in(10)) {
            made_.cancel_at = pick(1, 60);
            describe("cancel at " + std::to_string(made_.cancel_at));
        }
    }

    // After the others, of which it takes back those that blocks are not shared with.
    void set_block_options()
    {
        option("block", std::to_string(made_.dims[2] >= 100 && one_in(2) ? pick(20, 60) : pick(1, 20)));
        if (!one_in(30)) {
            static const char* const kShared[] = {"particles", "lattice", "octree", "octree"};
            option("background", kShared[random_.below(std::size(kShared))]);
            option("tets", "0");
            option("strict", "0");
        }
        // Improving takes by far the most time.
        if (one_in(2) || made_.text.find("snap none") != std::string::npos)
            option("improve", "off");
        if (one_in(6))
            option("size_max", number(least_spacing_ * random_.between(3, 20)));
        if (one_in(6))
            option("surface_error", number(one_in(3) ? 0 : least_spacing_ * random_.between(0.1, 1)));
        if (one_in(6))
            option("min_angle", number(random_.between(5, 30)));
        if (made_.strip.empty() && one_in(8))
            made_.only.push_back(made_.labels[random_.below(made_.labels.size())]);
    }

    void set_ranks()
    {
        made_.way = Way::parts;
        made_.threads = static_cast<int32_t>(pick(1, 2));
        made_.ranks = static_cast<int32_t>(pick(1, 8));
        made_.has_ghosts = one_in(2);
        made_.has_scratch = one_in(3);
        made_.upset_rank = static_cast<int32_t>(pick(0, made_.ranks - 1));
        describe(std::to_string(made_.ranks) + " ranks");
        if (one_in(20)) {
            made_.cancel_at = pick(1, 60);
            describe("cancel at " + std::to_string(made_.cancel_at));
        } else if (one_in(20)) {
            made_.fail_at = pick(1, 12);
            describe("fail at " + std::to_string(made_.fail_at));
        }
    }

    void option(const std::string& name, const std::string& value)
    {
        made_.options.emplace_back(name, value);
        describe(name + " " + value);
    }

    uint64_t seed_;
    Random random_;
    Case made_;
    double least_spacing_ = 1;
    double sentinel_ = 1, scale_ = 1;
    size_t sheet_axis_ = 0;
    int64_t thickness_ = 1;
    std::vector<std::array<double, 3>> seeds_;
};

}  // namespace

Case random_case(uint64_t seed) { return Maker(seed).make(); }

// The seed is mixed, since the numbers of neighbouring seeds are the same ones but for the first.
Case random_parts_case(uint64_t seed) { return Maker(Random(seed).bits()).make_for_parts(); }

}  // namespace storm
