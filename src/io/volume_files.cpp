// Entries: volumes and fields in, sizing fields out.
#include "base/struct_size.hpp"
#include "cleft/cleft_io.h"
#include "io/create_volume.hpp"
#include "io/entry.hpp"
#include "io/image_series.hpp"
#include "io/raw_image.hpp"
#include "io/same_grid.hpp"
#include "io/tensor_image.hpp"
#include "io/text_scanner.hpp"
#include "io/voxels.hpp"
#include "io/write_image.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

// The size of the struct in version 0.1. Callers that were compiled with it stay valid when fields
// are added at the end.
template <>
inline constexpr size_t cleft::kFirstSize<cleft_io_reading> = CLEFT_END_OF(cleft_io_reading, spacing);

namespace cleft::io
{

namespace
{

using Affine = std::array<double, 12>;

cleft_io_reading reading_or_defaults(const cleft_io_reading* given)
{
    cleft_io_reading reading = given ? copy_in(*given, "cleft_io_reading") : cleft_io_reading{};
    if (reading.world != CLEFT_IO_WORLD_LPS && reading.world != CLEFT_IO_WORLD_RAS)
        throw Error(CLEFT_ERROR_ARGUMENT, "there is no world " + std::to_string(reading.world));
    check_kind(reading.kind);
    if (reading.reserved != 0)  // so that it can mean something later
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "reserved of the cleft_io_reading is " + std::to_string(reading.reserved) + "; it must be 0");
    // 0 is the value in a struct that the caller filled with zeros, and means 1.
    if (!std::isfinite(reading.scale) || reading.scale < 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "the scale of origin and spacing must be positive");
    if (reading.scale == 0)
        reading.scale = 1;
    return reading;
}

void tell_notes(cleft_context* context, const std::string& path, const Image& image, const cleft_io_reading& reading)
{
    // Notes of the reader first: they explain the geometry that the next ones speak of.
    for (const std::string& note : image.notes)
        report(context, "'" + path + "': " + note);
    for (const std::string& note : notes_on_spacing(image, reading))
        report(context, "'" + path + "': " + note);
}

Image read_and_tell(cleft_context* context, const std::string& path, const cleft_io_reading& reading)
{
    Image image = read_image_or_series(path);
    tell_notes(context, path, image, reading);
    return image;
}

void read_volume(cleft_context* context, const cleft_options* options, const char* const* paths, int64_t count,
                 const cleft_io_reading& reading, cleft_volume** out)
{
    std::vector<Source> sources;
    VoxelGrid first{};
    // One file is what it is. Of several, functions keep their voxels.
    const bool may_pack = count > 1 && reading.kind != CLEFT_IO_KIND_INDICATORS;
    for (int64_t i = 0; i < count; ++i) {
        const std::string path = required(paths[i], "a path");
        Image image = read_and_tell(context, path, reading);
        naming_file(path, [&] {
            // Each file is compared with the first, in the world and with the spacing that the
            // caller asked for.
            const VoxelGrid grid{image.dims, affine_of(image, reading)};
            if (i == 0)
                first = grid;
            check_same_grid(grid, first, "'" + std::string(paths[0]) + "'");
        });
        sources.push_back(source_of(path, std::move(image), may_pack));
    }
    create_volume(context, options, sources, first.affine, reading.kind, out);
}

Image read_field_image(cleft_context* context, const char* path, const cleft_io_reading& reading, Affine& affine)
{
    Image image = read_and_tell(context, path, reading);
    naming_file(path, [&] {
        // A sizing field has one length at each voxel.
        if (image.fields != 1)
            throw Error(CLEFT_ERROR_FORMAT, "it has four dimensions, but a field has three");
        affine = affine_of(image, reading);
        make_floating(image);
    });
    return image;
}

VoxelGrid grid_of(cleft_context* context, const cleft_volume* volume)
{
    VoxelGrid grid{};
    check(context, cleft_volume_dims(volume, grid.dims.data()), "volume: ");
    check(context, cleft_volume_affine(volume, grid.affine.data()), "volume: ");
    return grid;
}

// In LPS, the numbers of a voxel side by side.
void copy_metric(cleft_context* context, const cleft_sizing* sizing, cleft_io_world world, Image& image)
{
    auto* numbers = reinterpret_cast<float*>(image.voxels.get());
    const int64_t count = 6 * image.field_size();
    check(context, cleft_sizing_copy_metric(sizing, numbers, count), "sizing: ");
    if (world != CLEFT_IO_WORLD_RAS)
        return;
    // x and y change their signs, and so do their products with z.
    for (int64_t i = 0; i < count; i += 6)
        for (const int64_t product : {i + 2, i + 4})
            numbers[product] = 0 - numbers[product];
}

struct DestroyVolume {
    void operator()(cleft_volume* volume) const { cleft_volume_destroy(volume); }
};

// A volume of one label, for a field that has no other.
std::unique_ptr<cleft_volume, DestroyVolume> blank_volume(cleft_context* context, const VoxelGrid& grid)
{
    Image image;
    image.dims = grid.dims;
    const std::vector<uint8_t> labels(checked_bytes(image));
    cleft_volume* volume = nullptr;
    check(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, labels.data(), grid.dims.data(),
                                              grid.affine.data(), nullptr, &volume));
    return std::unique_ptr<cleft_volume, DestroyVolume>(volume);
}

