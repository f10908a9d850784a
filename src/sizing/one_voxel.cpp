// Finds the parts of a material that no block of 2 x 2 x 2 voxels reaches, and without which it would be connected
// differently.
#include "sizing/one_voxel.hpp"

#include "base/stage.hpp"

#include <algorithm>

namespace cleft
{

namespace
{

// Bit (dx + 1) + 3 (dy + 1) + 9 (dz + 1): the voxel so many steps away is of the same material.
using Neighbourhood = uint32_t;

constexpr Neighbourhood block(int x, int y, int z)
{
    Neighbourhood bits = 0;
    for (int corner = 0; corner < 8; ++corner)
        bits |= 1u << ((x + (corner & 1)) + 3 * (y + (corner >> 1 & 1)) + 9 * (z + (corner >> 2)));
    return bits;
}

constexpr Neighbourhood kBlocks[8] = {block(0, 0, 0), block(1, 0, 0), block(0, 1, 0), block(1, 1, 0),
                                      block(0, 0, 1), block(1, 0, 1), block(0, 1, 1), block(1, 1, 1)};

constexpr Neighbourhood kAll = (1u << 27) - 1, kCentre = 1u << 13;

// Places that share a face with a place, or, with `corners`, a face, an edge or a corner.
constexpr Neighbourhood neighbours(int place, bool corners)
{
    Neighbourhood bits = 0;
    for (int other = 0; other < 27; ++other) {
        const int x = other % 3 - place % 3, y = other / 3 % 3 - place / 3 % 3, z = other / 9 - place / 9;
        const int steps = x * x + y * y + z * z;  // of at most 2 along each axis
        const bool is_near = x * x < 4 && y * y < 4 && z * z < 4;
        if (steps == 1 || (corners && steps > 0 && is_near))
            bits |= 1u << other;
    }
    return bits;
}

struct Adjacency {
    FixedArray<Neighbourhood, 27> of_place{};
    explicit constexpr Adjacency(bool corners)
    {
        for (int place = 0; place < 27; ++place)
            of_place[place] = neighbours(place, corners);
    }
};
constexpr Adjacency kByFaces(false), kByCorners(true);

// In how many parts the places are, joined as said; parts that do not reach `touched` do not count.
// A material is connected over faces, as the pieces of the report are. What surrounds it is then connected over corners
// too: otherwise a closed surface would not separate.
int count_parts(Neighbourhood places, const Adjacency& joined, Neighbourhood touched)
{
    int parts = 0;
    while (places != 0) {
        Neighbourhood part = places & (~places + 1), grown = part;
        do {
            part = grown;
            for (size_t place = 0; place < 27; ++place)
                if (part >> place & 1u)
                    grown |= joined.of_place[place] & places;
        } while (grown != part);
        parts += (part & touched) != 0;
        places &= ~part;
    }
    return parts;
}

Neighbourhood alike(RowWindow& window, int32_t i, int32_t j, int32_t k)
{
    const Material own = window.row(j, k)[i];
    Neighbourhood bits = 0;
    // Downwards, since each bit is pushed in from below: the first ends as the highest.
    for (int32_t z = 1; z >= -1; --z)
        for (int32_t y = 1; y >= -1; --y) {
            const Material* row = window.row(j + y, k + z) + i;
            for (int32_t x = 1; x >= -1; --x)
                bits = bits << 1 | (row[x] == own);
        }
    return bits;
}

bool is_one_voxel_thick(Neighbourhood own)
{
    return std::none_of(std::begin(kBlocks), std::end(kBlocks),
                        [&](Neighbourhood block) { return (own & block) == block; });
}

// Without the voxel its material would hang together in another way near by (it is no simple point of digital
// topology), or the voxel is the end of a rod.
bool matters(Neighbourhood own)
{
    const Neighbourhood others = own & ~kCentre;
    // At most one neighbour: removing the end of a rod changes no topology, and would shorten the rod bit by bit.
    if ((others & (others - 1)) == 0)
        return true;
    // For connection over faces, digital topology looks at the faces and edges of the neighbourhood only. A way through
    // a corner is too long to count as near.
    constexpr Neighbourhood kCorners = 1u | 1u << 2 | 1u << 6 | 1u << 8 | 1u << 18 | 1u << 20 | 1u << 24 | 1u << 26;
    const Neighbourhood faces = kByFaces.of_place[13];
    return count_parts(others & ~kCorners, kByFaces, faces) != 1 || count_parts(kAll & ~own, kByCorners, kAll) != 1;
}

// visit(i, j, k, voxel) for all voxels, row by row.
template <class Visit>
void for_each_voxel(const Labelling& labelling, const Run& run, const Visit& visit)
{
    const Grid& grid = labelling.grid;
    parallel_with_progress(run, row_count(grid), rows_per_chunk(grid), [&](int64_t, int64_t begin, int64_t end) {
        RowWindow window(labelling);
        for (int64_t row = begin; row < end; ++row)
            for (int32_t i = 0; i < grid.dims[0]; ++i)
                visit(window, i, static_cast<int32_t>(row % grid.dims[1]), static_cast<int32_t>(row / grid.dims[1]),
                      row * grid.dims[0] + i);
    });
}

}  // namespace

Array<uint8_t> near_one_voxel_parts(const Labelling& labelling, const Run& run)
{
    const Grid& grid = labelling.grid;
    Array<uint8_t> thin(grid.size()), near(thin.size());
    Steps steps(run, {{nullptr, 4}, {nullptr, 1}});
    for_each_voxel(labelling, steps.next(), [&](RowWindow& window, int32_t i, int32_t j, int32_t k, int64_t voxel) {
        const Neighbourhood own = alike(window, i, j, k);
        thin[voxel] = is_one_voxel_thick(own) && matters(own);
    });
    // A second pass, so that no thread reads what another one writes.
    const int64_t y = grid.strides()[1], z = grid.strides()[2];
    for_each_voxel(labelling, steps.next(), [&](RowWindow&, int32_t i, int32_t j, int32_t k, int64_t voxel) {
        near[voxel] = thin[voxel] || (i > 0 && thin[voxel - 1]) || (i + 1 < grid.dims[0] && thin[voxel + 1]) ||
                      (j > 0 && thin[voxel - y]) || (j + 1 < grid.dims[1] && thin[voxel + y]) ||
                      (k > 0 && thin[voxel - z]) || (k + 1 < grid.dims[2] && thin[voxel + z]);
    });
    return near;
}

}  // namespace cleft
