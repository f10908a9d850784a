// Reads what ImageJ, OME and tifffile say in the description of a TIFF file about its pages: how many slices there are,
// what else there is, and how large the voxels are.
#include "io/tiff_description.hpp"

#include "base/error.hpp"
#include "io/header_values.hpp"
#include "io/xml_scanner.hpp"

#include <charconv>
#include <cmath>
#include <map>
#include <vector>

namespace cleft::io
{

namespace
{

using Values = std::map<std::string, std::string>;

double real_of(const std::string& text, const std::string& who)
{
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    // 0 and NaN are left by programs that had no calibration. As a length they would flatten the
    // volume.
    if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value) || value == 0)
        throw Error(CLEFT_ERROR_FORMAT, who + " is '" + text.substr(0, 40) + "', which is no length");
    // The sign says nothing here, as the order of the slices is that of the pages.
    return std::abs(value);
}

// A count that is not there is 1.
// Counts come from text that anybody may have edited, so they are read strictly.
int64_t count_of(const std::string& text, const std::string& who)
{
    int64_t value = 1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (!text.empty() && (error != std::errc() || end != text.data() + text.size() || value < 1))
        throw Error(CLEFT_ERROR_FORMAT, who + " is '" + text.substr(0, 40) + "', which is no count");
    return value;
}

// Channels are different quantities and frames are different times: none of them is a third axis of
// space.
[[noreturn]] void refuse_axis(const std::string& program, int64_t count, const std::string& what)
{
    throw Error(CLEFT_ERROR_FORMAT, program + " says that it has " + std::to_string(count) + " " + what +
                                        ": save the one that holds the labels by itself, or, if they are the slices of "
                                        "one volume, save them as slices");
}

void check_channels(const std::string& program, int64_t count)
{
    if (count > 1)
        refuse_axis(program, count, "channels");
}

void check_frames(const std::string& program, int64_t count)
{
    if (count > 1)
        refuse_axis(program, count, "points in time (frames)");
}

Values lines_of(const std::string& text)
{
    Values values;
    for (size_t at = 0; at < text.size();) {
        const size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        const size_t equals = line.find('=');
        // ImageJ writes "key=value" lines. Later lines of one key win, as in ImageJ.
        if (equals != std::string::npos)
            values[line.substr(0, equals)] = line.substr(equals + 1, line.find_last_not_of("\r ") - equals);
        at = end + 1;
    }
    return values;
}

// ImageJ gives pixels per unit in the tags; without a unit they are printing hints, unless they are per nothing.
TiffDescription imagej(const std::string& text, const TiffPageSize& page)
{
    Values values = lines_of(text);
    TiffDescription found;
    found.who = "ImageJ";
    check_channels("ImageJ", count_of(values["channels"], "ImageJ's 'channels'"));
    check_frames("ImageJ", count_of(values["frames"], "ImageJ's 'frames'"));
    // "images" is the number of planes; with channels and frames refused, all are slices.
    found.slices = count_of(values["images"], "ImageJ's 'images'");
    found.unit = plain_unit(values["unit"]);
    // Programs leave 72 or 96 pixels an inch in the tags. Only ImageJ's own unit, or ResolutionUnit
    // 1, shows a calibration.
    const bool scaled = (!values["unit"].empty() || page.unit == 1) && page.x_resolution > 0 && page.y_resolution > 0;
    found.knows_third = !values["spacing"].empty();
    found.has_spacing = scaled || found.knows_third;
    if (scaled)
        found.spacing = {1 / page.x_resolution, 1 / page.y_resolution, 1};
    if (found.knows_third)
        found.spacing[2] = real_of(values["spacing"], "ImageJ's 'spacing'");
    // "cf", "c0" and so on are a function from numbers to densities.
    if (values.count("cf") != 0 || values.count("c0") != 0)
        found.notes.emplace_back("ImageJ's calibration of values is not used: the numbers are those in the file");
    return found;
}

