// Each call has a compressor of its own: those of libdeflate are for one thread at a time.
#include "io/packed_bytes.hpp"

#include "io/byte_source.hpp"

#include <libdeflate.h>
#include <memory>
#include <new>

namespace cleft::io
{

namespace
{

struct FreePacker {
    void operator()(libdeflate_compressor* c) const { libdeflate_free_compressor(c); }
    void operator()(libdeflate_decompressor* d) const { libdeflate_free_decompressor(d); }
};

using Unpacker = std::unique_ptr<libdeflate_decompressor, FreePacker>;

Unpacker make_unpacker()
{
    Unpacker unpacker(libdeflate_alloc_decompressor());
    if (!unpacker)
        throw std::bad_alloc();
    return unpacker;
}

}  // namespace

std::string packed_bytes(std::string_view bytes, Wrapping wrapping, int level)
{
    const std::unique_ptr<libdeflate_compressor, FreePacker> packer(libdeflate_alloc_compressor(level));
    if (!packer)
        throw std::bad_alloc();
    const bool gzip = wrapping == Wrapping::gzip;
    const auto bound = gzip ? libdeflate_gzip_compress_bound : libdeflate_zlib_compress_bound;
    const auto compress = gzip ? libdeflate_gzip_compress : libdeflate_zlib_compress;
    std::string packed(bound(packer.get(), bytes.size()), '\0');
    packed.resize(compress(packer.get(), bytes.data(), bytes.size(), packed.data(), packed.size()));
    return packed;
}

bool unpack_zlib(std::string_view packed, char* to, size_t bytes)
{
    // Without a place for the number of bytes written, any other number than `bytes` is a failure.
    return libdeflate_zlib_decompress(make_unpacker().get(), packed.data(), packed.size(), to, bytes, nullptr) ==
           LIBDEFLATE_SUCCESS;
}

std::optional<std::string> unpacked_deflate(std::string_view packed)
{
    const Unpacker unpacker = make_unpacker();
    constexpr size_t kLeastRoom = 1000;
    // Most data pack to a third or a quarter, so the first guess mostly suffices. The bound is the ratio that deflate
    // cannot exceed.
    for (size_t room = 8 * packed.size() + kLeastRoom;; room *= 4) {
        std::string data(room, '\0');
        size_t size = 0;
        const libdeflate_result result =
            libdeflate_deflate_decompress(unpacker.get(), packed.data(), packed.size(), data.data(), room, &size);
        if (result == LIBDEFLATE_SUCCESS) {
            data.resize(size);
            return data;
        }
        if (result != LIBDEFLATE_INSUFFICIENT_SPACE || room > kGreatestDeflateRatio * packed.size() + kLeastRoom)
            return std::nullopt;
    }
}

}  // namespace cleft::io
