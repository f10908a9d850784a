// Reads through the system's calls, 256 kB at a time, and decompresses by zlib on the way.
#include "io/byte_source.hpp"

#include "base/counted.hpp"
#include "base/error.hpp"
#include "io/system_failure.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <zlib.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <vector>

namespace cleft::io
{

namespace
{

// 256 kB: the cost of a call to the system is then small beside that of the copy.
constexpr size_t kBufferBytes = size_t{1} << 18;

[[noreturn]] void cannot_read(int error) { throw_system_failure("cannot read it", error); }

[[noreturn]] void too_short(uintmax_t missing)
{
    throw Error(CLEFT_ERROR_FORMAT,
                "it ends too early: " + counted(static_cast<int64_t>(missing), "byte is", "bytes are") + " missing");
}

int open_regular(const std::string& path, uintmax_t& size)
{
    struct stat status {
    };
    if (stat(path.c_str(), &status) != 0) {
        if (errno == ENOENT)
            throw Error(CLEFT_ERROR_FILE, "there is no such file");
        cannot_read(errno);
    }
    if (S_ISDIR(status.st_mode))
        throw Error(CLEFT_ERROR_FILE, "it is a folder, not a file");
    // open() of a pipe without a writer would wait for ever, and /dev/zero would never end. So
    // stat() comes before open().
    if (!S_ISREG(status.st_mode))
        throw Error(CLEFT_ERROR_FILE, "it is a device or pipe, not a file");
    const int descriptor = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        cannot_read(errno);
    size = static_cast<uintmax_t>(status.st_size);
    return descriptor;
}

}  // namespace

class ByteSource::State
{
public:
    State(const std::string& path, Coding coding, uintmax_t offset, uintmax_t length) : coding_(coding)
    {
        uintmax_t size = 0;
        descriptor_ = open_regular(path, size);
        try {
            // The subtraction on the right cannot wrap, as the left side has been checked. A
            // header's claim of 2^64 - 1 bytes stops here.
            if (offset > size || (length != kToTheEnd && length > size - offset))
                too_short(offset > size ? offset - size : length - (size - offset));
            unread_ = length == kToTheEnd ? size - offset : length;
            if (offset > 0 && lseek(descriptor_, static_cast<off_t>(offset), SEEK_SET) < 0)
                cannot_read(errno);
            // 15: the largest window of RFC 1951, 32 kB. 32: zlib finds out by itself whether gzip
            // (RFC 1952) or zlib (RFC 1950) wraps the data.
            if (coding == Coding::deflated && inflateInit2(&stream_, 15 + 32) != Z_OK)
                throw std::bad_alloc();
        } catch (...) {
            close(descriptor_);
            throw;
        }
    }
    ~State()
    {
        if (coding_ == Coding::deflated)
            inflateEnd(&stream_);
        close(descriptor_);
    }
    State(const State&) = delete;
    State& operator=(const State&) = delete;

    void pass_over(uintmax_t bytes)
    {
        if (lseek(descriptor_, static_cast<off_t>(bytes), SEEK_CUR) < 0)
            cannot_read(errno);
        unread_ -= bytes;
    }

    bool is_plain() const { return coding_ == Coding::plain; }
    uintmax_t left() const { return unread_ + (is_plain() ? 0 : stream_.avail_in); }
    size_t read_some(char* to, size_t bytes) { return is_plain() ? read_file(to, bytes) : inflate_some(to, bytes); }

    void read_at(uintmax_t offset, char* to, size_t bytes) const
    {
        transfer(bytes, [&](size_t done, size_t wanted) {
            return pread(descriptor_, to + done, wanted, static_cast<off_t>(offset + done));
        });
    }

private:
    // read_some(done, wanted) is a call of the system, to which `done` bytes came before.
    template <class ReadSome>
    static void transfer(size_t bytes, const ReadSome& read_some)
    {
        for (size_t done = 0; done < bytes;) {
            // Linux transfers at most 2^31 - 4096 bytes a call; 2^30 stays below it.
            const ssize_t got = read_some(done, std::min(bytes - done, size_t{1} << 30));
            if (got < 0 && errno != EINTR)
                cannot_read(errno);
            // The size was that of stat(), so the file has shrunk while it was being read.
            if (got == 0)
                too_short(bytes - done);
            done += got > 0 ? static_cast<size_t>(got) : 0;
        }
    }

    size_t read_file(char* to, size_t bytes)
    {
        bytes = static_cast<size_t>(std::min<uintmax_t>(bytes, unread_));
        transfer(bytes, [&](size_t done, size_t wanted) { return ::read(descriptor_, to + done, wanted); });
        unread_ -= bytes;
        return bytes;
    }

