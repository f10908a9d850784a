// Volumes in legacy VTK files: structured points, and rectilinear grids that are evenly spaced. Values on cells are one
// voxel a cell; values on points are one voxel about each point.
#include "base/error.hpp"
#include "io/ascii.hpp"
#include "io/header_values.hpp"
#include "io/image_readers.hpp"
#include "io/text_source.hpp"
#include "io/voxel_access.hpp"
#include "io/vtk_arrays.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <set>

namespace cleft::io
{

namespace
{

struct Grid {
    bool binary = false;
    std::array<int64_t, 3> points{0, 0, 0};
    Vector3 origin{0, 0, 0};
    Vector3 spacing{1, 1, 1};
};

// DIMENSIONS are three numbers of any size; their product is used to count values.
int64_t product_of(const std::array<int64_t, 3>& dims)
{
    int64_t product = 1;
    for (const int64_t dim : dims)
        if (__builtin_mul_overflow(product, dim, &product))
            throw Error(CLEFT_ERROR_TOO_LARGE, "there are too many voxels");
    return product;
}

// An axis of one point has one layer of cells.
// A plane of points has one layer of plane cells, which is a slice of voxels.
std::array<int64_t, 3> cells_of(const Grid& grid)
{
    std::array<int64_t, 3> cells{};
    for (size_t axis = 0; axis < 3; ++axis)
        cells[axis] = std::max<int64_t>(1, grid.points[axis] - 1);
    return cells;
}

Vector3 three_reals(TextSource& source, const char* field)
{
    Vector3 numbers{};
    for (double& number : numbers)
        number = real_of(field, source.word());
    return numbers;
}

void take_dimensions(TextSource& source, Grid& grid)
{
    for (int64_t& dim : grid.points) {
        dim = integer_of("DIMENSIONS", source.word());
        if (dim < 1)
            refuse_field("DIMENSIONS", std::to_string(dim), "an axis must have a point");
    }
    product_of(grid.points);
}

std::vector<double> coordinates(TextSource& source, bool binary, const char* field, int64_t wanted)
{
    const int64_t count = vtk_count(source, field);
    if (count != wanted)
        refuse_field(field, std::to_string(count), std::to_string(wanted) + " are wanted");
    const Component type = vtk_number_type(std::string(source.word()));
    // Binary data begin right behind the end of the line, with any byte.
    source.rest_is_blank();
    std::vector<double> values;
    if (!binary) {
        source.expect(static_cast<uintmax_t>(count));
        for (int64_t i = 0; i < count; ++i)
            values.push_back(real_of(field, source.word()));
        return values;
    }
    const size_t size = size_of(type);
    // Before memory is taken. Binary numbers of legacy files are always big-endian.
    source.expect(static_cast<uintmax_t>(count) * size);
    for (int64_t i = 0; i < count; ++i) {
        std::byte bytes[8];
        source.read(bytes, size);
        if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
            swap_bytes(bytes, 1, size);
        values.push_back(
            with_type(type, [&](auto zero) { return static_cast<double>(load<decltype(zero)>(bytes, 0)); }));
    }
    return values;
}

void take_coordinates(TextSource& source, const char* field, size_t axis, Grid& grid)
{
    constexpr double kTolerance = 1e-3;  // of a voxel
    const std::vector<double> places = coordinates(source, grid.binary, field, grid.points[axis]);
    skip_vtk_metadata(source, 1);
    grid.origin[axis] = places.front();
    if (places.size() == 1)
        return;
    const double step = (places.back() - places.front()) / static_cast<double>(places.size() - 1);
    for (size_t i = 0; i < places.size(); ++i)
        // Coordinates of single precision are off by less. The negation also catches NaN.
        if (!(std::abs(places[i] - places.front() - static_cast<double>(i) * step) <= kTolerance * std::abs(step)))
            throw Error(CLEFT_ERROR_UNSUPPORTED,
                        std::string("its rectilinear grid is not evenly spaced (") + field + "): resample it");
    // Descending coordinates give a negative step, which set_place() makes a flipped axis.
    grid.spacing[axis] = step;
}

// Takes a keyword of the geometry; false if it is none.
bool take_geometry(TextSource& source, const std::string& keyword, bool rectilinear, Grid& grid)
{
    static constexpr std::array<const char*, 3> kNames{"X_COORDINATES", "Y_COORDINATES", "Z_COORDINATES"};
    // The keywords of the geometry may come in any order, but for coordinates, whose number must be
    // known.
    if (keyword == "DIMENSIONS") {
        take_dimensions(source, grid);
    } else if (!rectilinear && keyword == "ORIGIN") {
        grid.origin = three_reals(source, "ORIGIN");
        // ASPECT_RATIO is the name of SPACING in version 1.0.
    } else if (!rectilinear && (keyword == "SPACING" || keyword == "ASPECT_RATIO")) {
        grid.spacing = three_reals(source, "SPACING");
    } else if (keyword == "FIELD") {
        skip_vtk_field(source, grid.binary);
    } else {
        const auto found = std::find(kNames.begin(), kNames.end(), keyword);
        if (!rectilinear || found == kNames.end())
            return false;
        if (grid.points[0] == 0)
            throw Error(CLEFT_ERROR_FORMAT, "its DIMENSIONS must come before its coordinates");
        take_coordinates(source, *found, static_cast<size_t>(found - kNames.begin()), grid);
    }
    return true;
}

// Is the file binary behind its header?
bool read_coding(TextSource& source)
{
    std::string line;
    source.next_line(line);       // "# vtk DataFile Version 3.0"
    if (!source.next_line(line))  // the title, which may be anything
        throw Error(CLEFT_ERROR_FORMAT, "its header is cut short");
    const std::string coding = in_capitals(source.word());
    if (coding != "ASCII" && coding != "BINARY")
        throw Error(CLEFT_ERROR_FORMAT, "its third line is neither ASCII nor BINARY");
    return coding == "BINARY";
}

// The word behind DATASET.
std::string read_kind(TextSource& source, bool binary)
{
    std::string keyword = in_capitals(source.word());
    // VTK writes field data of the whole file before DATASET or behind its geometry, and some
    // programs put comments there.
    while (keyword == "FIELD" || (!keyword.empty() && keyword[0] == '#')) {
        std::string comment;
        if (keyword == "FIELD")
            skip_vtk_field(source, binary);
        else
            source.next_line(comment);
        keyword = in_capitals(source.word());
    }
    if (keyword != "DATASET")
        throw Error(CLEFT_ERROR_FORMAT, "'" + keyword.substr(0, 40) + "' stands where DATASET is wanted");
    const std::string kind = in_capitals(source.word());
    if (kind == "STRUCTURED_GRID")
        throw Error(CLEFT_ERROR_UNSUPPORTED,
                    "it is a STRUCTURED_GRID, whose points may lie anywhere: resample it to "
                    "structured points");
    if (kind != "STRUCTURED_POINTS" && kind != "RECTILINEAR_GRID")
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it holds a dataset of kind " + kind.substr(0, 40) + ", not a volume");
    return kind;
}

// Up to POINT_DATA or CELL_DATA, which are left for the next reader.
Grid read_grid(TextSource& source)
{
    Grid grid;
    grid.binary = read_coding(source);
    const bool rectilinear = read_kind(source, grid.binary) == "RECTILINEAR_GRID";
    for (std::string_view next = source.peek(); !next.empty(); next = source.peek()) {
        const std::string keyword = in_capitals(next);
        if (keyword == "POINT_DATA" || keyword == "CELL_DATA")
            break;
        source.word();
        if (!take_geometry(source, keyword, rectilinear, grid))
            throw Error(CLEFT_ERROR_FORMAT, "its keyword '" + keyword.substr(0, 40) + "' is not known");
    }
    if (grid.points[0] == 0)
        throw Error(CLEFT_ERROR_FORMAT, "it gives no DIMENSIONS");
    return grid;
}

bool is_likely_name(const std::string& name)
{
    // Names that common programs give to their labels: FeatureIds of DREAM.3D, "scalars" of VTK's
    // own filters.
    static const std::set<std::string> likely{"label",      "labels",       "labelmap",   "label_map",   "labelids",
                                              "material",   "materials",    "materialid", "materialids", "material_id",
                                              "featureids", "segmentation", "phase",      "phases",      "scalars"};
    return likely.count(in_small_letters(name)) > 0;
}

// Of one array there is no question. Of several, the one that is called as labels are, if it is the only one.
VtkArray chosen(const std::vector<VtkArray>& arrays, Image& image)
{
    std::string names;
    std::vector<VtkArray> usable;
    std::vector<VtkArray> likely;
    for (const VtkArray& array : arrays) {
        // ParaView adds these arrays for its own use; they are no data of the user's.
        if (array.name == "vtkGhostType" || array.name == "vtkGhostLevels")
            continue;
        names += (names.empty() ? "'" : ", '") + array.name.substr(0, 60) + "'" +
                 (array.on_cells ? " on cells" : " on points");
        // Global ids are numbers of points, all different, and no labels.
        const bool is_usable = array.is_numeric && array.components == 1 && !array.is_id;
        if (is_usable)
            usable.push_back(array);
        if (is_usable && is_likely_name(array.name))
            likely.push_back(array);
    }
    if (names.empty())
        throw Error(CLEFT_ERROR_FORMAT, "it has no values on points or cells");
    if (usable.empty())
        throw Error(CLEFT_ERROR_FORMAT,
                    "its arrays (" + names + ") are colours, vectors, texts or ids; one number a voxel is wanted");
    if (arrays.size() == 1)
        return usable.front();
    // An image and its labels in one file are common. Taking the wrong one would mesh grey values.
    if (usable.size() > 1 && likely.size() != 1)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has several arrays (" + names + "); keep one, or call one of them 'labels'");
    const VtkArray& array = usable.size() == 1 ? usable.front() : likely.front();
    if (names.find(',') != std::string::npos)
        image.notes.push_back("it has several arrays (" + names + "), of which '" + array.name + "' is read");
    return array;
}

// The array of tensors, if there is one alone.
VtkArray chosen_tensors(const std::vector<VtkArray>& arrays)
{
    std::vector<VtkArray> usable;
    for (const VtkArray& array : arrays)
        if (array.is_numeric && !array.is_bit && !array.is_colour && (array.components == 6 || array.components == 9))
            usable.push_back(array);
    if (usable.size() != 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(usable.size()) +
                                            " arrays of six or nine numbers a voxel; one is wanted");
    return usable.front();
}

void set_place(const Grid& grid, bool on_cells, Image& image)
{
    image.dims = on_cells ? cells_of(grid) : grid.points;
    image.origin = grid.origin;
    for (size_t axis = 0; axis < 3; ++axis) {
        const double step = grid.spacing[axis];
        // The centre of the first cell. An axis of one point has no cell along it, so the plane
        // stays where it is.
        if (on_cells && grid.points[axis] > 1)
            image.origin[axis] += step / 2;
        image.spacing[axis] = std::abs(step);
        if (step < 0)
            image.directions[axis] = times(-1, image.directions[axis]);
    }
}

// Eight values a byte, the first in the highest bit, and no padding at the ends of rows.
void read_bits(TextSource& source, Image& image)
{
    const auto count = static_cast<size_t>(image.field_size());
    std::vector<unsigned char> packed((count + 7) / 8);
    source.read(packed.data(), packed.size());
    for (size_t i = 0; i < count; ++i)
        image.voxels[i] = static_cast<std::byte>(packed[i / 8] >> (7 - i % 8) & 1);
}

// VTK writes a label map of bytes as colours.
// COLOR_SCALARS are bytes in binary files and fractions from 0 to 1 in text ("VTK File Formats").
void store_colour(std::string_view word, Image& image, int64_t voxel)
{
    const double value = 255 * real_of("COLOR_SCALARS", word);
    if (!(value > -0.01 && value < 255.01) || std::abs(value - std::round(value)) > 0.01)
        refuse_field("COLOR_SCALARS", word, "a fraction of 255 is wanted");
    image.voxels[static_cast<size_t>(voxel)] = static_cast<std::byte>(std::lround(value));
}

void read_values(const std::string& path, const Grid& grid, const VtkArray& array, Image& image)
{
    TextSource source(path);
    // A second source: the first one has read on to the end, to find all arrays before one was
    // chosen.
    source.skip(array.place - source.position());
    allocate_voxels(image);
    if (!grid.binary) {
        const auto store = array.is_colour ? store_colour : store_text_voxel;
        for (int64_t i = 0; i < image.field_size() * image.fields; ++i)
            store(source.word(), image, i);
        note_text_end(source.left() == 0, image);
    } else if (array.is_bit) {
        read_bits(source, image);
    } else {
        source.read(image.voxels.get(), image.bytes());
        if (__BYTE_ORDER__ == __ORDER_LITTLE_ENDIAN__)
            swap_bytes(image);
    }
}

}  // namespace

bool is_vtk_volume(const FileHead& head) { return !head.gzip && head.begins_with("# vtk DataFile"); }

Image read_vtk_volume(const std::string& path, const FileHead&)
{
    TextSource source(path);
    const Grid grid = read_grid(source);
    const auto arrays = find_vtk_arrays(source, grid.binary, product_of(grid.points), product_of(cells_of(grid)));
    Image image;
    const VtkArray array = chosen(arrays, image);
    image.component = array.component;
    set_place(grid, array.on_cells, image);
    read_values(path, grid, array, image);
    return image;
}

StoredImage locate_vtk_volume(const std::string& path, const FileHead&)
{
    TextSource source(path);
    const Grid grid = read_grid(source);
    const auto arrays = find_vtk_arrays(source, grid.binary, product_of(grid.points), product_of(cells_of(grid)));
    StoredImage stored;
    const VtkArray array = chosen(arrays, stored.image);
    stored.image.component = array.component;
    set_place(grid, array.on_cells, stored.image);
    stored.data.encoding = grid.binary ? VoxelData::Encoding::raw : VoxelData::Encoding::text;
    stored.data.big_endian = true;
    stored.data.attached = true;
    stored.data.offset = static_cast<int64_t>(array.place);
    stored.data.files = {path};
    stored.is_followed = true;
    // Eight voxels a byte have no place of their own.
    if (array.is_bit)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "its voxels are single bits, which cannot be read by parts");
    return stored;
}

TensorImage read_vtk_tensors(const std::string& path, const FileHead&)
{
    TextSource source(path);
    const Grid grid = read_grid(source);
    const VtkArray array =
        chosen_tensors(find_vtk_arrays(source, grid.binary, product_of(grid.points), product_of(cells_of(grid))));
    TensorImage tensors;
    tensors.side_by_side = true;
    // VTK has one order for six numbers, whatever keyword they come under.
    tensors.order = array.components == 6 ? CLEFT_IO_ORDER_VTK : CLEFT_IO_ORDER_FILE;
    tensors.image.component = array.component;
    tensors.image.fields = array.components;
    set_place(grid, array.on_cells, tensors.image);
    read_values(path, grid, array, tensors.image);
    return tensors;
}

}  // namespace cleft::io
