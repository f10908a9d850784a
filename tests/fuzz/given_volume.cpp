// Volumes of a few voxels from bytes: grids that are plain, stretched, sheared, or any twelve numbers.
#include "fuzz/given_volume.hpp"

#include "storm/mesh_checker.hpp"

#include <cmath>

namespace fuzz
{

namespace
{

constexpr int most_voxels_a_side = 4;

size_t size_of(cleft_type type)
{
    constexpr size_t sizes[] = {8, 1, 2, 2, 4, 4, 4, 8};
    return sizes[static_cast<size_t>(type) % std::size(sizes)];
}

double near_one(Bytes& bytes) { return std::ldexp(bytes.between(0.5, 1), bytes.below(5) - 2); }

// Small values, so that a value comes back; any bits at times.
template <class T>
void make_tame(std::vector<unsigned char>& voxels)
{
    for (size_t at = 0; at + sizeof(T) <= voxels.size(); at += sizeof(T)) {
        const auto value = static_cast<T>(static_cast<T>(voxels[at]) / T{8} - T{4});
        std::memcpy(&voxels[at], &value, sizeof value);
    }
}

}  // namespace

Grid grid_of(Bytes& bytes)
{
    Grid grid;
    for (int64_t& n : grid.dims)
        n = 1 + bytes.below(most_voxels_a_side);
    if (bytes.one_in(64))
        grid.dims[0] = std::min<int64_t>(0, bytes.any<int64_t>());  // not more than there are voxels
    const int kind = bytes.below(4);
    for (size_t row = 0; row < 3; ++row)
        for (size_t column = 0; column < 4; ++column) {
            double& a = grid.affine[4 * row + column];
            if (kind == 0)
                a = row == column ? 1 : 0;
            else if (kind == 3)
                a = bytes.any<double>();
            else
                a = row == column ? near_one(bytes) : column == 3 ? bytes.between(-9, 9) : 0;
            if (kind == 2 && row != column && column < 3)
                a = bytes.between(-0.3, 0.3);
        }
    return grid;
}

Volume::Volume(const Context& context, const Options& options, const Grid& grid, Bytes& bytes)
{
    const bool made = context.succeeded(bytes.below(3) < 2 ? create_labels(context, options, grid, bytes)
                                                           : create_functions(context, grid, bytes));
    expect(made == (volume_ != nullptr), "there is a volume after a failure, or none after a success");
    if (made)
        judge_volume(context, volume_);
}

Volume::~Volume() { cleft_volume_destroy(volume_); }

cleft_status Volume::create_labels(const Context& context, const Options& options, const Grid& grid, Bytes& bytes)
{
    const cleft_type type = bytes.below(9);
    const bool few = !bytes.one_in(4);
    const size_t count = static_cast<size_t>(std::pow(most_voxels_a_side, 3));
    std::vector<unsigned char> voxels = bytes.repeated(count * size_of(type));
    for (size_t i = 0; few && i < voxels.size(); ++i)
        voxels[i] = i % size_of(type) == 0 ? voxels[i] / 64 : 0;
    return cleft_volume_create_labels(context, type, voxels.data(), grid.dims.data(), grid.affine.data(), options,
                                      &volume_);
}

cleft_status Volume::create_functions(const Context& context, const Grid& grid, Bytes& bytes)
{
    const cleft_type type = bytes.one_in(2) ? CLEFT_TYPE_FLOAT32 : CLEFT_TYPE_FLOAT64;
    const auto functions = static_cast<size_t>(1 + bytes.below(4));
    const bool tame = !bytes.one_in(4);
    const size_t size = static_cast<size_t>(std::pow(most_voxels_a_side, 3)) * size_of(type);
    std::vector<unsigned char> voxels = bytes.repeated(functions * size);
    if (tame && type == CLEFT_TYPE_FLOAT32)
        make_tame<float>(voxels);
    else if (tame)
        make_tame<double>(voxels);
    std::vector<const void*> fields;
    for (size_t f = 0; f < functions; ++f)
        fields.push_back(&voxels[f * size]);
    return cleft_volume_create_indicators(context, type, fields.data(), static_cast<int64_t>(functions),
                                          grid.dims.data(), grid.affine.data(), nullptr, &volume_);
}

void judge_mesh(const Context& context, const cleft_volume* volume, const cleft_mesh* mesh, bool fills_box)
{
    judge_arrays(context, mesh);
    Grid grid;
    expect(cleft_volume_dims(volume, grid.dims.data()) == CLEFT_OK &&
               cleft_volume_affine(volume, grid.affine.data()) == CLEFT_OK,
           "a volume has no dimensions or no affine");
    storm::Expectation expected;
    const int32_t* labels = cleft_volume_labels(volume);
    expected.labels.assign(labels, labels + cleft_volume_label_count(volume));
    std::sort(expected.labels.begin(), expected.labels.end());
    expected.fills_box = fills_box;
    for (size_t corner = 0; corner < 8; ++corner)
        for (size_t row = 0; row < 3; ++row) {
            double& x = expected.box[corner][row];
            x = grid.affine[4 * row + 3];
            for (size_t axis = 0; axis < 3; ++axis)
                x += grid.affine[4 * row + axis] *
                     ((corner >> axis & 1) ? static_cast<double>(grid.dims[axis]) - 0.5 : -0.5);
        }
    const std::string found = storm::fault_of(mesh, expected);
    if (!found.empty())
        fault(found);
    cleft_validation validation{};
    validation.struct_size = sizeof validation;
    expect(cleft_mesh_validate(context, mesh, fills_box, &validation) == CLEFT_OK, "a mesh cannot be validated");
    if (!validation.valid)
        fault(std::string("a mesh of the library is not valid: ") + cleft_context_last_error(context));
}

}  // namespace fuzz
