// A small volume cleaved on a user-supplied background: blocks of six tetrahedra with moved points, and what is
// broken in it. A sound one gives a sound mesh; of a broken one, no mesh that is not sound comes back.
#include "fuzz/bytes.hpp"
#include "fuzz/given_volume.hpp"
#include "fuzz/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

using fuzz::Bytes;

struct Arrays {
    std::vector<double> points;
    std::vector<int32_t> tets;
};

// Each cell of a lattice of n[0] x n[1] x n[2] is six tetrahedra about one diagonal. Places in [0, 1].
Arrays blocks_of(const std::array<int, 3>& n, double moved, Bytes& bytes)
{
    Arrays made;
    const int steps[3] = {1, n[0] + 1, (n[0] + 1) * (n[1] + 1)};
    for (int k = 0; k <= n[2]; ++k)
        for (int j = 0; j <= n[1]; ++j)
            for (int i = 0; i <= n[0]; ++i) {
                const int at[3] = {i, j, k};
                for (size_t axis = 0; axis < 3; ++axis) {
                    const bool inside = at[axis] > 0 && at[axis] < n[axis];
                    const double move = inside && moved > 0 ? bytes.between(-moved, moved) : 0;
                    made.points.push_back((at[axis] + move) / n[axis]);
                }
            }
    constexpr int ways[6][3] = {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}};
    for (int k = 0; k < n[2]; ++k)
        for (int j = 0; j < n[1]; ++j)
            for (int i = 0; i < n[0]; ++i)
                for (size_t way = 0; way < 6; ++way) {
                    const int a = i * steps[0] + j * steps[1] + k * steps[2];
                    const int b = a + steps[ways[way][0]];
                    const int c = b + steps[ways[way][1]];
                    const int d = c + steps[ways[way][2]];
                    const bool turned = way >= 3;
                    made.tets.insert(made.tets.end(), {a, turned ? c : b, turned ? b : c, d});
                }
    return made;
}

// Into the world of the volume's box, and wound as the world has it.
void place(const fuzz::Grid& grid, Arrays& arrays)
{
    const auto& a = grid.affine;
    for (size_t p = 0; p < arrays.points.size(); p += 3) {
        double index[3];
        for (size_t axis = 0; axis < 3; ++axis)
            index[axis] = arrays.points[p + axis] * static_cast<double>(grid.dims[axis]) - 0.5;
        for (size_t row = 0; row < 3; ++row)
            arrays.points[p + row] =
                a[4 * row] * index[0] + a[4 * row + 1] * index[1] + a[4 * row + 2] * index[2] + a[4 * row + 3];
    }
    const double determinant =
        a[0] * (a[5] * a[10] - a[6] * a[9]) - a[1] * (a[4] * a[10] - a[6] * a[8]) + a[2] * (a[4] * a[9] - a[5] * a[8]);
    for (size_t t = 0; determinant < 0 && t < arrays.tets.size(); t += 4)
        std::swap(arrays.tets[t], arrays.tets[t + 1]);
}

void break_one_thing(Bytes& bytes, Arrays& arrays)
{
    auto& tets = arrays.tets;
    if (tets.empty())
        return;
    const size_t tet = bytes.any<uint16_t>() % (tets.size() / 4) * 4;
    const size_t other = bytes.any<uint16_t>() % (tets.size() / 4) * 4;
    const auto first = tets.begin() + static_cast<std::ptrdiff_t>(tet);
    double& coordinate = arrays.points[bytes.any<uint16_t>() % arrays.points.size()];
    switch (bytes.below(8)) {
        case 0:
            std::swap(tets[tet], tets[tet + 1]);
            break;
        case 1: {
            const std::vector<int32_t> again(first, first + 4);
            tets.insert(tets.end(), again.begin(), again.end());
            break;
        }
        case 2:
            tets.erase(first, first + 4);
            break;
        case 3:
            tets[tet + static_cast<size_t>(bytes.below(4))] = tets[other];
            break;
        case 4:
            tets[tet] = bytes.any<int32_t>();
            break;
        case 5:
            coordinate = bytes.any<double>();
            break;
        case 6:
            coordinate += bytes.between(-2, 2);
            break;
        default:
            arrays.points.insert(arrays.points.end(), 3, coordinate);
    }
}

cleft_mesh* mesh_of(const fuzz::Context& context, const Arrays& arrays)
{
    cleft_mesh* mesh = nullptr;
    const bool made = context.succeeded(
        cleft_mesh_create(context, static_cast<int64_t>(arrays.points.size() / 3), arrays.points.data(),
                          static_cast<int64_t>(arrays.tets.size() / 4), arrays.tets.data(), nullptr, 0, &mesh));
    fuzz::expect(made == (mesh != nullptr), "there is a mesh after a failure, or none after a success");
    return mesh;
}

void set_options(const fuzz::Options& options, Bytes& bytes)
{
    const int64_t improve = bytes.one_in(4) ? bytes.below(3) : CLEFT_IMPROVE_OFF;  // which takes longer than the rest
    fuzz::expect(cleft_options_set_integer(options, CLEFT_OPTION_SNAP, bytes.below(3)) == CLEFT_OK &&
                     cleft_options_set_integer(options, CLEFT_OPTION_IMPROVE, improve) == CLEFT_OK &&
                     cleft_options_set_real(options, CLEFT_OPTION_REPAIR, bytes.one_in(2) ? 30 : 0) == CLEFT_OK,
                 "an option is refused in its range");
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const fuzz::Context context;
    const fuzz::Options options;
    set_options(options, bytes);
    const fuzz::Grid grid = fuzz::grid_of(bytes);
    const std::array<int, 3> cells = {1 + bytes.below(2), 1 + bytes.below(2), 1 + bytes.below(3)};
    Arrays arrays = blocks_of(cells, bytes.one_in(2) ? 0.2 : 0, bytes);
    place(grid, arrays);
    const int broken = bytes.below(4);
    for (int i = 0; i < broken; ++i)
        break_one_thing(bytes, arrays);
    const bool in_one_call = bytes.one_in(2);
    const fuzz::Volume volume(context, options, grid, bytes);
    cleft_mesh* const background = volume ? mesh_of(context, arrays) : nullptr;
    cleft_mesh* mesh = nullptr;
    if (background) {
        fuzz::judge_arrays(context, background);
        const bool meshed =
            context.succeeded(in_one_call ? cleft_mesh_volume(context, volume, nullptr, background, options, &mesh)
                                          : cleft_mesh_cleave(context, volume, background, options, &mesh));
        if (meshed)
            fuzz::judge_mesh(context, volume, mesh, broken == 0);
        else
            fuzz::expect(mesh == nullptr && broken > 0, "a sound background is refused");
    }
    cleft_mesh_destroy(mesh);
    cleft_mesh_destroy(background);
    return 0;
}
