// Unpacks the pixels of DICOM files: plain ones of 1 to 32 bits, floating-point ones, and those packed by run lengths.
#include "io/dicom_pixels.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/dicom_compressed.hpp"
#include "io/voxel_access.hpp"

#include <algorithm>

namespace cleft::io
{

namespace
{

// Float Pixel Data and Double Float Pixel Data, which stand in the place of Pixel Data in parametric maps (PS3.3,
// sections C.7.6.24 and C.7.6.25).
constexpr DicomTag kFloatPixelsTag = 0x7FE00008u;
constexpr DicomTag kDoublePixelsTag = 0x7FE00009u;

// The element decides before Bits Allocated: float pixels have 32 bits, as integers may have.
Component component_of(const DicomFile& file, const DicomPixelFormat& format)
{
    if (file.data.has(kFloatPixelsTag))
        return Component::float32;
    if (file.data.has(kDoublePixelsTag))
        return Component::float64;
    switch (format.bits_allocated) {
        case 1:
        case 8:
            return format.is_signed ? Component::int8 : Component::uint8;
        case 16:
            return format.is_signed ? Component::int16 : Component::uint16;
        case 32:
            return format.is_signed ? Component::int32 : Component::uint32;
        default:
            refuse_dicom("its pixels have " + std::to_string(format.bits_allocated) + " bits, which cannot be read");
    }
}

// Bytes in words of 16 bits, of which the high byte comes first.
// PS3.5, section 8.1.1 and annex A.3: in Big Endian, OW swaps the two bytes of each word, also
// where pixels have 8 bits or one.
std::string pairs_swapped(std::string_view bytes)
{
    std::string swapped(bytes);
    for (size_t at = 0; at + 1 < swapped.size(); at += 2)
        std::swap(swapped[at], swapped[at + 1]);
    return swapped;
}

// Bits follow each other without gaps, also from one frame to the next, the first pixel in the lowest bit.
// PS3.5, section 8.1.1 and annex D: frames of one bit are packed without padding between them.
void unpack_single_bits(std::string_view bytes, Image& image)
{
    for (int64_t v = 0; v < image.field_size(); ++v) {
        const auto byte = static_cast<unsigned char>(bytes[static_cast<size_t>(v / 8)]);
        image.voxels[static_cast<size_t>(v)] = static_cast<std::byte>(byte >> (v % 8) & 1);
    }
}

void copy_plain(std::string_view bytes, bool big_endian, Image& image)
{
    std::memcpy(image.voxels.get(), bytes.data(), image.bytes());
    const size_t size = size_of(image.component);
    if (big_endian && size > 1)
        for (std::byte* at = image.voxels.get(); at < image.voxels.get() + image.bytes(); at += size)
            std::reverse(at, at + size);
}

// One plane of bytes packed by run lengths, each byte `step` behind the last.
// PackBits as PS3.5, annex G.3 has it. After a code n >= 0 follow n + 1 bytes as they are. After a
// code -n follows one byte, which stands for n + 1.
void unpack_runs(std::string_view packed, std::byte* to, size_t step, int64_t count)
{
    size_t at = 0;
    while (count > 0) {
        if (at >= packed.size())
            refuse_dicom("the DICOM file is damaged: its packed pixels end too early");
        const auto code = static_cast<signed char>(packed[at++]);
        // For -128 the decoder of PS3.5, annex G.3.2 puts out nothing.
        if (code == -128)
            continue;
        // A damaged run may go beyond the plane: what is too much is dropped.
        const int64_t length = std::min<int64_t>(code >= 0 ? code + 1 : 1 - code, count);
        const size_t wanted = code >= 0 ? static_cast<size_t>(length) : 1;
        if (packed.size() - at < wanted)
            refuse_dicom("the DICOM file is damaged: its packed pixels end too early");
        for (int64_t i = 0; i < length; ++i, to += step)
            *to = static_cast<std::byte>(packed[at + (code >= 0 ? static_cast<size_t>(i) : 0)]);
        at += code >= 0 ? static_cast<size_t>(code) + 1 : 1;
        count -= length;
    }
}

// Two bytes make 128 at most: no memory is taken for a claim that cannot be true.
void check_packed(const std::vector<std::string_view>& fragments, int64_t wanted)
{
    // A code and a byte become 128 bytes.
    constexpr int64_t kGreatestRatio = 64;
    int64_t there = 0;
    for (const std::string_view fragment : fragments)
        there += static_cast<int64_t>(fragment.size());
    if (wanted / kGreatestRatio > there)
        refuse_dicom("the DICOM file is damaged: its packed pixels have " + counted(there, "byte") + ", too few for " +
                     std::to_string(wanted));
}

// One fragment a frame: a head of 16 numbers (how many planes, where each begins), then the planes, high bytes first.
void unpack_frames(const std::vector<std::string_view>& fragments, const DicomPixelFormat& format, Image& image)
{
    // PS3.5, annex G.2: the bytes of each pixel are taken apart into segments, the most significant
    // byte first.
    const size_t planes = size_of(image.component);
    // PS3.5, annex A.4.2: each frame is one fragment. The first item is the Basic Offset Table,
    // which may be empty and is not needed.
    if (static_cast<int64_t>(fragments.size()) != format.frames + 1 || format.bits_allocated % 8 != 0)
        refuse_dicom("its packed pixels are not one piece a frame, which cannot be read");
    for (size_t f = 0; f + 1 < fragments.size(); ++f) {
        const std::string_view fragment = fragments[f + 1];
        // The RLE header of PS3.5, annex G.5: 16 numbers of 32 bits, little-endian, as this syntax
        // always is.
        std::array<uint32_t, 16> head{};
        if (fragment.size() < sizeof head)
            refuse_dicom("the DICOM file is damaged: its packed pixels have no head");
        std::memcpy(head.data(), fragment.data(), sizeof head);
        if (head[0] != planes)
            refuse_dicom("the DICOM file is damaged: its packed pixels have " + std::to_string(head[0]) +
                         " planes of bytes");
        std::byte* const frame = image.voxels.get() + f * static_cast<size_t>(format.frame_size()) * planes;
        for (size_t plane = 0; plane < planes; ++plane) {
            if (head[plane + 1] > fragment.size())
                refuse_dicom("the DICOM file is damaged: a plane of its packed pixels lies beyond them");
            unpack_runs(fragment.substr(head[plane + 1]), frame + (planes - 1 - plane), planes, format.frame_size());
        }
    }
}

// Bits above and below those that are stored may hold anything.
void clear_unused_bits(const DicomPixelFormat& format, bool compressed, Image& image)
{
    // PS3.5, section 8.1.1. Overlays were stored in the unused bits until 2004, and some scanners
    // leave noise there.
    const int64_t unused = format.bits_allocated - format.bits_stored;
    // Decoders of compressed pixels give the stored bits in the lowest places. In plain pixels they
    // end at High Bit.
    const int64_t above = compressed ? unused : format.bits_allocated - 1 - format.high_bit;
    if (unused <= 0 || is_floating(image.component))
        return;
    with_type(image.component, [&](auto zero) {
        using T = decltype(zero);
        if constexpr (std::is_integral_v<T> && sizeof(T) <= sizeof(int32_t)) {
            using Bits = std::make_unsigned_t<T>;
            for (int64_t v = 0; v < image.field_size(); ++v) {
                // Shifted up, and down again in the pixel's own type: a signed type extends the
                // sign of the highest stored bit.
                const auto bits = static_cast<Bits>(static_cast<uint32_t>(load<Bits>(image.voxels.get(), v)) << above);
                store<T>(image.voxels.get(), v, static_cast<T>(static_cast<T>(bits) >> unused));
            }
        }
    });
}

const DicomElement& pixels_element(const DicomData& data)
{
    const DicomTag tag = data.has(kFloatPixelsTag)    ? kFloatPixelsTag
                         : data.has(kDoublePixelsTag) ? kDoublePixelsTag
                                                      : kPixelsTag;
    const DicomElement* const element = data.find(tag);
    if (!element)
        refuse_dicom("the DICOM file holds no image");
    return *element;
}

// Of all frames without gaps.
int64_t bytes_of(const DicomPixelFormat& format, Component component)
{
    const int64_t bits = format.bits_allocated == 1 ? 1 : 8 * static_cast<int64_t>(size_of(component));
    // Rows and columns have 16 bits and frames 20, so that the product fits 64 bits.
    return (format.frame_size() * format.frames * bits + 7) / 8;
}

// Pixels that are neither packed nor compressed.
void read_plain(const DicomElement& element, const DicomPixelFormat& format, bool big_endian, Image& image)
{
    const int64_t wanted = bytes_of(format, image.component);
    const auto there = static_cast<int64_t>(element.bytes.size());
    // Longer is allowed: values are padded to an even length.
    if (there < wanted)
        refuse_dicom("the DICOM file is damaged: its pixels have " + counted(there, "byte") + ", and not " +
                     std::to_string(wanted));
    allocate_voxels(image);
    // Only pixels of at most 8 bits: in wider ones the swap of each pixel does it all.
    const std::string straight =
        element.in_words && big_endian && size_of(image.component) == 1 ? pairs_swapped(element.bytes) : std::string();
    const std::string_view bytes = straight.empty() ? element.bytes : straight;
    if (format.bits_allocated == 1)
        unpack_single_bits(bytes, image);
    else
        copy_plain(bytes, big_endian, image);
}

// PS3.5, section 8.1.1 requires High Bit to be Bits Stored - 1 today. Where it is not, the values depend on how one
// reads it, so the user gets a note.
void note_moved_bits(const DicomPixelFormat& format, Image& image)
{
    if (format.high_bit + 1 != format.bits_stored)
        image.notes.push_back("its pixels are the " + std::to_string(format.bits_stored) + " bits up to number " +
                              std::to_string(format.high_bit) + " of " + std::to_string(format.bits_allocated) +
                              " (HighBit), and are moved down");
}

}  // namespace

DicomPixelFormat pixel_format_of(const DicomFile& file)
{
    const DicomData& data = file.data;
    DicomPixelFormat format;
    format.rows = data.short_number(0x00280010u, 0);
    format.columns = data.short_number(0x00280011u, 0);
    format.bits_allocated = data.short_number(0x00280100u, 0);
    // Bits Stored and High Bit are required (type 1). Old files without them use all bits.
    format.bits_stored = data.short_number(0x00280101u, format.bits_allocated);
    format.high_bit = data.short_number(0x00280102u, format.bits_stored - 1);
    // Pixel Representation: 0 is unsigned, 1 two's complement.
    format.is_signed = data.short_number(0x00280103u, 0) == 1;
    const std::vector<double> frames = data.numbers(0x00280008u);
    if (!frames.empty())
        // The number is text (IS) and may be anything. A million frames are more than any object
        // has; the size of the pixels is checked afterwards.
        format.frames = static_cast<int64_t>(std::clamp(frames.front(), 0.0, 1e6));
    // Samples per Pixel: 3 in colours. A palette has one sample, whose number is the label.
    const int64_t samples = data.short_number(0x00280002u, 1);
    if (samples != 1)
        refuse_dicom("it has " + std::to_string(samples) + " numbers a voxel (colours or vectors); one is wanted");
    // All shifts below rely on this: 1 <= stored <= high + 1 <= allocated.
    if (format.bits_stored < 1 || format.bits_stored > format.high_bit + 1 || format.high_bit >= format.bits_allocated)
        refuse_dicom("the DICOM file is damaged: of " + std::to_string(format.bits_allocated) + " bits, " +
                     std::to_string(format.bits_stored) + " are stored up to bit " + std::to_string(format.high_bit));
    if (format.rows < 1 || format.columns < 1 || format.frames < 1)
        refuse_dicom("the DICOM file does not tell how many rows, columns and frames its image has");
    return format;
}

Image pixels_of(const DicomFile& file, const DicomPixelFormat& format)
{
    const DicomElement& element = pixels_element(file.data);
    // RLE Lossless. GDCM is not needed for it, so that builds without GDCM read it, too.
    const bool packed = element.encapsulated && file.transfer_syntax == "1.2.840.10008.1.2.5";
    const bool compressed = element.encapsulated && !packed;
    Image image;
    image.component = component_of(file, format);
    image.dims = {format.columns, format.rows, format.frames};
    if (compressed) {
        // The decoder in the child process tells its size first, and memory is taken then.
        read_compressed_pixels(file.path, image);
    } else if (packed) {
        check_packed(element.fragments, bytes_of(format, image.component));
        allocate_voxels(image);
        unpack_frames(element.fragments, format, image);
    } else {
        read_plain(element, format, file.data.is_big_endian(), image);
    }
    if (!compressed)
        note_moved_bits(format, image);
    if (format.bits_allocated > 1)
        clear_unused_bits(format, compressed, image);
    return image;
}

}  // namespace cleft::io
