// Compressed DICOM pixels, by GDCM in a child process. It ends the process on some damaged files, and a library in the
// process of a solver must not do that.
#include "io/dicom_compressed.hpp"

#include "base/error.hpp"
#include "io/system_failure.hpp"

#ifdef CLEFT_WITH_GDCM
#include <gdcmImageReader.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include <cerrno>
#include <csignal>
#include <vector>
#endif

namespace cleft::io
{

#ifdef CLEFT_WITH_GDCM

namespace
{

// GDCM may loop without end on a damaged code stream. The child sends nothing before all is
// decoded, so this bounds the whole decoding, which takes seconds for files of common size.
constexpr int kPatienceMs = 60000;  // for the next piece of the pixels

bool write_all(int pipe, const void* data, size_t size)
{
    const auto* at = static_cast<const char*>(data);
    while (size > 0) {
        const ssize_t written = write(pipe, at, std::min<size_t>(size, size_t{1} << 20));
        // The caller's signal handlers came along with fork(), and signals for its process group reach
        // the child, too.
        if (written < 0 && errno == EINTR)
            continue;
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
        const int events = poll(&ready, 1, kPatienceMs);
        if (events < 0 && errno == EINTR)
            continue;
        // 0 events: the time is over. The destructor of Decoder then kills the child.
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

// The child has no other way to tell want of memory from damage: its exceptions end with it. 1
// stands for all other failures.
constexpr int kOutOfMemory = 3;  // an exit status
constexpr const char* kNoProcess = "no process can be started to read compressed pixels";

// In the child: whatever happens ends here.
[[noreturn]] void decode_and_exit(const std::string& path, int pipe)
{
    // A crash of the decoder is an expected outcome here, and its core file would hold the
    // patient's image.
    const rlimit no_core{0, 0};
    setrlimit(RLIMIT_CORE, &no_core);
    // The caller's handlers came along with fork(). Python, Java and .NET have some that would
    // print a trace or try to go on.
    signal(SIGABRT, SIG_DFL);
    signal(SIGSEGV, SIG_DFL);
    // What the library says of damaged files is not for the terminal.
    // The parent's messages must not change because GDCM prints warnings to both streams.
    if (!freopen("/dev/null", "w", stderr) || !freopen("/dev/null", "w", stdout))
        _exit(1);
    try {
        gdcm::ImageReader reader;
        reader.SetFileName(path.c_str());
        // Read() answers false for want of memory as for damage; errno tells the two apart.
        forget_want_of_memory();
        if (!reader.Read())
            _exit(errno == ENOMEM ? kOutOfMemory : 1);
        const gdcm::Image& image = reader.GetImage();
        const auto size = static_cast<int64_t>(image.GetBufferLength());
        std::vector<char> values(static_cast<size_t>(size));
        const bool written = image.GetBuffer(values.data()) && write_all(pipe, &size, sizeof size) &&
                             write_all(pipe, values.data(), values.size());
        // _exit() and not exit(): buffers and atexit() handlers are the parent's, and would run
        // twice.
        _exit(written ? 0 : 1);
    } catch (const std::bad_alloc&) {
        _exit(kOutOfMemory);
    } catch (...) {
        _exit(1);
    }
}

// The child, which is gone when this is.
class Decoder
{
public:
    // fork() copies only the calling thread. The child may still allocate memory, as glibc resets
    // the locks of malloc() in it.
    explicit Decoder(const std::string& path)
    {
        int ends[2];
        if (::pipe(ends) != 0)
            throw_system_failure(kNoProcess, errno);
        child_ = fork();
        if (child_ < 0) {
            const int error = errno;
            close(ends[0]);
            close(ends[1]);
            throw_system_failure(kNoProcess, error);
        }
        if (child_ == 0) {
            close(ends[0]);
            decode_and_exit(path, ends[1]);
        }
        // The parent must close its own writing end. Otherwise read() would never see the end of
        // the pipe when the child is gone.
        close(ends[1]);
        pipe_ = ends[0];
    }
    ~Decoder()
    {
        close(pipe_);
        if (child_ < 0)
            return;
        // The child may still be decoding if the parent has given up or has enough. It holds
        // nothing that must be saved.
        kill(child_, SIGKILL);
        wait();
    }
    Decoder(const Decoder&) = delete;
    Decoder& operator=(const Decoder&) = delete;
    int pipe() const { return pipe_; }

    // Waits for the child, whose pipe has ended.
    bool ran_out_of_memory()
    {
        const int status = wait();
        return WIFEXITED(status) && WEXITSTATUS(status) == kOutOfMemory;
    }

private:
    int wait()
    {
        int status = 0;
        // Without waitpid() the child would stay as a zombie for as long as the caller's process
        // lives.
        while (waitpid(child_, &status, 0) < 0 && errno == EINTR) {
        }
        child_ = -1;
        return status;
    }

    pid_t child_ = -1;
    int pipe_ = -1;
};

}  // namespace

void read_compressed_pixels(const std::string& path, Image& image)
{
    Decoder decoder(path);
    int64_t size = 0;
    // The length of the decoded pixels is checked against the header before memory is taken for
    // them.
    const int64_t wanted = image.field_size() * static_cast<int64_t>(size_of(image.component));
    bool whole = read_all(decoder.pipe(), &size, sizeof size) && size == wanted;
    if (whole) {
        allocate_voxels(image);
        whole = read_all(decoder.pipe(), image.voxels.get(), image.bytes());
    }
    // A child that runs out of memory has sent nothing. Waiting for it is safe only then, as its
    // pipe has ended.
    if (size == 0 && decoder.ran_out_of_memory())
        throw std::bad_alloc();
    if (!whole)
        throw Error(CLEFT_ERROR_FORMAT, "its compressed pixels are damaged or packed in a way that cannot be read");
}

#else

void read_compressed_pixels(const std::string&, Image&)
{
    throw Error(CLEFT_ERROR_UNSUPPORTED,
                "its pixels are compressed, and this build of libcleft_io has no GDCM to read them: write them "
                "uncompressed, by 'gdcmconv --raw' or 'dcmdjpeg'");
}

#endif

}  // namespace cleft::io
