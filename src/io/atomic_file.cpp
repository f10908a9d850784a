#include "io/atomic_file.hpp"

#include "base/error.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>
#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <utility>
#include <vector>

namespace cleft::io
{

namespace fs = std::filesystem;

namespace
{

[[noreturn]] void cannot_write(const std::string& path, int error)
{
    throw Error(CLEFT_ERROR_FILE, "cannot write '" + path + "': " + std::generic_category().message(error));
}

// The file that a path stands for: a symbolic link is followed, so that it stays a link.
std::string target_of(const std::string& path)
{
    std::error_code ignored;  // a file that is not there yet is no failure
    std::error_code error;
    const bool is_link = fs::is_symlink(fs::symlink_status(path, ignored));
    const fs::path target = is_link ? fs::weakly_canonical(path, error) : fs::path(path);
    if (error)
        cannot_write(path, error.value());
    const fs::file_status status = fs::status(target, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Error(CLEFT_ERROR_FILE, "cannot write '" + path + "': it is no regular file");
    return target.string();
}

// A file that is replaced passes its permissions on.
void keep_permissions(int descriptor, const std::string& old)
{
    struct stat status {
    };
    if (stat(old.c_str(), &status) == 0 && fchmod(descriptor, status.st_mode & 07777) != 0)
        errno = 0;  // the new file then has the permissions of any new file
}

// Makes an empty file in the folder of `path`, under a name that nothing has, and opens it.
int create_temporary(const std::string& path, std::string& name)
{
    for (int i = 0;; ++i) {
        name = path + ".part" + std::to_string(getpid()) + "-" + std::to_string(i);
        const int descriptor = open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (descriptor >= 0)
            return descriptor;
        if (errno != EEXIST)
            cannot_write(path, errno);
    }
}

// What is at a path, kept within reach under a second name.
class OldFile
{
public:
    explicit OldFile(const std::string& path) : path_(path), is_there_(access(path.c_str(), F_OK) == 0)
    {
        for (int i = 0; is_there_ && name_.empty(); ++i) {
            const std::string name = path + ".old" + std::to_string(getpid()) + "-" + std::to_string(i);
            if (link(path.c_str(), name.c_str()) == 0)
                name_ = name;
            else if (errno != EEXIST)
                return;  // no hard links here
        }
    }
    ~OldFile()
    {
        if (!name_.empty())
            unlink(name_.c_str());
    }
    OldFile(const OldFile&) = delete;
    OldFile& operator=(const OldFile&) = delete;

    void put_back()
    {
        if (!is_there_)
            unlink(path_.c_str());
        else if (!name_.empty() && std::rename(name_.c_str(), path_.c_str()) == 0)
            name_.clear();
    }

private:
    std::string path_;
    std::string name_;
    bool is_there_;
};

// Makes the renaming itself last. Some file systems cannot; the file is complete all the same.
void flush_folder(const std::string& path)
{
    const fs::path folder = fs::path(path).parent_path();
    const int descriptor = open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    (void)fsync(descriptor);
    close(descriptor);
}

}  // namespace

AtomicFile::AtomicFile(const std::string& path) : path_(target_of(path)), buffer_(std::make_unique<char[]>(capacity))
{
    descriptor_ = create_temporary(path_, temporary_);
    keep_permissions(descriptor_, path_);
}

AtomicFile::~AtomicFile()
{
    if (descriptor_ >= 0)
        close(descriptor_);
    if (!temporary_.empty())
        unlink(temporary_.c_str());
}

void AtomicFile::fail() const { cannot_write(path_, errno); }

void AtomicFile::write(const void* data, size_t bytes)
{
    const char* from = static_cast<const char*>(data);
    while (bytes > 0) {
        if (used_ == capacity)
            flush();
        const size_t part = std::min(bytes, capacity - used_);
        std::memcpy(buffer_.get() + used_, from, part);
        used_ += part;
        from += part;
        bytes -= part;
    }
}

void AtomicFile::flush()
{
    for (size_t written = 0; written < used_;) {
        const ssize_t n = ::write(descriptor_, buffer_.get() + written, used_ - written);
        if (n < 0 && errno != EINTR)
            fail();
        written += n > 0 ? static_cast<size_t>(n) : 0;
    }
    used_ = 0;
}

// Everything on the disk, still under the temporary name.
void AtomicFile::finish()
{
    flush();
    if (fsync(descriptor_) != 0)
        fail();
    if (close(std::exchange(descriptor_, -1)) != 0)
        fail();
}

void AtomicFile::take_name()
{
    if (std::rename(temporary_.c_str(), path_.c_str()) != 0)
        fail();
    temporary_.clear();
}

void AtomicFile::commit_all(const std::initializer_list<AtomicFile*>& files)
{
    for (AtomicFile* file : files)
        file->finish();
    std::vector<std::unique_ptr<OldFile>> old;
    if (files.size() > 1)  // of one file, the renaming itself is all or nothing
        for (const AtomicFile* file : files)
            old.push_back(std::make_unique<OldFile>(file->path_));
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
    flush_folder((*files.begin())->path_);
}

}  // namespace cleft::io