    bool fill()
    {
        if (stream_.avail_in > 0)
            return true;
        buffer_.resize(kBufferBytes);
        stream_.next_in = reinterpret_cast<Bytef*>(buffer_.data());
        stream_.avail_in = static_cast<uInt>(read_file(buffer_.data(), buffer_.size()));
        return stream_.avail_in > 0;
    }

    size_t inflate_some(char* to, size_t bytes)
    {
        size_t done = 0;
        while (done < bytes && !(ended_ && !next_member())) {
            if (!fill())
                throw Error(CLEFT_ERROR_FORMAT, "its compressed data end too early");
            // zlib counts in 32 bits; a larger request is served piece by piece.
            const auto room = static_cast<uInt>(std::min(bytes - done, size_t{1} << 30));
            stream_.next_out = reinterpret_cast<Bytef*>(to + done);
            stream_.avail_out = room;
            const int result = inflate(&stream_, Z_NO_FLUSH);
            done += room - stream_.avail_out;
            if (result == Z_MEM_ERROR)
                throw std::bad_alloc();
            // Z_BUF_ERROR only asks for more input or room, which the next turn gives. Z_NEED_DICT
            // is damage: no image format uses a preset dictionary. zlib checks the check sum before
            // it answers Z_STREAM_END.
            if (result != Z_OK && result != Z_STREAM_END && result != Z_BUF_ERROR)
                throw Error(CLEFT_ERROR_FORMAT, "its compressed data are damaged");
            ended_ = result == Z_STREAM_END;
        }
        return done;
    }

    // A gzip file may be of several members, one after the other, which are one stream. Anything else behind them, such
    // as the zeros that fill blocks up, is no part of it.
    // RFC 1952, section 2.2: "a gzip file consists of a series of members". bgzip and pigz write
    // such files.
    bool next_member()
    {
        // 0x1f is the first byte of a gzip member (ID1). tar and some tape tools pad with zeros,
        // which are no member.
        if (!fill() || stream_.next_in[0] != 0x1f)
            return false;
        ended_ = false;
        if (inflateReset(&stream_) != Z_OK)
            throw Error(CLEFT_ERROR_INTERNAL, "zlib cannot begin again");
        return true;
    }

    Coding coding_;
    int descriptor_ = -1;
    uintmax_t unread_ = 0;  // bytes of the file
    z_stream stream_{};
    std::vector<char> buffer_;
    bool ended_ = false;
};

ByteSource::ByteSource(const std::string& path, Coding coding, uintmax_t offset, uintmax_t length)
    : state_(std::make_unique<State>(path, coding, offset, length))
{
}
ByteSource::ByteSource(ByteSource&&) noexcept = default;
ByteSource& ByteSource::operator=(ByteSource&&) noexcept = default;
ByteSource::~ByteSource() = default;

uintmax_t ByteSource::left() const { return state_->left(); }

void ByteSource::expect(uintmax_t bytes) const
{
    const uintmax_t left = state_->left();
    if (state_->is_plain()) {
        // A plain source knows exactly what is left, so that nothing need be allocated for what is
        // not there.
        if (bytes > left)
            too_short(bytes - left);
    } else if (bytes / kGreatestDeflateRatio > left + 8) {  // some bits may be with zlib already
        throw Error(CLEFT_ERROR_FORMAT,
                    "its header claims " + std::to_string(bytes) + " bytes, which its compressed data cannot hold");
    }
}

size_t ByteSource::read_some(void* to, size_t bytes) { return state_->read_some(static_cast<char*>(to), bytes); }

void ByteSource::read(void* to, size_t bytes)
{
    const size_t got = read_some(to, bytes);
    if (got < bytes)
        too_short(bytes - got);
}

void ByteSource::read_at(uintmax_t offset, void* to, size_t bytes) const
{
    state_->read_at(offset, static_cast<char*>(to), bytes);
}

void ByteSource::skip(uintmax_t bytes)
{
    expect(bytes);
    if (state_->is_plain()) {
        state_->pass_over(bytes);
        return;
    }
    // A compressed stream cannot seek, so what is skipped must be decompressed.
    std::vector<char> waste(static_cast<size_t>(std::min<uintmax_t>(bytes, kBufferBytes)));
    while (bytes > 0) {
        const auto step = static_cast<size_t>(std::min<uintmax_t>(bytes, waste.size()));
        read(waste.data(), step);
        bytes -= step;
    }
}

std::string ByteSource::read_rest()
{
    std::string text;
    for (size_t got = 1; got > 0;) {
        const size_t before = text.size();
        // The size of what is compressed is not known. Doubling keeps the number of copies small.
        text.resize(before + std::max(kBufferBytes, before));
        got = read_some(text.data() + before, text.size() - before);
        text.resize(before + got);
    }
    return text;
}

}  // namespace cleft::io
