// POSIX files, which are removed from their folder as soon as they are there.
#include "parts/scratch_file.hpp"

#include "base/error.hpp"

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

void ScratchFile::write(Record& record, const Array<unsigned char>& bytes)
{
    if (bytes.count() > record.room) {
        record.at = end_;
        record.room = bytes.count();
        end_ += record.room;
    }
    record.size = bytes.count();
    if (!transfer_all(record.size, [&](int64_t done) {
            return pwrite(file_, bytes.data() + done, to_size(record.size - done), record.at + done);
        }))
        fail("write");
}

Array<unsigned char> ScratchFile::read(const Record& record) const
{
    Array<unsigned char> bytes(record.size);
    if (!transfer_all(record.size, [&](int64_t done) {
            return pread(file_, bytes.data() + done, to_size(record.size - done), record.at + done);
        }))
        fail("read");
    return bytes;
}

void ScratchFile::fail(const char* what) const
{
    throw Error(CLEFT_ERROR_FILE, std::string("cannot ") + what + " a scratch file in '" + folder_ +
                                      "': " + std::generic_category().message(errno));
}

}  // namespace cleft