double metres(const std::string& unit)
{
    // Units that can be converted into each other. 0 is the answer for all others.
    const std::map<std::string, double> known{{"m", 1},     {"cm", 1e-2}, {"mm", 1e-3},
                                              {"um", 1e-6}, {"nm", 1e-9}, {"pm", 1e-12}};
    const auto found = known.find(unit);
    return found == known.end() ? 0 : found->second;
}

// Voxels are unit cubes unless there is a size along x and y.
void note_lonely_sizes(const XmlTag& pixels, TiffDescription& found)
{
    for (const char* name : {"PhysicalSizeX", "PhysicalSizeY", "PhysicalSizeZ"})
        if (!pixels.get(name).empty()) {
            found.notes.push_back(std::string("OME's '") + name +
                                  "' is not used, as sizes along other axes are missing");
            return;
        }
}

void read_physical_sizes(const XmlTag& pixels, TiffDescription& found)
{
    const std::string axes = "XYZ";
    for (size_t axis = 0; axis < 3; ++axis) {
        const std::string name = std::string("PhysicalSize") + axes[axis];
        const std::string size = pixels.get(name);
        if (size.empty() && axis < 2) {
            note_lonely_sizes(pixels, found);
            found.spacing = {1, 1, 1};
            return;
        }
        if (size.empty()) {
            found.spacing[2] = found.spacing[0];
            break;
        }
        const std::string given = pixels.get(name + "Unit");
        // OME's schema has micrometres as the default of PhysicalSizeXUnit.
        const std::string unit = given.empty() ? "um" : plain_unit(given);
        found.spacing[axis] = real_of(size, "OME's '" + name + "'");
        if (axis == 0)
            found.unit = unit;
        // "pixel" and "reference frame" are units of OME, too, and have no length.
        else if (unit != found.unit && metres(unit) * metres(found.unit) == 0)
            throw Error(CLEFT_ERROR_FORMAT, "OME gives sizes of voxels in '" + found.unit + "' and '" + unit + "'");
        else if (unit != found.unit)
            found.spacing[axis] *= metres(unit) / metres(found.unit);
        found.knows_third = axis == 2;
    }
    found.has_spacing = true;
}

// One file, its pages in the order of the slices, or nothing.
void check_page_order(const XmlTag& data)
{
    // Attributes of TiffData, both 0 where missing.
    const std::string directory = data.get("IFD");
    const std::string slice = data.get("FirstZ");
    if ((slice.empty() ? "0" : slice) != (directory.empty() ? "0" : directory))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "OME says that its slices are not in the order of its pages");
}

TiffDescription ome(const std::string& text)
{
    TiffDescription found;
    found.who = "OME";
    XmlScanner scanner(text);
    XmlTag tag;
    int64_t images = 0;
    while (scanner.next(tag)) {
        // Elements may have a prefix for their namespace, as in "OME:Pixels".
        const std::string name = tag.name.substr(tag.name.find(':') + 1);
        if (name == "TiffData")
            check_page_order(tag);
        if (name != "Pixels" || tag.name[0] == '/')
            continue;
        // The second image is mostly an overview or a thumbnail, but it may as well be the labels.
        if (++images > 1)
            throw Error(CLEFT_ERROR_FORMAT, "OME says that it holds several images: save one by itself");
        check_channels("OME", count_of(tag.get("SizeC"), "OME's 'SizeC'"));
        check_frames("OME", count_of(tag.get("SizeT"), "OME's 'SizeT'"));
        found.slices = count_of(tag.get("SizeZ"), "OME's 'SizeZ'");
        read_physical_sizes(tag, found);
    }
    // Large OME data sets keep the text in one file and pages in others (BinaryOnly).
    if (images == 0)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "OME's description of its pages lies in another file, or is damaged");
    return found;
}

std::string between(const std::string& text, const std::string& open, char close)
{
    const size_t begin = text.find(open);
    if (begin == std::string::npos)
        return "";
    const size_t at = begin + open.size();
    return text.substr(at, text.find(close, at) - at);
}

