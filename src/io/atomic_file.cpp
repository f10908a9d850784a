// Files that are complete or not there: temporary names, renaming, and what was there before.
#include "io/atomic_file.hpp"

#include "base/error.hpp"
#include "io/quiet_write.hpp"
#include "io/system_failure.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <system_error>
#include <utility>
#include <vector>

namespace cleft::io
{

namespace fs = std::filesystem;

namespace
{

// Linux follows at most 40 symbolic links in one path (path_resolution(7)). The same bound here ends a circle of links.
constexpr int kMostLinks = 40;

[[noreturn]] void cannot_write(const std::string& path, int error)
{
    throw_system_failure("cannot write '" + path + "'", error);
}

// The file that a path stands for: a symbolic link is followed, so that it stays a link, also where nothing is behind.
fs::path target_of(const std::string& path)
{
    std::error_code ignored;  // a file that is not there yet is no failure
    fs::path target = path;
    for (int links = 0; fs::is_symlink(fs::symlink_status(target, ignored)); ++links) {
        std::error_code error;
        const fs::path next = fs::read_symlink(target, error);
        if (error || links == kMostLinks)
            cannot_write(path, error ? error.value() : ELOOP);
        target = target.parent_path() / next;
    }
    const fs::file_status status = fs::status(target, ignored);
    // A rename onto a device or a pipe would replace the device node by a plain file.
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(CLEFT_ERROR_FILE, "cannot write '" + path + "': it is no regular file");
    return target;
}

// One whose files cannot be listed may still be written to.
int open_folder(const fs::path& folder)
{
    // O_PATH needs no permission to read the folder. It suffices for openat() and renameat(), but
    // fsync() of the folder then fails, which commit_all() ignores.
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    return descriptor < 0 && errno == EACCES ? open(folder.c_str(), O_PATH | O_DIRECTORY | O_CLOEXEC) : descriptor;
}

// A file that is replaced passes its permissions on.
void keep_permissions(int folder, const std::string& old, int descriptor)
{
    struct stat status {
    };
    // 07777 keeps the set-user-id, set-group-id and sticky bits beside the nine bits of access.
    if (fstatat(folder, old.c_str(), &status, 0) == 0 && fchmod(descriptor, status.st_mode & 07777) != 0)
        errno = 0;  // the new file then has the permissions of any new file
}

// Calls take(name) with names that do not depend on that of the target, which may be as long as names can be, until
// there is one that nothing has.
template <class Take>
bool take_free_name(const char* kind, std::string& name, const Take& take)
{
    for (int i = 0;; ++i) {
        // The process number keeps two runs in one folder apart, so that few names are tried. The
        // dot hides the file from patterns such as "*", which another run may be reading.
        name = std::string(".cleft-") + kind + std::to_string(getpid()) + "-" + std::to_string(i);
        if (take(name.c_str()))
            return true;
        // Any other error (no space, no permission, a read-only file system) would come again for
        // each further name.
        if (errno != EEXIST)
            return false;
    }
}

// What a name stands for in a folder, kept within reach under a second name.
class OldFile
{
public:
    OldFile(int folder, const std::string& name)
        : folder_(folder), name_(name), is_there_(faccessat(folder, name.c_str(), F_OK, 0) == 0)
    {
        // A hard link costs no copy, and the name itself stays where it is until the rename
        // replaces it.
        const auto link_to = [&](const char* second) { return linkat(folder, name_.c_str(), folder, second, 0) == 0; };
        if (is_there_ && !take_free_name("old", second_, link_to))
            second_.clear();  // no hard links here
    }
    ~OldFile()
    {
        if (!second_.empty())
            unlinkat(folder_, second_.c_str(), 0);
    }
    OldFile(const OldFile&) = delete;
    OldFile& operator=(const OldFile&) = delete;

