// Reads stacks of TIFF pages, whole or not at all. libtiff decodes; what the pages are is judged here.
#include "io/image_readers.hpp"

#include "base/error.hpp"
#include "base/ordinal.hpp"
#include "io/packed_bits.hpp"
#include "io/tiff_description.hpp"
#include "io/tiff_page.hpp"
#include "io/voxel_data.hpp"

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <utility>
#include <vector>

namespace cleft::io
{

namespace
{

struct Stack {
    TiffDirectories directories;
    std::vector<TiffPage> pages;  // the slices
    std::vector<size_t> numbers;  // of the directories that they are
    TiffDescription description;
    std::vector<std::string> notes;
    size_t passed_over = 0;

    int64_t slices = 0;       // more than there are pages where voxels follow those of the only page
    uint64_t raw_offset = 0;  // where these voxels begin; 0: each slice has its page
};

std::string page_name(size_t directory) { return "the " + ordinal(static_cast<int64_t>(directory)) + " page"; }

// Files of programs that keep channels or slices where TIFF itself knows of none.
// Private tags by which the files of these microscopes are known. Their slices or channels lie
// where the pages do not tell.
void check_program(const TiffDirectory& directory)
{
    constexpr uint16_t kZeiss = 34412;
    constexpr uint16_t kMetamorph = 33629;
    constexpr uint16_t kOlympus = 34361;
    if (directory.has(kZeiss))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it is an LSM file of Zeiss: save its labels as a plain TIFF stack");
    // UIC2: its count is the number of planes, which all lie behind one page.
    if (directory.count(kMetamorph) > 1)
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it is an STK file of MetaMorph: save its labels as a plain TIFF stack");
    if (directory.has(kOlympus))
        throw Error(CLEFT_ERROR_UNSUPPORTED, "it is a FluoView file of Olympus: save its labels as a plain TIFF stack");
}

// A page of another size is another picture: an overview, a label of the slide, or a lower level of
// a pyramid.
void check_same(const TiffPage& page, const TiffPage& first)
{
    const auto size = [](const TiffPage& p) { return std::to_string(p.width) + " x " + std::to_string(p.height); };
    if (page.width != first.width || page.height != first.height)
        throw Error(CLEFT_ERROR_FORMAT,
                    page.name + " has " + size(page) + " voxels, but " + first.name + " has " + size(first));
    if (page.component != first.component || page.bits != first.bits || page.white_is_zero != first.white_is_zero)
        throw Error(CLEFT_ERROR_FORMAT, page.name + " has another type of voxels than " + first.name);
}

TiffPageSize size_of_page(const TiffFile& file, const TiffPage& page)
{
    float x = 0;
    float y = 0;
    // The default of TIFF 6.0, section 8, where ResolutionUnit is missing.
    uint16_t unit = RESUNIT_INCH;
    TIFFGetField(file.handle(), TIFFTAG_XRESOLUTION, &x);
    TIFFGetField(file.handle(), TIFFTAG_YRESOLUTION, &y);
    TIFFGetField(file.handle(), TIFFTAG_RESOLUTIONUNIT, &unit);
    return {page.width, page.height, x, y, unit};
}

void read_first(TiffFile& file, const TiffDirectory& directory, const TiffPage& page, Stack& stack)
{
    constexpr uint16_t kGeoScale = 33550;
    const char* text = nullptr;
    // Programs describe the whole file in the first page alone.
    if (TIFFGetField(file.handle(), TIFFTAG_IMAGEDESCRIPTION, &text) && text)
        stack.description = tiff_description(text, size_of_page(file, page));
    // PhotometricInterpretation 0 of TIFF 6.0 is about display. Label maps of bits by some programs
    // have it.
    if (page.white_is_zero)
        stack.notes.emplace_back("it says that 0 is white (MinIsWhite): the labels are the numbers in the file");
    if (page.compression == COMPRESSION_JPEG)
        stack.notes.emplace_back("it is compressed by JPEG, which changes labels");
    // Orientation of TIFF 6.0 turns the picture for display. Few programs follow it, so following
    // it here would mirror their labels.
    if (directory.value(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT) != ORIENTATION_TOPLEFT)
        stack.notes.emplace_back("its orientation, number " +
                                 std::to_string(directory.value(TIFFTAG_ORIENTATION, ORIENTATION_TOPLEFT)) +
                                 ", is not used: rows and columns are in the order of the file");
    if (directory.has(kGeoScale))
        stack.notes.emplace_back("the scale of its map (GeoTIFF) is not used: voxels are unit cubes");
}

void add_page(TiffFile& file, size_t number, Stack& stack)
{
    const TiffDirectory& directory = stack.directories.list[number];
    check_program(directory);
    // NewSubfileType of TIFF 6.0: bit 0 a reduced-resolution image, bit 2 a transparency mask.
    if (directory.is_thumbnail() || directory.is_mask()) {
        ++stack.passed_over;
        return;
    }
    const TiffPage page = tiff_page(file, directory, stack.directories.file_bytes, page_name(number));
    // Taken after each page, so that the warning is about the right one. The first suffices.
    const std::string doubt = file.take_messages().warning;
    if (!doubt.empty() && stack.notes.empty())
        stack.notes.push_back("libtiff says of " + page.name + ": '" + doubt + "'");
    if (stack.pages.empty())
        read_first(file, directory, page, stack);
    else
        check_same(page, stack.pages.front());
    stack.pages.push_back(page);
    stack.numbers.push_back(number);
}

// Pages that share their bytes could claim any number of voxels.
void check_claim(const Stack& stack)
{
    // Each strip was checked against the file alone. Many pages whose strips are the same bytes
    // could still claim terabytes.
    double least = 0;
    for (const TiffPage& page : stack.pages)
        least += static_cast<double>(page.row_bytes()) * static_cast<double>(page.height) / most_expansion(page);
    if (least > static_cast<double>(stack.directories.file_bytes))
        throw Error(CLEFT_ERROR_FORMAT, "its pages claim more voxels than its bytes can hold");
}

// The end of the voxels of the page that libtiff is at, if they lie in one piece; else 0.
uint64_t end_of_voxels(const TiffFile& file)
{
    uint64_t at = TIFFGetStrileOffset(file.handle(), 0);
    for (uint32_t strip = 0; strip < TIFFNumberOfStrips(file.handle()); ++strip) {
        // Strips in another order, or with gaps, would make the place of the next slice a guess.
        if (TIFFGetStrileOffset(file.handle(), strip) != at)
            return 0;
        at += TIFFGetStrileByteCount(file.handle(), strip);
    }
    return at;
}

// ImageJ writes stacks above 4 GB, and tifffile some, as one page behind whose voxels those of the other slices lie.
// Classic TIFF has offsets of 32 bits, so a stack above 4 GB cannot have a page for each slice.
// ImageJ then writes one page and all voxels in a row.
void find_raw_slices(const TiffFile& file, Stack& stack)
{
    const TiffPage& page = stack.pages.front();
    // The slices behind follow no strips of their own, so they must be stored as they are in
    // memory.
    const bool plain = page.compression == COMPRESSION_NONE && !page.tiled &&
                       stack.directories.list[stack.numbers.front()].value(TIFFTAG_FILLORDER, 1) == FILLORDER_MSB2LSB;
    const uint64_t slice = page.row_bytes() * static_cast<uint64_t>(page.height);
    const uint64_t end = plain ? end_of_voxels(file) : 0;
    const uint64_t left = end == 0 ? 0 : stack.directories.file_bytes - end;
    const auto more = static_cast<uint64_t>(stack.description.slices - 1);
    const std::string says = stack.description.who + " says that it has " + std::to_string(stack.description.slices) +
                             " slices, but it has one page";
    // Division, not a product: the number of slices in the text may be any.
    if (left / slice >= more) {
        stack.slices = stack.description.slices;
        stack.raw_offset = end - slice;
    } else if (left >= slice) {
        throw Error(CLEFT_ERROR_FORMAT, says + " and too few bytes behind it: the file is cut short");
    } else {
        stack.notes.push_back(says + ", which is read as one slice");
    }
}

void settle_slices(const TiffFile& file, Stack& stack)
{
    stack.slices = static_cast<int64_t>(stack.pages.size());
    const int64_t said = stack.description.slices;
    // Descriptions outlive the stack they were made for: after cropping to one page many programs
    // keep the text.
    if (said <= 1 || said == stack.slices)
        return;
    if (stack.slices != 1)
        throw Error(CLEFT_ERROR_FORMAT, stack.description.who + " says that it has " + std::to_string(said) +
                                            " slices, but it has " + std::to_string(stack.slices) + " pages");
    find_raw_slices(file, stack);
}

// Goes through all pages and back to the first slice.
void find_slices(TiffFile& file, Stack& stack)
{
    for (size_t number = 0; number < stack.directories.list.size(); ++number) {
        if (number > 0)
            file.next_page(page_name(number));
        add_page(file, number, stack);
    }
    if (stack.pages.empty())
        throw Error(CLEFT_ERROR_FORMAT, "all of its pages say that they are smaller copies or masks of others");
    if (stack.passed_over > 0)
        stack.notes.push_back(std::to_string(stack.passed_over) + " of its " +
                              std::to_string(stack.directories.list.size()) +
                              " pages are smaller copies or masks of others (NewSubfileType), and not read");
    check_claim(stack);
    // libtiff knows pages by walking the chain only.
    file.first_page();
    for (size_t number = 0; number < stack.numbers.front(); ++number)
        file.next_page(page_name(number + 1));
    settle_slices(file, stack);
}

// 0.1 x 0.1 x 0.3
std::string text_of(const Vector3& spacing)
{
    char text[100];
    std::snprintf(text, sizeof text, "%g x %g x %g", spacing[0], spacing[1], spacing[2]);
    return text;
}

void set_spacing(const Stack& stack, Image& image)
{
    const TiffDescription& said = stack.description;
    if (!said.has_spacing)
        return;
    image.spacing = said.spacing;
    std::string guess;
    if (!said.knows_third && stack.slices == 1)
        image.spacing[2] = image.spacing[0];
    else if (!said.knows_third)
        guess = ", of which it does not give the last";
    // Unit cubes are what is read without a description, too, so nothing need be reported.
    if (image.spacing != Vector3{1, 1, 1})
        image.notes.push_back(said.who + "'s size of voxels, " + text_of(image.spacing) +
                              (said.unit.empty() ? "" : " " + said.unit) + guess + ", is used");
}

void read_raw_slices(const std::string& path, const Stack& stack, Image& image)
{
    const TiffPage& page = stack.pages.front();
    // libtiff has no call that reads behind the strips of a page.
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    bool whole = file && fseeko(file.get(), static_cast<off_t>(stack.raw_offset), SEEK_SET) == 0;
    if (page.bits >= 8) {
        whole = whole && std::fread(image.voxels.get(), 1, image.bytes(), file.get()) == image.bytes();
        if (stack.directories.big_endian)
            swap_bytes(image);
    } else {
        std::vector<unsigned char> row(page.row_bytes());
        for (int64_t r = 0; whole && r < image.dims[1] * image.dims[2]; ++r) {
            whole = std::fread(row.data(), 1, row.size(), file.get()) == row.size();
            unpack_bits(row.data(), page.bits, page.width, image.voxels.get() + r * page.width);
        }
    }
    if (!whole)
        throw Error(CLEFT_ERROR_FILE, "its voxels cannot be read");
}

void read_pages(TiffFile& file, const Stack& stack, Image& image)
{
    size_t at = stack.numbers.front();  // where libtiff is
    for (size_t s = 0; s < stack.pages.size(); ++s) {
        for (; at < stack.numbers[s]; ++at)
            file.next_page(page_name(at + 1));
        read_tiff_page(file, stack.pages[s], image.voxels.get() + s * stack.pages[s].voxel_bytes());
    }
}

}  // namespace

bool is_tiff(const FileHead& head)
{
    using namespace std::string_view_literals;
    // TIFF 6.0, section 2: byte order and the number 42. 43 is BigTIFF.
    for (const std::string_view mark : {"II*\0"sv, "MM\0*"sv, "II+\0"sv, "MM\0+"sv})
        if (!head.gzip && head.begins_with(mark))
            return true;
    return false;
}

Image read_tiff(const std::string& path, const FileHead&)
{
    // libtiff needs memory for its tables beside the strips; 256 MB are more than any page needs.
    constexpr uint64_t kSlack = uint64_t{1} << 28;
    Stack stack;
    stack.directories = tiff_directories(path);
    TiffFile file(path, stack.directories.file_bytes + kSlack);
    find_slices(file, stack);
    Image image;
    const TiffPage& first = stack.pages.front();
    image.dims = {first.width, first.height, stack.slices};
    image.component = first.component;
    image.notes = stack.notes;
    image.notes.insert(image.notes.end(), stack.description.notes.begin(), stack.description.notes.end());
    set_spacing(stack, image);
    allocate_voxels(image);
    if (stack.raw_offset != 0)
        read_raw_slices(path, stack, image);
    else
        read_pages(file, stack, image);
    return image;
}

}  // namespace cleft::io