std::vector<int64_t> numbers_of(const std::string& text)
{
    std::vector<int64_t> numbers;
    for (size_t at = text.find_first_of("0123456789"); at != std::string::npos;
         at = text.find_first_of("0123456789", at)) {
        const size_t end = std::min(text.find_first_not_of("0123456789", at), text.size());
        numbers.push_back(count_of(text.substr(at, end - at), "tifffile's 'shape'"));
        at = end;
    }
    return numbers;
}

// The number of axes, at the end, that lie in a page; 0: the shape is not that of these pages.
// tifffile writes a shape of all axes, slowest first; a page has the last two, or three with
// samples.
size_t axes_in_page(const std::vector<int64_t>& sizes, const TiffPageSize& page)
{
    const size_t n = sizes.size();
    if (n >= 2 && sizes[n - 2] == page.height && sizes[n - 1] == page.width)
        return 2;
    if (n >= 3 && sizes[n - 3] == page.height && sizes[n - 2] == page.width && sizes[n - 1] == 1)
        return 3;
    return 0;
}

TiffDescription tifffile_shape(const std::string& shape, std::string axes, const TiffPageSize& page)
{
    const std::vector<int64_t> sizes = numbers_of(shape);
    const size_t in_page = axes_in_page(sizes, page);
    // Another program may have changed the pages and kept the text.
    if (in_page == 0)
        return {};
    TiffDescription found;
    found.who = "tifffile";
    // Old versions write no letters of axes; then only the number of long axes is judged.
    if (axes.size() != sizes.size())
        axes.assign(sizes.size(), 'Q');
    size_t long_axes = 0;
    found.slices = 1;
    for (size_t axis = 0; axis + in_page < sizes.size(); ++axis) {
        if (axes[axis] == 'C')
            check_channels("tifffile", sizes[axis]);
        if (axes[axis] == 'T')
            check_frames("tifffile", sizes[axis]);
        long_axes += sizes[axis] > 1;
        if (__builtin_mul_overflow(found.slices, sizes[axis], &found.slices))
            throw Error(CLEFT_ERROR_FORMAT, "tifffile's 'shape' is damaged");
    }
    // Two axes of slices may be tiles, positions or channels. Their product is no third axis.
    if (long_axes > 1)
        throw Error(CLEFT_ERROR_FORMAT, "tifffile says that its shape is (" + shape.substr(0, 80) +
                                            "), which has more than three axes: save one volume by itself");
    return found;
}

}  // namespace

std::string plain_unit(const std::string& unit)
{
    std::string plain = unit;
    // Escapes of ImageJ and XML, UTF-8 of the micro sign and of the Greek letter, and Latin-1.
    for (const char* micro : {"\\u00B5", "\\u00b5", "&#181;", "&#xB5;", "&#xb5;", "\xc2\xb5", "\xce\xbc", "\xb5"})
        replace_all(plain, micro, "u");
    if (plain == "micron" || plain == "microns" || plain == "micrometer" || plain == "micrometre")
        return "um";
    std::string kept;
    for (const char c : plain.substr(0, 20))
        if (c > ' ' && c < 127)
            kept += c;
    return kept;
}

TiffDescription tiff_description(const std::string& text, const TiffPageSize& page)
{
    // SCIFIO writes ImageJ's form under its own name.
    if (text.compare(0, 7, "ImageJ=") == 0 || text.compare(0, 7, "SCIFIO=") == 0)
        return imagej(text, page);
    if (text.find("<OME") != std::string::npos || text.find("openmicroscopy.org/Schemas/OME") != std::string::npos)
        return ome(text);
    if (text.compare(0, 7, "shape=(") == 0)
        return tifffile_shape(between(text, "shape=(", ')'), "", page);
    const std::string shape = between(text, "\"shape\": [", ']');
    return shape.empty() ? TiffDescription{} : tifffile_shape(shape, between(text, "\"axes\": \"", '"'), page);
}

}  // namespace cleft::io
