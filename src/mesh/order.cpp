// Numbering along a Hilbert curve.
#include "base/large_pages.hpp"
#include "base/parallel.hpp"
#include "mesh/bounding_box.hpp"
#include "mesh/finish.hpp"

#include <algorithm>
#include <numeric>

namespace cleft
{

namespace
{

constexpr int kBits = 21;  // a coordinate: three of them fit 64 bits
constexpr int64_t kItemsOrdered = 8192;

struct Key {
    uint64_t value;
    int32_t index;
};

// Place of a cell of the 2^21 cube along the curve, by Skilling's transform of the coordinates ("Programming the
// Hilbert curve", 2004) and then interleaving their bits.
uint64_t hilbert_index(std::array<uint32_t, 3> x)
{
    for (uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1) {
        const uint32_t lower = bit - 1;
        for (uint32_t& coordinate : x) {
            if (coordinate & bit) {
                x[0] ^= lower;
            } else {
                const uint32_t swapped = (x[0] ^ coordinate) & lower;
                x[0] ^= swapped;
                coordinate ^= swapped;
            }
        }
    }
    x[1] ^= x[0];
    x[2] ^= x[1];
    uint32_t flip = 0;
    for (uint32_t bit = 1u << (kBits - 1); bit > 1; bit >>= 1)
        if (x[2] & bit)
            flip ^= bit - 1;
    uint64_t index = 0;
    for (int bit = kBits - 1; bit >= 0; --bit)
        for (const uint32_t coordinate : x)
            index = index << 1 | (((coordinate ^ flip) >> bit) & 1u);
    return index;
}

uint64_t hilbert_index(const Vec3& x, const BoundingBox& box)
{
    const double cells = static_cast<double>((1u << kBits) - 1);
    const double longest = box.longest();
    std::array<uint32_t, 3> cell{};
    for (size_t axis = 0; axis < 3; ++axis) {
        const auto a = static_cast<Eigen::Index>(axis);
        cell[axis] = longest > 0 ? static_cast<uint32_t>((x[a] - box.lo[a]) / longest * cells) : 0;
    }
    return hilbert_index(cell);
}

// Stable, eleven bits a pass.
void radix_sort(std::vector<Key>& keys)
{
    constexpr int kDigit = 11;
    constexpr size_t kValues = size_t{1} << kDigit;
    std::vector<Key> sorted(keys.size());
    for (int shift = 0; shift < 3 * kBits; shift += kDigit) {
        std::array<size_t, kValues + 1> start{};
        const auto digit = [&](const Key& key) { return static_cast<size_t>(key.value >> shift) & (kValues - 1); };
        for (const Key& key : keys)
            ++start[digit(key) + 1];
        std::partial_sum(start.begin(), start.end(), start.begin());
        for (const Key& key : keys)
            sorted[start[digit(key)]++] = key;
        keys.swap(sorted);
    }
}

// Points of one cell of the curve: by their coordinates, so that the order is that of the places alone.
void sort_ties(const std::vector<Vec3>& points, std::vector<Key>& keys)
{
    const auto less = [&](const Key& a, const Key& b) {
        const Vec3& x = points[static_cast<size_t>(a.index)];
        const Vec3& y = points[static_cast<size_t>(b.index)];
        return std::lexicographical_compare(x.begin(), x.end(), y.begin(), y.end());
    };
    for (auto first = keys.begin(), last = first; first != keys.end(); first = last) {
        last = std::find_if(first, keys.end(), [&](const Key& key) { return key.value != first->value; });
        if (last - first > 1)
            std::stable_sort(first, last, less);
    }
}

// Used points in their new order.
std::vector<Key> order_points(const LabelledMesh& mesh, const Run& run)
{
    std::vector<char> used(mesh.points.size(), 0);
    for (const Tet& tet : mesh.tets)
        for (const int32_t p : tet)
            used[static_cast<size_t>(p)] = 1;
    BoundingBox box;
    std::vector<Key> keys;
    keys.reserve(mesh.points.size());
    for (size_t p = 0; p < mesh.points.size(); ++p)
        if (used[p]) {
            box.add(mesh.points[p]);
            keys.push_back({0, static_cast<int32_t>(p)});
        }
    parallel_for(run, static_cast<int64_t>(keys.size()), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (auto k = static_cast<size_t>(begin); k < static_cast<size_t>(end); ++k)
            keys[k].value = hilbert_index(mesh.points[static_cast<size_t>(keys[k].index)], box);
    });
    radix_sort(keys);
    sort_ties(mesh.points, keys);
    return keys;
}

// The even permutation that puts the least corner first and the next one second.
Tet least_corners_first(Tet t)
{
    const auto swap_two_pairs = [&](size_t a, size_t b, size_t c, size_t d) {
        std::swap(t[a], t[b]);
        std::swap(t[c], t[d]);
    };
    const auto least = static_cast<size_t>(std::min_element(t.begin(), t.end()) - t.begin());
    if (least > 0)
        swap_two_pairs(0, least, least == 1 ? 2 : 1, least == 3 ? 2 : 3);
    std::rotate(t.begin() + 1, std::min_element(t.begin() + 1, t.end()), t.end());
    return t;
}

// Points of a curve are near each other, so the order of the corners is a spatial order of tetrahedra too.
void order_tets(LabelledMesh& mesh, const Run& run)
{
    std::vector<uint32_t> start(mesh.points.size() + 1, 0);
    for (const Tet& tet : mesh.tets)
        ++start[static_cast<size_t>(tet[0]) + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<int32_t> order(mesh.tets.size());
    {
        std::vector<uint32_t> next(start.begin(), start.end() - 1);
        for (size_t t = 0; t < mesh.tets.size(); ++t)
            order[next[static_cast<size_t>(mesh.tets[t][0])]++] = static_cast<int32_t>(t);
    }
    const auto less = [&](int32_t a, int32_t b) {
        return mesh.tets[static_cast<size_t>(a)] < mesh.tets[static_cast<size_t>(b)];
    };
    parallel_for(run, static_cast<int64_t>(mesh.points.size()), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (auto p = static_cast<size_t>(begin); p < static_cast<size_t>(end); ++p)
            std::sort(order.begin() + start[p], order.begin() + start[p + 1], less);
    });

    std::vector<Tet> tets = large_vector<Tet>(mesh.tets.size());
    std::vector<Material> material = large_vector<Material>(mesh.material.size());
    for (size_t t = 0; t < order.size(); ++t) {
        tets[t] = mesh.tets[static_cast<size_t>(order[t])];
        material[t] = mesh.material[static_cast<size_t>(order[t])];
    }
    mesh.tets.swap(tets);
    mesh.material.swap(material);
}

}  // namespace

void order_spatially(LabelledMesh& mesh, const Run& run)
{
    run.report(0, "ordering");
    const std::vector<Key> keys = order_points(mesh, run);
    run.report(0.4, "ordering");
    std::vector<int32_t> new_number(mesh.points.size(), -1);
    std::vector<Vec3> points;
    reserve_large(points, keys.size());
    for (const Key& key : keys) {
        new_number[static_cast<size_t>(key.index)] = static_cast<int32_t>(points.size());
        points.push_back(mesh.points[static_cast<size_t>(key.index)]);
    }
    mesh.points.swap(points);
    parallel_for(run, static_cast<int64_t>(mesh.tets.size()), kItemsOrdered, [&](int64_t begin, int64_t end) {
        for (auto t = static_cast<size_t>(begin); t < static_cast<size_t>(end); ++t) {
            Tet& tet = mesh.tets[t];
            for (int32_t& p : tet)
                p = new_number[static_cast<size_t>(p)];
            tet = least_corners_first(tet);
        }
    });
    run.report(0.6, "ordering");
    order_tets(mesh, run);
}

}  // namespace cleft
