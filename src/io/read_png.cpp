// Reads PNG pictures of one number a pixel by libpng, whose messages are kept.
#include "base/error.hpp"
#include "io/byte_source.hpp"
#include "io/image_readers.hpp"
#include "io/system_failure.hpp"

#include <png.h>
#include <algorithm>
#include <cstdio>
#include <cstring>
#include <memory>
#include <vector>

namespace cleft::io
{

namespace
{

constexpr size_t kSignatureBytes = 8;  // PNG specification, section 5.2

// What libpng's calls share. libpng leaves them by longjmp, which passes over destructors: so the functions that call
// it have none to run.
struct PngDecoder {
    png_structp png = nullptr;
    png_infop info = nullptr;
    char error[200] = {};

    PngDecoder() = default;
    PngDecoder(const PngDecoder&) = delete;
    PngDecoder& operator=(const PngDecoder&) = delete;
    ~PngDecoder() { png_destroy_read_struct(&png, &info, nullptr); }
};

[[noreturn]] void keep_error(png_structp png, png_const_charp message)
{
    auto* decoder = static_cast<PngDecoder*>(png_get_error_ptr(png));
    std::snprintf(decoder->error, sizeof decoder->error, "%s", message);
    png_longjmp(png, 1);
}

// Warnings are of colour profiles, text and time, which do not concern the numbers. Damaged voxels
// are errors.
void drop_warning(png_structp, png_const_charp) {}

bool read_png_header(PngDecoder& decoder, std::FILE* file)
{
    if (setjmp(png_jmpbuf(decoder.png)))
        return false;
    png_init_io(decoder.png, file);
    // libpng refuses pictures above a million pixels a side by default. The true bound is the size
    // of the file, which check_png() uses.
    png_set_user_limits(decoder.png, PNG_UINT_31_MAX, PNG_UINT_31_MAX);
    png_read_info(decoder.png, decoder.info);
    return true;
}

bool read_rows(PngDecoder& decoder, png_bytepp rows)
{
    // Set in each function anew: a jump into a function that has returned is undefined.
    if (setjmp(png_jmpbuf(decoder.png)))
        return false;
    png_set_packing(decoder.png);  // numbers of 1, 2 and 4 bits as bytes, not stretched
    png_set_swap(decoder.png);     // to the order of this machine
    png_set_interlace_handling(decoder.png);
    png_read_update_info(decoder.png, decoder.info);
    png_read_image(decoder.png, rows);
    // Reads the chunks behind the picture, so that a file that is cut short there is noticed.
    png_read_end(decoder.png, nullptr);
    return true;
}

[[noreturn]] void damaged(const PngDecoder& decoder)
{
    check_for_want_of_memory();
    throw Error(CLEFT_ERROR_FORMAT, std::string("it is damaged or cut short (libpng: '") + decoder.error + "')");
}

void check_png(const PngDecoder& decoder, uintmax_t file_bytes)
{
    const int colour = png_get_color_type(decoder.png, decoder.info);
    // With a palette the number is the label and the colour is for the eye.
    if (colour != PNG_COLOR_TYPE_GRAY && colour != PNG_COLOR_TYPE_PALETTE)
        throw Error(CLEFT_ERROR_FORMAT,
                    "it has " + std::to_string(png_get_channels(decoder.png, decoder.info)) +
                        (colour == PNG_COLOR_TYPE_GRAY_ALPHA ? " numbers a voxel (grey and transparency)"
                                                             : " numbers a voxel (colours)") +
                        "; one is wanted");
    // IDAT is a zlib stream (PNG specification, section 10.1), so its expansion has a bound.
    const double decoded = static_cast<double>(png_get_rowbytes(decoder.png, decoder.info)) *
                           static_cast<double>(png_get_image_height(decoder.png, decoder.info));
    if (decoded > kGreatestDeflateRatio * static_cast<double>(file_bytes))
        throw Error(CLEFT_ERROR_FORMAT, "it claims more voxels than its bytes can hold");
}

// Of the chunks in the first bytes of the file, which begin behind the signature.
bool has_chunk(const FileHead& head, const char* type)
{
    const std::vector<unsigned char>& bytes = head.bytes;
    // A chunk is its length in four bytes, most significant first, its type, its data and a check
    // sum.
    for (size_t at = kSignatureBytes; at + 8 <= bytes.size();) {
        if (std::memcmp(&bytes[at + 4], type, 4) == 0)
            return true;
        const size_t length =
            size_t{bytes[at]} << 24 | size_t{bytes[at + 1]} << 16 | size_t{bytes[at + 2]} << 8 | size_t{bytes[at + 3]};
        at += length + 12;
    }
    return false;
}

}  // namespace

bool is_png(const FileHead& head)
{
    return !head.gzip && head.bytes.size() >= kSignatureBytes &&
           png_sig_cmp(head.bytes.data(), 0, kSignatureBytes) == 0;
}

Image read_png(const std::string& path, const FileHead& head)
{
    // Readers that do not know APNG show the first picture alone. Here the others may be the slices
    // that the user means.
    if (has_chunk(head, "acTL"))
        throw Error(CLEFT_ERROR_FORMAT, "it is an animation of several pictures (APNG)");
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        throw_system_failure("it cannot be opened", errno);
    PngDecoder decoder;
    forget_want_of_memory();
    decoder.png = png_create_read_struct(PNG_LIBPNG_VER_STRING, &decoder, keep_error, drop_warning);
    decoder.info = decoder.png ? png_create_info_struct(decoder.png) : nullptr;
    if (!decoder.info)
        throw std::bad_alloc();
    if (!read_png_header(decoder, file.get()))
        damaged(decoder);
    check_png(decoder, head.size);
    Image image;
    image.dims = {png_get_image_width(decoder.png, decoder.info), png_get_image_height(decoder.png, decoder.info), 1};
    // After check_png() the depth is 1, 2, 4, 8 or 16.
    image.component = png_get_bit_depth(decoder.png, decoder.info) == 16 ? Component::uint16 : Component::uint8;
    allocate_voxels(image);
    // png_read_image() wants a pointer for each row, and handles interlaced files with them.
    std::vector<png_bytep> rows(static_cast<size_t>(image.dims[1]));
    const size_t row_bytes = static_cast<size_t>(image.dims[0]) * size_of(image.component);
    for (size_t row = 0; row < rows.size(); ++row)
        rows[row] = reinterpret_cast<png_bytep>(image.voxels.get()) + row * row_bytes;
    if (!read_rows(decoder, rows.data()))
        damaged(decoder);
    return image;
}

}  // namespace cleft::io
