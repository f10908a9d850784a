// Tensors in VTK XML image data of one piece.
#include "base/error.hpp"
#include "io/header_values.hpp"
#include "io/image_readers.hpp"
#include "io/tensor_image.hpp"
#include "io/text_scanner.hpp"
#include "io/vtk_array.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace cleft::io
{

namespace
{

struct VtiArray {
    XmlTag tag;
    bool on_cells = false;
    int64_t components = 1;
};

struct VtiFile {
    VtkEncoding encoding;
    XmlTag image, piece;
    std::vector<VtiArray> arrays;
};

std::vector<double> reals(const XmlTag& tag, const char* attribute, size_t count, const char* by_default)
{
    const std::string text = tag.get(attribute);
    return reals_of(attribute, text.empty() ? by_default : text, count);
}

// The first and the last point along each axis.
std::vector<int64_t> extent_of(const XmlTag& piece)
{
    constexpr int64_t kMost = int64_t{1} << 40;
    const std::string text = piece.get("Extent");
    const std::vector<int64_t> extent = integers_of("Extent", text, 6);
    for (size_t axis = 0; axis < 3; ++axis)
        if (extent[2 * axis] < -kMost || extent[2 * axis + 1] > kMost || extent[2 * axis + 1] < extent[2 * axis])
            refuse_field("Extent", text, "an axis must have a first and a last point");
    return extent;
}

VtiFile scan_image(std::string_view text)
{
    VtiFile file;
    XmlScanner scanner(text);
    bool on_cells = false, in_section = false;
    for (XmlTag tag; scanner.next(tag);) {
        if (tag.name == "VTKFile") {
            file.encoding = vtk_encoding_of(tag);
        } else if (tag.name == "ImageData") {
            file.image = tag;
        } else if (tag.name == "Piece") {
            if (!file.piece.name.empty())
                throw Error(CLEFT_ERROR_UNSUPPORTED, "only files of one piece can be read");
            file.piece = tag;
        } else if (tag.name == "PointData" || tag.name == "CellData") {
            on_cells = tag.name == "CellData";
            in_section = true;
        } else if (tag.name == "/PointData" || tag.name == "/CellData") {
            in_section = false;
        } else if (tag.name == "DataArray" && in_section) {
            const std::string components = tag.get("NumberOfComponents");
            file.arrays.push_back({tag, on_cells, components == "6" ? 6 : components == "9" ? 9 : 1});
        } else if (tag.name == "AppendedData") {
            find_vtk_appended_data(text, tag, file.encoding);
            break;  // behind them nothing is XML any more
        }
    }
    if (file.image.name.empty() || file.piece.name.empty())
        throw Error(CLEFT_ERROR_FORMAT, "it has no piece of image data");
    return file;
}

const VtiArray& chosen_tensors(const VtiFile& file)
{
    const auto is_tensor = [](const VtiArray& array) { return array.components == 6 || array.components == 9; };
    const auto count = std::count_if(file.arrays.begin(), file.arrays.end(), is_tensor);
    if (count != 1)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has " + std::to_string(count) + " arrays of six or nine numbers a voxel; one is wanted");
    return *std::find_if(file.arrays.begin(), file.arrays.end(), is_tensor);
}

// Points of the extent lie at the origin plus their numbers times the spacing, which may be negative, along the axes.
void set_place(const VtiFile& file, bool on_cells, Image& image)
{
    const std::vector<int64_t> extent = extent_of(file.piece);
    const std::vector<double> origin = reals(file.image, "Origin", 3, "0 0 0");
    const std::vector<double> spacing = reals(file.image, "Spacing", 3, "1 1 1");
    const std::vector<double> axes = reals(file.image, "Direction", 9, "1 0 0 0 1 0 0 0 1");
    std::copy(origin.begin(), origin.end(), image.origin.begin());
    for (size_t axis = 0; axis < 3; ++axis) {
        const int64_t points = extent[2 * axis + 1] - extent[2 * axis] + 1;
        // A plane of points has one layer of plane cells, which is a slice of voxels.
        image.dims[axis] = on_cells ? std::max<int64_t>(1, points - 1) : points;
        image.spacing[axis] = std::abs(spacing[axis]);
        const double sign = spacing[axis] < 0 ? -1 : 1;
        const double first = static_cast<double>(extent[2 * axis]) + (on_cells && points > 1 ? 0.5 : 0);
        for (size_t row = 0; row < 3; ++row) {
            image.directions[axis][row] = sign * axes[3 * row + axis];
            image.origin[row] += first * spacing[axis] * axes[3 * row + axis];
        }
    }
}

TensorImage read_image(std::string_view text)
{
    const VtiFile file = scan_image(text);
    const VtiArray& array = chosen_tensors(file);
    TensorImage tensors;
    tensors.side_by_side = true;
    tensors.order = array.components == 6 ? CLEFT_IO_ORDER_VTK : CLEFT_IO_ORDER_FILE;
    Image& image = tensors.image;
    image.component = Component::float64;
    image.fields = array.components;
    set_place(file, array.on_cells, image);
    const size_t bytes = checked_bytes(image);
    // The array is read before memory is taken for what the extent claims.
    const std::vector<double> numbers =
        read_vtk_reals(array.tag, file.encoding, static_cast<int64_t>(bytes / sizeof(double)));
    allocate_voxels(image);
    std::memcpy(image.voxels.get(), numbers.data(), bytes);
    return tensors;
}

}  // namespace

bool is_vti(const FileHead& head)
{
    return !head.gzip && head.text().find("<VTKFile") != std::string_view::npos &&
           head.text().find("\"ImageData\"") != std::string_view::npos;
}

TensorImage read_vti_tensors(const std::string& path, const FileHead&)
{
    const std::string text = read_whole_file(path);
    return read_image(text);
}

}  // namespace cleft::io
