// POSIX files, which are removed from their folder as soon as they are there.
#include "parts/scratch_file.hpp"

#include "base/error.hpp"
#include "base/to_size.hpp"

#include <cerrno>
#include <cstdlib>
#include <system_error>

#include <fcntl.h>
#include <unistd.h>

namespace cleft
{

namespace
{

// All of some bytes, by as many calls as it takes. `transfer(done)` gives how many the next call has moved.
template <class Transfer>
bool transfer_all(int64_t size, const Transfer& transfer)
{
    for (int64_t done = 0; done < size;) {
        const ssize_t moved = transfer(done);
        if (moved > 0)
            done += moved;
        else if (moved == 0 || errno != EINTR)
            return false;
    }
    return true;
}

}  // namespace

ScratchFile::ScratchFile(const std::string& folder) : folder_(folder)
{
    std::string name = folder + "/.cleft-scratch-XXXXXX";
    file_ = mkostemp(name.data(), O_CLOEXEC);
    if (file_ < 0)
        fail("make");
    unlink(name.c_str());
}

ScratchFile::~ScratchFile() { close(file_); }

void ScratchFile::write(Place& place, const void* bytes, int64_t size)
{
    if (size > place.room) {
        place = {end_, size};
        end_ += size;
    }
    const auto* from = static_cast<const unsigned char*>(bytes);
    if (!transfer_all(size,
                      [&](int64_t done) { return pwrite(file_, from + done, to_size(size - done), place.at + done); }))
        fail("write");
}

void ScratchFile::read(const Place& place, int64_t first, int64_t size, void* to) const
{
    auto* const out = static_cast<unsigned char*>(to);
    if (!transfer_all(size, [&](int64_t done) {
            return pread(file_, out + done, to_size(size - done), place.at + first + done);
        }))
        fail("read");
}

void ScratchFile::fail(const char* what) const
{
    throw Error(CLEFT_ERROR_FILE, std::string("cannot ") + what + " a scratch file in '" + folder_ +
                                      "': " + std::generic_category().message(errno));
}

}  // namespace cleft
