// Sizes of images in bytes, and memory for their voxels. Every reader takes its memory here, after
// the size was checked for overflow.
#include "io/image.hpp"

#include "base/error.hpp"

namespace cleft::io
{

size_t size_of(Component component)
{
    switch (component) {
        case Component::uint8:
        case Component::int8:
            return 1;
        case Component::uint16:
        case Component::int16:
            return 2;
        case Component::uint32:
        case Component::int32:
        case Component::float32:
            return 4;
        case Component::uint64:
        case Component::int64:
        case Component::float64:
            return 8;
    }
    // Not reached: it keeps compilers content that do not trust enums.
    return 0;
}

bool is_floating(Component component) { return component == Component::float32 || component == Component::float64; }

size_t checked_bytes(const Image& image)
{
    int64_t bytes = static_cast<int64_t>(size_of(image.component));
    // A header may give four numbers of 32 bits and more, whose product wraps around in 64 bits.
    for (const int64_t factor : {image.dims[0], image.dims[1], image.dims[2], image.fields}) {
        if (factor < 1)
            throw Error(CLEFT_ERROR_FORMAT, "there are no voxels");
        if (__builtin_mul_overflow(bytes, factor, &bytes))
            throw Error(CLEFT_ERROR_TOO_LARGE, "there are too many voxels");
    }
    return static_cast<size_t>(bytes);
}

void allocate_voxels(Image& image)
{
    image.voxels.reset(new std::byte[checked_bytes(image)]);  // not make_unique, which would fill it with zeros
}

}  // namespace cleft::io