void read_metric(cleft_context* context, const cleft_volume* volume, const std::string& path,
                 const cleft_io_reading& reading, cleft_io_tensor_order order, int32_t combine,
                 const cleft_options* options, cleft_sizing** out)
{
    naming_file(path, [&] {
        TensorImage tensors = read_tensor_image(path);
        tell_notes(context, path, tensors.image, reading);
        const VoxelGrid grid{tensors.image.dims, affine_of(tensors.image, reading)};
        if (volume)
            check_same_grid(grid, grid_of(context, volume), "the volume");
        const std::vector<double> metric = metric_of(std::move(tensors), order, reading);
        const auto blank = volume ? nullptr : blank_volume(context, grid);
        check(context, cleft_sizing_create_metric(context, volume ? volume : blank.get(), CLEFT_TYPE_FLOAT64,
                                                  metric.data(), combine, options, out));
    });
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

cleft_status cleft_io_read_volume(cleft_context* context, const cleft_options* options, const char* const* paths,
                                  int64_t count, const cleft_io_reading* reading, cleft_volume** out) noexcept
{
    return entry_making(context, out, {options}, [&] {
        required(paths, "paths");
        if (count < 1)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there must be at least one path");
        read_volume(context, options, paths, count, reading_or_defaults(reading), out);
    });
}

cleft_status cleft_io_read_raw(cleft_context* context, const cleft_options* options, const char* const* paths,
                               int64_t count, const cleft_io_raw* raw, cleft_volume** out) noexcept
{
    return entry_making(context, out, {options}, [&] {
        required(paths, "paths");
        if (count < 1)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there must be at least one path");
        const cleft_io_raw layout = checked_layout(required(raw, "raw"));
        std::vector<Source> sources;
        for (int64_t i = 0; i < count; ++i) {
            const std::string path = required(paths[i], "a path");
            const bool may_pack = count > 1 && layout.kind != CLEFT_IO_KIND_INDICATORS;
            sources.push_back(source_of(path, read_raw_image(path, layout), may_pack));
        }
        // The layout gives the spacing of all files; world and scale have no meaning for voxels
        // without a place.
        const Affine affine = affine_of(sources.front().image, reading_or_defaults(nullptr));
        create_volume(context, options, sources, affine, layout.kind, out);
    });
}

cleft_status cleft_io_write_sizing(cleft_context* context, const cleft_sizing* sizing, const char* path,
                                   cleft_io_world world) noexcept
{
    return entry(context, {sizing}, [&] {
        // Checked before the field is copied.
        required(path, "path");
        Affine affine{};
        Image image;
        image.component = Component::float32;
        const bool has_metric = cleft_sizing_has_metric(sizing) != 0;
        image.fields = has_metric ? 6 : 1;
        check(context, cleft_sizing_dims(required(sizing, "sizing"), image.dims.data()), "sizing: ");
        check(context, cleft_sizing_affine(sizing, affine.data()), "sizing: ");
        // The world in which the volume was read: the field's numbers are in it, and files are
        // written in LPS.
        if (world != CLEFT_IO_WORLD_LPS && world != CLEFT_IO_WORLD_RAS)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there is no world " + std::to_string(world));
        set_geometry(affine, world, image);
        allocate_voxels(image);
        if (has_metric)
            copy_metric(context, sizing, world, image);
        else
            std::memcpy(image.voxels.get(), cleft_sizing_values(sizing), image.bytes());
        naming_file(path, [&] { has_metric ? write_tensors(path, image) : write_image(path, image); });
    });
}

cleft_status cleft_io_read_field(cleft_context* context, const char* path, const cleft_io_reading* reading,
                                 int64_t dims[3], double affine[12], double** values) noexcept
{
    return entry_making(context, values, {}, [&] {
        Affine map{};
        Image image = read_field_image(context, required(path, "path"), reading_or_defaults(reading), map);
        widen(image);
        const size_t bytes = image.bytes();
        // malloc() and not new: cleft_io_free() must fit any language, and Fortran and Python free
        // by address alone.
        void* copy = std::malloc(bytes);
        if (!copy)
            throw std::bad_alloc();
        std::memcpy(copy, image.voxels.get(), bytes);
        *values = static_cast<double*>(copy);
        if (dims)
            std::copy(image.dims.begin(), image.dims.end(), dims);
        if (affine)
            std::copy(map.begin(), map.end(), affine);
    });
}

void cleft_io_free(void* array) noexcept { std::free(array); }

cleft_status cleft_io_read_sizing(cleft_context* context, const cleft_volume* volume, const char* path,
                                  const cleft_io_reading* reading, int32_t combine, const cleft_options* options,
                                  cleft_sizing** out) noexcept
{
    return entry_making(context, out, {volume, options}, [&] {
        const VoxelGrid grid = grid_of(context, required(volume, "volume"));
        Affine map{};
        const cleft_io_reading how = reading_or_defaults(reading);
        Image image = read_field_image(context, required(path, "path"), how, map);
        // The lengths in the field follow the scale of the volume. The command, whose fields are in
        // the unit of the mesh, passes 1.
        scale_values(how.scale, image);
        naming_file(path, [&] {
            check_same_grid({image.dims, map}, grid, "the volume");
            check(context, cleft_sizing_create_values(context, volume, type_of(image.component), image.voxels.get(),
                                                      combine, options, out));
        });
    });
}

cleft_status cleft_io_read_metric(cleft_context* context, const cleft_volume* volume, const char* path,
                                  const cleft_io_reading* reading, cleft_io_tensor_order order, int32_t combine,
                                  const cleft_options* options, cleft_sizing** out) noexcept
{
    return entry_making(context, out, {volume, options}, [&] {
        read_metric(context, volume, required(path, "path"), reading_or_defaults(reading), order, combine, options,
                    out);
    });
}
