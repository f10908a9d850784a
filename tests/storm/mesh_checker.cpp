// Faults are looked for in the arrays that a user gets: numbers, orientation, faces, hull, volume, labels.
#include "storm/mesh_checker.hpp"

#include <algorithm>
#include <cfloat>
#include <cmath>

namespace storm
{

namespace
{

using Wide = __float128;  // 113 bits: differences of doubles of one mesh are exact, their products nearly so
using Point = std::array<double, 3>;
using WidePoint = std::array<Wide, 3>;

struct Face {
    std::array<int32_t, 3> key;  // corners, ascending
    bool even;                   // the corners of the tetrahedron's side are an even permutation of the key
    int32_t tet;
};

WidePoint minus(const Point& a, const Point& b)
{
    return {Wide(a[0]) - Wide(b[0]), Wide(a[1]) - Wide(b[1]), Wide(a[2]) - Wide(b[2])};
}

Wide determinant(const WidePoint& a, const WidePoint& b, const WidePoint& c)
{
    return a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0]) + a[2] * (b[0] * c[1] - b[1] * c[0]);
}

class Checker
{
public:
    Checker(const cleft_mesh* mesh, const Expectation& expected)
        : points_(cleft_mesh_points(mesh)),
          tets_(cleft_mesh_tets(mesh)),
          labels_(cleft_mesh_tet_labels(mesh)),
          point_count_(cleft_mesh_point_count(mesh)),
          tet_count_(cleft_mesh_tet_count(mesh)),
          expected_(expected)
    {
    }

    std::string fault() const
    {
        if (tet_count_ < 1)
            return "there are no tetrahedra";
        for (const auto check : {&Checker::fault_of_points, &Checker::fault_of_tets, &Checker::fault_of_faces,
                                 &Checker::fault_of_volume, &Checker::fault_of_labels}) {
            const std::string fault = (this->*check)();
            if (!fault.empty())
                return fault;
        }
        return "";
    }

private:
    Point point(int32_t p) const { return {points_[3 * p], points_[3 * p + 1], points_[3 * p + 2]}; }

    Wide six_volumes(int64_t t) const
    {
        const int32_t* c = tets_ + 4 * t;
        const Point a = point(c[0]);
        return determinant(minus(point(c[1]), a), minus(point(c[2]), a), minus(point(c[3]), a));
    }

    std::string fault_of_points() const
    {
        std::vector<Point> all;
        for (int64_t p = 0; p < point_count_; ++p) {
            all.push_back(point(static_cast<int32_t>(p)));
            for (const double x : all.back())
                if (!std::isfinite(x))
                    return "point " + std::to_string(p) + " is not finite";
        }
        std::sort(all.begin(), all.end());
        if (std::adjacent_find(all.begin(), all.end()) != all.end())
            return "two points are at one place";
        return "";
    }

    std::string fault_of_tets() const
    {
        std::vector<bool> used(static_cast<size_t>(point_count_));
        for (int64_t i = 0; i < 4 * tet_count_; ++i) {
            if (tets_[i] < 0 || tets_[i] >= point_count_)
                return "tetrahedron " + std::to_string(i / 4) + " names a point that there is not";
            used[static_cast<size_t>(tets_[i])] = true;
        }
        if (std::find(used.begin(), used.end(), false) != used.end())
            return "a point belongs to no tetrahedron";
        for (int64_t t = 0; t < tet_count_; ++t)
            if (!(six_volumes(t) > 0))
                return "tetrahedron " + std::to_string(t) + " is flat or inverted";
        return "";
    }

