// Reads grey JPEG pictures by libjpeg. What libjpeg would mend with a warning is refused.
#include "base/error.hpp"
#include "io/image_readers.hpp"
#include "io/system_failure.hpp"

#include <jpeglib.h>
#include <csetjmp>
#include <cstddef>
#include <cstdio>
#include <memory>

namespace cleft::io
{

namespace
{

// What libjpeg's calls share. They are left by longjmp, which passes over destructors: so the functions that call
// libjpeg have none to run.
struct JpegDecoder {
    jpeg_decompress_struct jpeg{};
    jpeg_error_mgr errors{};
    jpeg_progress_mgr progress{};
    std::jmp_buf leave{};
    char message[JMSG_LENGTH_MAX] = {};

    JpegDecoder() = default;
    JpegDecoder(const JpegDecoder&) = delete;
    JpegDecoder& operator=(const JpegDecoder&) = delete;
    // Also of one that was never made, or made in part: jpeg_create_decompress() may fail after it took memory.
    ~JpegDecoder() { jpeg_destroy_decompress(&jpeg); }
};

[[noreturn]] void leave(j_common_ptr jpeg)
{
    auto* decoder = static_cast<JpegDecoder*>(jpeg->client_data);
    (*jpeg->err->format_message)(jpeg, decoder->message);
    std::longjmp(decoder->leave, 1);
}

// Warnings (level -1) tell of data that are made up; higher levels are remarks.
void keep_message(j_common_ptr jpeg, int level)
{
    if (level < 0)
        leave(jpeg);
}

void print_nothing(j_common_ptr) {}

// A file of many scans over many voxels would be decoded for hours.
void check_scans(j_common_ptr jpeg)
{
    // The authors of libjpeg-turbo advise such a limit against hostile files. Progressive files
    // have about ten scans.
    constexpr int kMostScans = 500;
    if (reinterpret_cast<j_decompress_ptr>(jpeg)->input_scan_number <= kMostScans)
        return;
    auto* decoder = static_cast<JpegDecoder*>(jpeg->client_data);
    std::snprintf(decoder->message, sizeof decoder->message, "more than %d scans", kMostScans);
    std::longjmp(decoder->leave, 1);
}

bool read_jpeg_header(JpegDecoder& decoder, std::FILE* file)
{
    // libjpeg's default error handler calls exit(). It is replaced before the first call that may
    // fail.
    if (setjmp(decoder.leave))
        return false;
    decoder.jpeg.err = jpeg_std_error(&decoder.errors);
    decoder.jpeg.client_data = &decoder;
    decoder.errors.error_exit = leave;
    decoder.errors.emit_message = keep_message;
    decoder.errors.output_message = print_nothing;
    // It clears the struct but keeps `err` and `client_data`, so both may be set before it.
    jpeg_create_decompress(&decoder.jpeg);
    decoder.progress.progress_monitor = check_scans;
    decoder.jpeg.progress = &decoder.progress;
    jpeg_stdio_src(&decoder.jpeg, file);
    jpeg_read_header(&decoder.jpeg, TRUE);
    return true;
}

bool read_rows(JpegDecoder& decoder, std::byte* voxels)
{
    if (setjmp(decoder.leave))
        return false;
    jpeg_start_decompress(&decoder.jpeg);
    while (decoder.jpeg.output_scanline < decoder.jpeg.output_height) {
        auto* row = reinterpret_cast<JSAMPROW>(voxels) +
                    static_cast<size_t>(decoder.jpeg.output_scanline) * decoder.jpeg.output_width;
        jpeg_read_scanlines(&decoder.jpeg, &row, 1);
    }
    jpeg_finish_decompress(&decoder.jpeg);
    return true;
}

[[noreturn]] void damaged(const JpegDecoder& decoder)
{
    // Want of memory comes as one of libjpeg's errors, too.
    check_for_want_of_memory();
    throw Error(CLEFT_ERROR_FORMAT, std::string("it is damaged or cut short (libjpeg: '") + decoder.message + "')");
}

void check_jpeg(const JpegDecoder& decoder, uintmax_t file_bytes)
{
    constexpr double kMostExpansion = 4096;  // a block of 64 voxels takes about a bit
    // Three components are colours and four are print colours. Grey has one, whatever JFIF or Adobe
    // markers say.
    if (decoder.jpeg.num_components != 1)
        throw Error(CLEFT_ERROR_FORMAT, "it has " + std::to_string(decoder.jpeg.num_components) +
                                            " numbers a voxel (colours); one is wanted");
    if (static_cast<double>(decoder.jpeg.image_width) * decoder.jpeg.image_height >
        kMostExpansion * static_cast<double>(file_bytes))
        throw Error(CLEFT_ERROR_FORMAT, "it claims more voxels than its bytes can hold");
}

}  // namespace

bool is_jpeg(const FileHead& head) { return !head.gzip && head.begins_with("\xff\xd8"); }

Image read_jpeg(const std::string& path, const FileHead& head)
{
    // The file is held by a smart pointer here, outside of the functions that longjmp() leaves.
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        throw_system_failure("it cannot be opened", errno);
    JpegDecoder decoder;
    forget_want_of_memory();
    if (!read_jpeg_header(decoder, file.get()))
        damaged(decoder);
    check_jpeg(decoder, head.size);
    Image image;
    image.dims = {decoder.jpeg.image_width, decoder.jpeg.image_height, 1};
    allocate_voxels(image);
    if (!read_rows(decoder, image.voxels.get()))
        damaged(decoder);
    // Quantization changes numbers near the boundaries of labels, even at the highest quality.
    image.notes.emplace_back("it is compressed by JPEG, which changes labels");
    return image;
}

}  // namespace cleft::io
