// Writes PNG: a header, the filtered and compressed rows, an end. The rows are compressed by libdeflate, as all that is
// written is, on all threads. libpng, which reads such files, would report failures by long jumps.
#include "io/write_png.hpp"

#include "base/parallel.hpp"
#include "io/atomic_file.hpp"
#include "io/zlib_stream.hpp"

#include <libdeflate.h>
#include <algorithm>
#include <cstdlib>

namespace cleft::io
{

namespace
{

constexpr int kPngLevel =
    9;  // half as long again as the default, for a tenth less of a file that is looked at many times
constexpr int kFilters = 5;

// Of PNG, with the left, the upper and the upper left byte.
uint8_t paeth(int a, int b, int c)
{
    const int p = a + b - c;
    const int pa = std::abs(p - a), pb = std::abs(p - b), pc = std::abs(p - c);
    return static_cast<uint8_t>(pa <= pb && pa <= pc ? a : pb <= pc ? b : c);
}

uint8_t predicted(int filter, uint8_t left, uint8_t above, uint8_t diagonal)
{
    switch (filter) {
        case 1:
            return left;
        case 2:
            return above;
        case 3:
            return static_cast<uint8_t>((left + above) / 2);
        case 4:
            return paeth(left, above, diagonal);
        default:
            return 0;
    }
}

Array<uint8_t> row_of(const Canvas& canvas, int y, bool has_cover)
{
    Array<uint8_t> row;
    row.reserve(int64_t{canvas.width} * (has_cover ? 4 : 3));
    for (int x = 0; x < canvas.width; ++x) {
        const Pixel& pixel = canvas.pixels[canvas.at(x, y)];
        row.insert(row.end(), {pixel.colour.red, pixel.colour.green, pixel.colour.blue});
        if (has_cover)
            row.push_back(pixel.cover);
    }
    return row;
}

// The row with the filter whose differences are least, as the specification advises.
Array<uint8_t> filtered(const Array<uint8_t>& row, const Array<uint8_t>& above, int pixel_bytes)
{
    Array<uint8_t> best, line;
    int64_t least = INT64_MAX;
    for (int filter = 0; filter < kFilters; ++filter) {
        line.assign(1, static_cast<uint8_t>(filter));
        int64_t sum = 0;
        for (int64_t i = 0; i < row.count(); ++i) {
            const bool has_left = i >= pixel_bytes;
            const uint8_t guess = predicted(filter, has_left ? row[i - pixel_bytes] : uint8_t{0}, above[i],
                                            has_left ? above[i - pixel_bytes] : uint8_t{0});
            line.push_back(static_cast<uint8_t>(row[i] - guess));
            sum += std::abs(static_cast<int8_t>(line.back()));
        }
        if (sum < least) {
            least = sum;
            best.swap(line);
        }
    }
    return best;
}

Array<uint8_t> filtered_rows(const Canvas& canvas, bool has_cover, const Run& run)
{
    const int pixel_bytes = has_cover ? 4 : 3;
    const int64_t row_bytes = int64_t{canvas.width} * pixel_bytes;
    Array<uint8_t> out(canvas.height * (row_bytes + 1));
    constexpr int64_t kRowsFiltered = 16;  // a chunk
    parallel_for(run, canvas.height, kRowsFiltered, [&](int64_t begin, int64_t end) {
        Array<uint8_t> above =
            begin > 0 ? row_of(canvas, static_cast<int>(begin) - 1, has_cover) : Array<uint8_t>(row_bytes);
        for (int64_t y = begin; y < end; ++y) {
            Array<uint8_t> row = row_of(canvas, static_cast<int>(y), has_cover);
            const Array<uint8_t> line = filtered(row, above, pixel_bytes);
            std::copy(line.begin(), line.end(), out.begin() + y * (row_bytes + 1));
            above.swap(row);
        }
    });
    return out;
}

// Most significant byte first.
std::string big_endian(uint32_t number)
{
    std::string bytes;
    for (int shift = 24; shift >= 0; shift -= 8)
        bytes += static_cast<char>(number >> shift & 0xFFU);
    return bytes;
}

void write_chunk(AtomicFile& file, const std::string& name, const std::string& data)
{
    const uint32_t sum = libdeflate_crc32(libdeflate_crc32(0, name.data(), name.size()), data.data(), data.size());
    file.print(big_endian(static_cast<uint32_t>(data.size())), name, data, big_endian(sum));
}

}  // namespace

void write_png(const std::string& path, const Canvas& canvas, bool has_cover, const Run& run)
{
    AtomicFile file(path);
    file.print("\x89PNG\r\n\x1a\n");
    std::string header =
        big_endian(static_cast<uint32_t>(canvas.width)) + big_endian(static_cast<uint32_t>(canvas.height));
    // Eight bits, colours with or without opacity; the one way to compress and to filter; no interlacing.
    header += {8, static_cast<char>(has_cover ? 6 : 2), 0, 0, 0};
    write_chunk(file, "IHDR", header);
    const Array<uint8_t> rows = filtered_rows(canvas, has_cover, run);
    write_chunk(file, "IDAT", zlib_stream(run, rows.data(), to_size(rows.count()), kPngLevel));
    write_chunk(file, "IEND", "");
    // The last chance to cancel.
    run.report(1);
    file.commit();
}

}  // namespace cleft::io