    std::vector<Face> sorted_faces() const
    {
        constexpr int sides[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
        std::vector<Face> faces;
        for (int64_t t = 0; t < tet_count_; ++t)
            for (const auto& side : sides) {
                std::array<int32_t, 3> c{};
                for (size_t i = 0; i < 3; ++i)
                    c[i] = tets_[4 * t + side[i]];
                const int swaps = (c[0] > c[1]) + (c[0] > c[2]) + (c[1] > c[2]);
                std::sort(c.begin(), c.end());
                faces.push_back({c, swaps % 2 == 0, static_cast<int32_t>(t)});
            }
        std::sort(faces.begin(), faces.end(), [](const Face& a, const Face& b) { return a.key < b.key; });
        return faces;
    }

    // Two positively oriented tetrahedra on the two sides of a face see it wound in opposite ways.
    std::string fault_of_faces() const
    {
        const std::vector<Face> faces = sorted_faces();
        for (size_t f = 0; f < faces.size();) {
            size_t end = f + 1;
            while (end < faces.size() && faces[end].key == faces[f].key)
                ++end;
            if (end - f > 2)
                return "a face has " + std::to_string(end - f) + " tetrahedra";
            if (end - f == 2 && faces[f].even == faces[f + 1].even)
                return "tetrahedra " + std::to_string(faces[f].tet) + " and " + std::to_string(faces[f + 1].tet) +
                       " lie on one side of their face";
            if (end - f == 1 && expected_.fills_box && !lies_in_a_side(faces[f].key))
                return "a face of tetrahedron " + std::to_string(faces[f].tet) +
                       " has nothing behind it and lies in no side of the box";
            f = end;
        }
        return "";
    }

    // Of the coordinates, over the least side of the box.
    double rounding() const
    {
        double greatest = 0, least = DBL_MAX;
        for (const Point& corner : expected_.box)
            for (const double x : corner)
                greatest = std::max(greatest, std::abs(x));
        for (size_t axis = 0; axis < 3; ++axis) {
            const WidePoint side = minus(expected_.box[size_t{1} << axis], expected_.box[0]);
            least = std::min(least,
                             std::sqrt(static_cast<double>(side[0] * side[0] + side[1] * side[1] + side[2] * side[2])));
        }
        return 0x1p-53 * greatest / least;
    }

    bool lies_in_a_side(const std::array<int32_t, 3>& face) const
    {
        constexpr double tolerance = 1e-9;  // of the height of the box, beside the rounding of far coordinates
        double greatest = 0;
        for (const Point& corner : expected_.box)
            for (const double x : corner)
                greatest = std::max(greatest, std::abs(x));
        for (size_t axis = 0; axis < 3; ++axis)
            for (size_t far = 0; far < 2; ++far) {
                const size_t first = far << axis;
                const Point& a = expected_.box[first];
                const WidePoint u = minus(expected_.box[first ^ (1u << (axis + 1) % 3)], a);
                const WidePoint v = minus(expected_.box[first ^ (1u << (axis + 2) % 3)], a);
                const WidePoint w = minus(expected_.box[first ^ (1u << axis)], a);
                const double height = static_cast<double>(determinant(u, v, w));
                const double length = std::sqrt(static_cast<double>(w[0] * w[0] + w[1] * w[1] + w[2] * w[2]));
                const double allowed = tolerance + 16 * 0x1p-53 * greatest / length;
                if (std::all_of(face.begin(), face.end(), [&](int32_t p) {
                        const double share = static_cast<double>(determinant(u, v, minus(point(p), a))) / height;
                        return std::abs(share) <= allowed;
                    }))
                    return true;
            }
        return false;
    }

    std::string fault_of_volume() const
    {
        if (!expected_.fills_box)
            return "";
        Wide sum = 0;
        for (int64_t t = 0; t < tet_count_; ++t)
            sum += six_volumes(t) / 6;
        const Point& a = expected_.box[0];
        Wide box = determinant(minus(expected_.box[1], a), minus(expected_.box[2], a), minus(expected_.box[4], a));
        const double off = std::abs(static_cast<double>(sum / (box < 0 ? -box : box)) - 1);
        return off > 1e-6 + 100 * rounding()
                   ? "the volumes add up to " + std::to_string(off) + " more or less than the box"
                   : "";
    }

    std::string fault_of_labels() const
    {
        for (int64_t t = 0; t < tet_count_; ++t)
            if (!std::binary_search(expected_.labels.begin(), expected_.labels.end(), labels_[t]))
                return "tetrahedron " + std::to_string(t) + " has label " + std::to_string(labels_[t]) +
                       ", which the volume does not have";
        return "";
    }

    const double* points_;
    const int32_t* tets_;
    const int32_t* labels_;
    int64_t point_count_, tet_count_;
    const Expectation& expected_;
};

}  // namespace

std::string fault_of(const cleft_mesh* mesh, const Expectation& expected) { return Checker(mesh, expected).fault(); }

}  // namespace storm
