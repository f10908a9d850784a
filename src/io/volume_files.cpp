// Entries: volumes and fields in, sizing fields out.
#include "base/error.hpp"
#include "cleft/cleft_io.h"
#include "io/entry.hpp"
#include "io/image_series.hpp"
#include "io/raw_image.hpp"
#include "io/text_scanner.hpp"
#include "io/voxels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <cstring>

namespace cleft::io
{

namespace
{

using Affine = std::array<double, 12>;

cleft_io_reading reading_or_defaults(const cleft_io_reading* given)
{
    cleft_io_reading reading{};
    if (given)
        std::memcpy(&reading, given, std::min<size_t>(given->struct_size, sizeof reading));
    if (reading.world != CLEFT_IO_WORLD_LPS && reading.world != CLEFT_IO_WORLD_RAS)
        throw Error(CLEFT_ERROR_ARGUMENT, "there is no world " + std::to_string(reading.world));
    if (reading.kind < CLEFT_IO_KIND_AUTO || reading.kind > CLEFT_IO_KIND_INDICATORS)
        throw Error(CLEFT_ERROR_ARGUMENT, "there is no kind " + std::to_string(reading.kind));
    if (!std::isfinite(reading.scale) || reading.scale < 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "the scale of origin and spacing must be positive");
    if (reading.scale == 0)
        reading.scale = 1;
    return reading;
}

void create_labels(cleft_context* context, const cleft_options* options, Image& image, const Affine& affine,
                   cleft_volume** out)
{
    if (image.fields != 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has four dimensions, but a label map has three");
    make_labels(image);
    check(context, cleft_volume_create_labels(context, type_of(image.component), image.voxels.get(), image.dims.data(),
                                              affine.data(), options, out));
}

// All fields of all images; they are of one type here.
void create_indicators(cleft_context* context, const std::vector<Image>& images, const Affine& affine,
                       const std::string& who, cleft_volume** out)
{
    std::vector<const void*> fields;
    for (const Image& image : images)
        for (int64_t f = 0; f < image.fields; ++f)
            fields.push_back(image.voxels.get() +
                             static_cast<size_t>(f * image.field_size()) * size_of(image.component));
    check(context,
          cleft_volume_create_indicators(context, type_of(images.front().component), fields.data(),
                                         static_cast<int64_t>(fields.size()), images.front().dims.data(), affine.data(),
                                         nullptr, out),
          who);
}

// Tells what the reader noticed about a file.
void log_notes(cleft_context* context, const std::string& path, const Image& image)
{
    for (const std::string& note : image.notes)
        check(context, cleft_context_log(context, CLEFT_LOG_WARNING, ("'" + path + "': " + note).c_str()));
}

Image read_and_tell(cleft_context* context, const std::string& path)
{
    Image image = read_image_or_series(path);
    log_notes(context, path, image);
    return image;
}

// For messages about all of them.
std::string file_list(const char* const* paths, int64_t count)
{
    return std::string("'") + paths[0] + (count > 1 ? "' and others: " : "': ");
}

// The greatest distance between the places that two maps give to a corner of the grid, in voxels.
double greatest_shift(const Affine& a, const Affine& b, const std::array<int64_t, 3>& dims)
{
    double shift = 0;
    for (int corner = 0; corner < 8; ++corner) {
        double squared = 0;
        for (size_t row = 0; row < 3; ++row) {
            double way = a[4 * row + 3] - b[4 * row + 3];
            for (size_t axis = 0; axis < 3; ++axis)
                if (corner >> axis & 1)
                    way += (a[4 * row + axis] - b[4 * row + axis]) * static_cast<double>(dims[axis]);
            squared += way * way;
        }
        shift = std::max(shift, std::sqrt(squared));
    }
    double voxel = std::numeric_limits<double>::max();
    for (size_t axis = 0; axis < 3; ++axis)
        voxel = std::min(voxel, std::hypot(a[axis], a[4 + axis], a[8 + axis]));
    return shift / voxel;
}

void check_same_grid(const Affine& a, const std::array<int64_t, 3>& dims_a, const Affine& b,
                     const std::array<int64_t, 3>& dims_b, const std::string& other)
{
    constexpr double tolerance = 0.01;
    const auto text = [](const std::array<int64_t, 3>& dims) {
        return std::to_string(dims[0]) + " x " + std::to_string(dims[1]) + " x " + std::to_string(dims[2]);
    };
    if (dims_a != dims_b)
        throw Error(CLEFT_ERROR_ARGUMENT, "it has " + text(dims_b) + " voxels, but " + other + " has " + text(dims_a));
    if (greatest_shift(a, b, dims_a) > tolerance)
        throw Error(CLEFT_ERROR_ARGUMENT, "its voxels are not at the places of those of " + other);
}

// One type for all: float, or double if one is double.
void unify(std::vector<Image>& images)
{
    bool wide = false;
    for (Image& image : images) {
        make_floating(image);
        wide = wide || image.component == Component::float64;
    }
    if (wide)
        for (Image& image : images)
            widen(image);
}

void read_indicators(cleft_context* context, const char* const* paths, int64_t count, const cleft_io_reading& reading,
                     Image first, cleft_volume** out)
{
    const Affine affine = naming_file(paths[0], [&] { return affine_of(first, reading); });
    std::vector<Image> images;
    images.push_back(std::move(first));
    for (int64_t i = 1; i < count; ++i) {
        const char* path = required(paths[i], "a path");
        images.push_back(read_and_tell(context, path));
        naming_file(path, [&] {
            check_same_grid(affine, images[0].dims, affine_of(images.back(), reading), images.back().dims,
                            std::string("'") + paths[0] + "'");
        });
    }
    unify(images);
    create_indicators(context, images, affine, file_list(paths, count), out);
}

void read_volume(cleft_context* context, const cleft_options* options, const char* const* paths, int64_t count,
                 const cleft_io_reading& reading, cleft_volume** out)
{
    if (reading.kind == CLEFT_IO_KIND_LABELS && count > 1)
        throw Error(CLEFT_ERROR_ARGUMENT, "a label map is one file, but there are " + std::to_string(count));
    Image first = read_and_tell(context, required(paths[0], "a path"));
    const bool may_be_labels = reading.kind == CLEFT_IO_KIND_AUTO && count == 1 && first.fields == 1;
    if (reading.kind == CLEFT_IO_KIND_LABELS || (may_be_labels && looks_like_labels(first)))
        naming_file(paths[0], [&] { create_labels(context, options, first, affine_of(first, reading), out); });
    else
        read_indicators(context, paths, count, reading, std::move(first), out);
}

Image read_field_image(cleft_context* context, const char* path, const cleft_io_reading& reading, Affine& affine)
{
    Image image = read_and_tell(context, path);
    naming_file(path, [&] {
        if (image.fields != 1)
            throw Error(CLEFT_ERROR_FORMAT, "it has four dimensions, but a field has three");
        affine = affine_of(image, reading);
        make_floating(image);
    });
    return image;
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

cleft_status cleft_io_read_volume(cleft_context* context, const cleft_options* options, const char* const* paths,
                                  int64_t count, const cleft_io_reading* reading, cleft_volume** out) noexcept
{
    return entry(context, [&] {
        *required(out, "out") = nullptr;
        required(context, "context");
        required(paths, "paths");
        if (count < 1)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there must be at least one path");
        read_volume(context, options, paths, count, reading_or_defaults(reading), out);
    });
}

cleft_status cleft_io_read_raw(cleft_context* context, const cleft_options* options, const char* const* paths,
                               int64_t count, const cleft_io_raw* raw, cleft_volume** out) noexcept
{
    return entry(context, [&] {
        *required(out, "out") = nullptr;
        required(context, "context");
        required(paths, "paths");
        if (count < 1)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there must be at least one path");
        const cleft_io_raw layout = checked_layout(required(raw, "raw"));
        std::vector<Image> images;
        for (int64_t i = 0; i < count; ++i)
            images.push_back(read_raw_image(required(paths[i], "a path"), layout));
        const Affine affine = affine_of(images.front(), reading_or_defaults(nullptr));
        if (is_floating(images.front().component)) {
            create_indicators(context, images, affine, file_list(paths, count), out);
        } else if (count == 1) {
            create_labels(context, options, images.front(), affine, out);
        } else {
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "indicator functions must be floating-point numbers");
        }
    });
}

cleft_status cleft_io_write_sizing(cleft_context* context, const cleft_sizing* sizing, const char* path,
                                   cleft_io_world world) noexcept
{
    return entry(context, [&] {
        required(context, "context");
        required(path, "path");
        Affine affine{};
        Image image;
        image.component = Component::float32;
        check(context, cleft_sizing_dims(required(sizing, "sizing"), image.dims.data()), "sizing: ");
        check(context, cleft_sizing_affine(sizing, affine.data()), "sizing: ");
        if (world != CLEFT_IO_WORLD_LPS && world != CLEFT_IO_WORLD_RAS)
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there is no world " + std::to_string(world));
        set_geometry(affine, world, image);
        allocate_voxels(image);
        std::memcpy(image.voxels.get(), cleft_sizing_values(sizing), image.bytes());
        naming_file(path, [&] { write_image(path, image); });
    });
}

cleft_status cleft_io_read_field(cleft_context* context, const char* path, const cleft_io_reading* reading,
                                 int64_t dims[3], double affine[12], double** values) noexcept
{
    return entry(context, [&] {
        *required(values, "values") = nullptr;
        required(context, "context");
        Affine map{};
        Image image = read_field_image(context, required(path, "path"), reading_or_defaults(reading), map);
        widen(image);
        const size_t bytes = image.bytes();
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
    return entry(context, [&] {
        *required(out, "out") = nullptr;
        required(context, "context");
        std::array<int64_t, 3> dims{};
        Affine affine{};
        check(context, cleft_volume_dims(required(volume, "volume"), dims.data()), "volume: ");
        check(context, cleft_volume_affine(volume, affine.data()), "volume: ");
        Affine map{};
        const cleft_io_reading how = reading_or_defaults(reading);
        Image image = read_field_image(context, required(path, "path"), how, map);
        scale_values(how.scale, image);
        naming_file(path, [&] {
            check_same_grid(affine, dims, map, image.dims, "the volume");
            check(context, cleft_sizing_create_values(context, volume, type_of(image.component), image.voxels.get(),
                                                      combine, options, out));
        });
    });
}
