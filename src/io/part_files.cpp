// Entries: label maps whose voxels are read part by part.
#include "base/struct_size.hpp"
#include "base/utf8.hpp"
#include "cleft/cleft_io_parts.h"
#include "io/create_volume.hpp"
#include "io/entry.hpp"
#include "io/raw_image.hpp"
#include "io/read_image.hpp"
#include "io/text_scanner.hpp"
#include "io/voxel_file.hpp"
#include "io/voxels.hpp"

#include <algorithm>
#include <cstring>
#include <memory>

// The size of the struct in version 0.1. Callers that were compiled with it stay valid when fields
// are added at the end.
template <>
inline constexpr size_t cleft::kFirstSize<cleft_voxels> = CLEFT_END_OF(cleft_voxels, read);

namespace cleft::io
{

namespace
{

// As much of the sentence as there is room for.
void copy_sentence(const char* from, char* sentence, int64_t room) noexcept
{
    if (!sentence || room < 1)
        return;
    const std::string_view beginning = beginning_of(from, static_cast<size_t>(room - 1));
    std::memcpy(sentence, beginning.data(), beginning.size());
    sentence[beginning.size()] = '\0';
}

int read_window(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                void* user) noexcept
{
    return status_of(
        [&] {
            const auto* file = static_cast<const VoxelFile*>(required(user, "user of the cleft_voxels"));
            file->read(required(first, "first"), required(count, "count"),
                       static_cast<std::byte*>(required(voxels, "voxels")));
        },
        [&](cleft_status status, const char* words) noexcept {
            copy_sentence(words, sentence, room);
            return status;
        });
}

StoredImage locate_labels(const std::string& path, const cleft_io_raw* raw)
{
    if (!raw)
        return naming_file(path, [&] { return locate_image(path); });
    const cleft_io_raw layout = checked_layout(raw);
    if (layout.kind == CLEFT_IO_KIND_INDICATORS)
        throw Error(CLEFT_ERROR_ARGUMENT,
                    "the kind of the cleft_io_raw is indicators, but only labels can be read by "
                    "parts");
    return locate_raw_image(path, layout);
}

std::array<double, 12> affine_in_lps(const std::string& path, const Image& image)
{
    cleft_io_reading reading{};
    reading.world = CLEFT_IO_WORLD_LPS;
    reading.scale = 1;
    return naming_file(path, [&] { return affine_of(image, reading); });
}

void open_voxels(cleft_context* context, const std::string& path, const cleft_io_raw* raw, cleft_voxels& out)
{
    check_struct_size(out, "cleft_voxels");
    StoredImage stored = locate_labels(path, raw);
    auto file = std::make_unique<VoxelFile>(path, stored);
    const std::array<double, 12> affine = affine_in_lps(path, stored.image);
    const std::string who = "'" + path + "': ";
    for (const std::string& note : stored.image.notes)
        report(context, who + note);
    cleft_voxels voxels{};
    voxels.type = type_of(file->label_type());
    std::copy(stored.image.dims.begin(), stored.image.dims.end(), voxels.dims);
    std::copy(affine.begin(), affine.end(), voxels.affine);
    voxels.read = read_window;
    voxels.user = file.release();
    copy_out(voxels, out);
}

}  // namespace

}  // namespace cleft::io

using namespace cleft::io;

cleft_status cleft_io_voxels_open(cleft_context* context, const char* path, const cleft_io_raw* raw,
                                  cleft_voxels* out) noexcept
{
    return entry(context, {}, [&] { open_voxels(context, required(path, "path"), raw, *required(out, "out")); });
}

void cleft_io_voxels_close(cleft_voxels* voxels) noexcept
{
    // Only our own structs have what is to be destroyed.
    if (!voxels || voxels->read != read_window)
        return;
    delete static_cast<VoxelFile*>(voxels->user);
    voxels->user = nullptr;
    voxels->read = nullptr;
}
