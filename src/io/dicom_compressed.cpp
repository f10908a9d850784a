// Compressed DICOM pixels, by ITK in a child process. Its library ends the process on some damaged files, and a library
// in the process of a solver must not do that.
#include "io/dicom_pixels.hpp"

#include "base/error.hpp"

#include <itkGDCMImageIO.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>

namespace cleft::io
{

namespace
{

constexpr int patience_ms = 60000;  // for the next piece of the pixels

struct Message {
    int32_t component = -1;  // of the pixels; -1: failed
    std::array<int64_t, 3> dims{1, 1, 1};
};

bool write_all(int pipe, const void* data, size_t size)
{
    const auto* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = write(pipe, at, std::min<size_t>(size, size_t{1} << 20));
        if (written <= 0)
            return false;
        at += written;
        size -= static_cast<size_t>(written);
    }
    return true;
}

bool read_all(int pipe, void* data, size_t size)
{
    auto* at = static_cast<char*>(data);
    while (size > 0) {
        pollfd ready{pipe, POLLIN, 0};
        const int events = poll(&ready, 1, patience_ms);
        if (events < 0 && errno == EINTR)
            continue;
        if (events <= 0)
            return false;
        const ssize_t got = read(pipe, at, size);
        if (got < 0 && errno == EINTR)
            continue;
        if (got <= 0)
            return false;
        at += got;
        size -= static_cast<size_t>(got);
    }
    return true;
}

Component component_of(itk::IOComponentEnum type)
{
    using Type = itk::IOComponentEnum;
    switch (type) {
        case Type::UCHAR:
            return Component::uint8;
        case Type::CHAR:
            return Component::int8;
        case Type::USHORT:
            return Component::uint16;
        case Type::SHORT:
            return Component::int16;
        case Type::UINT:
            return Component::uint32;
        case Type::INT:
            return Component::int32;
        case Type::FLOAT:
            return Component::float32;
        case Type::DOUBLE:
            return Component::float64;
        default:
            throw Error(CLEFT_ERROR_FORMAT, "no type of ours");
    }
}

// In the child: whatever happens ends here.
[[noreturn]] void decode_and_exit(const std::string& path, int pipe)
{
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    signal(SIGABRT, SIG_DFL);
    signal(SIGSEGV, SIG_DFL);
    // What the library says of damaged files is not for the terminal.
    if (!freopen("/dev/null", "w", stderr) || !freopen("/dev/null", "w", stdout))
        _exit(1);
    try {
        itk::Object::GlobalWarningDisplayOff();
        const auto reader = itk::GDCMImageIO::New();
        reader->SetFileName(path);
        reader->ReadImageInformation();
        if (reader->GetNumberOfComponents() != 1)
            _exit(1);
        Image image;
        Message message;
        image.component = component_of(reader->GetComponentType());
        message.component = static_cast<int32_t>(image.component);
        itk::ImageIORegion region(reader->GetNumberOfDimensions());
        for (unsigned axis = 0; axis < reader->GetNumberOfDimensions() && axis < 3; ++axis) {
            image.dims[axis] = static_cast<int64_t>(reader->GetDimensions(axis));
            region.SetSize(axis, reader->GetDimensions(axis));
        }
        reader->SetIORegion(region);
        allocate_voxels(image);
        reader->Read(image.voxels.get());
        message.dims = image.dims;
        const bool written =
            write_all(pipe, &message, sizeof message) && write_all(pipe, image.voxels.get(), image.bytes());
        _exit(written ? 0 : 1);
    } catch (...) {
        _exit(1);
    }
}

// The child, which is gone when this is.
class Decoder
{
public:
    explicit Decoder(const std::string& path)
    {
        int ends[2];
        if (::pipe(ends) != 0)
            throw Error(CLEFT_ERROR_FILE, "no process can be started to read compressed pixels");
        child_ = fork();
        if (child_ == 0) {
            close(ends[0]);
            decode_and_exit(path, ends[1]);
        }
        close(ends[1]);
        pipe_ = ends[0];
    }
    ~Decoder()
    {
        close(pipe_);
        if (child_ < 0)
            return;
        kill(child_, SIGKILL);
        while (waitpid(child_, nullptr, 0) < 0 && errno == EINTR) {
        }
    }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    int pipe() const { return pipe_; }

private:
    pid_t child_ = -1;
    int pipe_ = -1;
};

}  // namespace

Image compressed_pixels(const std::string& path)
{
    const Decoder decoder(path);
    Message message;
    bool whole = read_all(decoder.pipe(), &message, sizeof message) && message.component >= 0 &&
                 message.component <= static_cast<int32_t>(Component::float64);
    Image image;
    if (whole) {
        image.component = static_cast<Component>(message.component);
        image.dims = message.dims;
        allocate_voxels(image);
        whole = read_all(decoder.pipe(), image.voxels.get(), image.bytes());
    }
    if (!whole)
        throw Error(CLEFT_ERROR_FORMAT, "its compressed pixels are damaged or packed in a way that cannot be read");
    return image;
}

}  // namespace cleft::io