    // Called while an Error is on its way out, so it must not throw. What cannot be put back stays
    // as the rename left it.
    void put_back() noexcept
    {
        if (!is_there_)
            unlinkat(folder_, name_.c_str(), 0);
        else if (!second_.empty() && renameat(folder_, second_.c_str(), folder_, name_.c_str()) == 0)
            second_.clear();
    }

private:
    int folder_;
    std::string name_;
    std::string second_;
    bool is_there_;
};

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(path), buffer_(std::make_unique<char[]>(kCapacity))
{
    const fs::path target = target_of(path);
    const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
    name_ = target.filename().string();
    if (name_.empty())
        cannot_write(path, EISDIR);
    folder_ = open_folder(folder);
    if (folder_ < 0)
        cannot_write(path, errno);
    const auto create = [&](const char* name) {
        descriptor_ = openat(folder_, name, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        return descriptor_ >= 0;
    };
    std::string name;
    struct stat status {
    };
    int error = 0;
    // The temporary name is short, so it would hide that the final name is too long until the whole
    // file is written.
    if (fstatat(folder_, name_.c_str(), &status, 0) != 0 && errno == ENAMETOOLONG)
        error = errno;
    else if (!take_free_name("part", name, create))
        error = errno;
    if (error != 0) {
        close(folder_);
        cannot_write(path, error);
    }
    // swap() takes no memory. From here on the destructor knows of the file and removes it.
    temporary_.swap(name);
    keep_permissions(folder_, name_, descriptor_);
}

AtomicFile::~AtomicFile()
{
    if (descriptor_ >= 0)
        close(descriptor_);
    if (!temporary_.empty())
        unlinkat(folder_, temporary_.c_str(), 0);
    close(folder_);
}

void AtomicFile::fail(int error) const { cannot_write(path_, error); }

void AtomicFile::write(const void* data, size_t bytes)
{
    const char* from = static_cast<const char*>(data);
    while (bytes > 0) {
        if (used_ == kCapacity)
            flush();
        const size_t part = std::min(bytes, kCapacity - used_);
        std::memcpy(buffer_.get() + used_, from, part);
        used_ += part;
        from += part;
        bytes -= part;
    }
}

// The buffer is written as a whole, so a caller never sees a part of a call to write() fail.
void AtomicFile::flush()
{
    if (const int error = write_quietly(descriptor_, buffer_.get(), used_))
        fail(error);
    used_ = 0;
}

// Everything on the disk, still under the temporary name.
void AtomicFile::finish()
{
    flush();
    // Without fsync() a power failure after the rename could leave the new name with an empty file
    // (on ext4 and XFS, for example).
    if (fsync(descriptor_) != 0)
        fail(errno);
    // NFS reports a full disk or quota at close() only. The descriptor is gone even if close()
    // fails, so the destructor must not close it again.
    if (close(std::exchange(descriptor_, -1)) != 0)
        fail(errno);
}

void AtomicFile::take_name()
{
    if (renameat(folder_, temporary_.c_str(), folder_, name_.c_str()) != 0)
        fail(errno);
    temporary_.clear();
}

void AtomicFile::commit_all(const std::initializer_list<AtomicFile*>& files)
{
    // All data are on the disk before the first rename. What fails for want of space therefore
    // fails while the old files are untouched.
    for (AtomicFile* file : files)
        file->finish();
    std::vector<std::unique_ptr<OldFile>> old;
    if (files.size() > 1)  // of one file, the renaming itself is all or nothing
        for (const AtomicFile* file : files)
            old.push_back(std::make_unique<OldFile>(file->folder_, file->name_));
    // Files before this position have taken their names and must be put back if a later one fails.
    size_t renamed = 0;
    try {
        for (AtomicFile* file : files) {
            file->take_name();
            ++renamed;
        }
    } catch (...) {
        for (size_t i = 0; i < renamed; ++i)
            old[i]->put_back();
        throw;
    }
    // Makes the renaming itself last. Some file systems cannot; the files are complete all the same.
    for (const AtomicFile* file : files)
        (void)fsync(file->folder_);
}

}  // namespace cleft::io
