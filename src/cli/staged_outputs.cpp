// Outputs that appear together.
#include "staged_outputs.hpp"

#include "interrupt.hpp"
#include "standard_output.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <set>
#include <system_error>

namespace cleft_cli
{
namespace
{

namespace fs = std::filesystem;

// Linux follows at most 40 symbolic links in one path (path_resolution(7)).
constexpr int kMostLinks = 40;

// Want of memory keeps its own exit code, wherever it is met.
Failure cannot_write(const fs::path& path, int error)
{
    if (error == ENOMEM)
        return {EXIT_OUT_OF_MEMORY, CLEFT_ERROR_OUT_OF_MEMORY, "out of memory"};
    return {EXIT_CANNOT_WRITE, CLEFT_ERROR_FILE, "cannot write '" + path.string() + "': " + std::strerror(error)};
}

// One file on its way to its name.
struct Move {
    fs::path staged, target, old;
    bool was_there = false;
    bool done = false;
};

// Keeps what is at the target under a second name, in the folder that is removed at the end.
void keep_old(Move& move, const fs::path& as)
{
    struct stat status = {};
    // lstat(): links were followed before, so what is at the target now is the file itself.
    if (lstat(move.target.c_str(), &status) != 0)
        return;
    move.was_there = true;
    if (S_ISREG(status.st_mode))
        // The old file's permissions, so that sharing with a group survives a new run.
        (void)chmod(move.staged.c_str(), status.st_mode & 07777);  // not on every file system
    // Without hard links (FAT, some network file systems) the old contents cannot be put back. The
    // new ones are complete all the same.
    if (link(move.target.c_str(), as.c_str()) == 0)
        move.old = as;
}

// Failures are ignored: nothing better can be done, and the first error is the one to tell.
void undo(const Move& move)
{
    if (!move.done)
        return;
    if (!move.was_there)
        unlink(move.target.c_str());
    else if (!move.old.empty())
        (void)std::rename(move.old.c_str(), move.target.c_str());
}

std::string replaced(std::string text, const std::string& from, const std::string& to)
{
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += to.size())
        text.replace(at, from.size(), to);
    return text;
}

// The answer is 0 or the error number, of which std::filesystem tells none.
int copy_all(int from, int to)
{
    char block[1 << 16];
    for (;;) {
        const ssize_t n = read(from, block, sizeof block);
        if (n < 0 && errno != EINTR)
            return errno;
        if (n == 0)
            return fsync(to) != 0 ? errno : 0;
        const int error = n > 0 ? write_all(to, {block, static_cast<std::size_t>(n)}) : 0;
        if (error != 0)
            return error;
    }
}

// To a file that is not there yet, with the permissions of the other.
int copy_contents(const fs::path& from, const fs::path& to)
{
    struct stat status = {};
    const int source = open(from.c_str(), O_RDONLY | O_CLOEXEC);
    const int made = source < 0 || fstat(source, &status) != 0
                         ? -1
                         : open(to.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, status.st_mode & 07777);
    int error = made < 0 ? errno : copy_all(source, made);
    if (made >= 0 && close(made) != 0 && error == 0)
        error = errno;
    if (source >= 0)
        close(source);
    return error;
}

// A link may lead to another file system, where no rename goes.
bool is_on_another_file_system(const fs::path& file, const fs::path& folder)
{
    struct stat a = {}, b = {};
    return stat(file.c_str(), &a) == 0 && stat(folder.c_str(), &b) == 0 && a.st_dev != b.st_dev;
}

// Makes the renames themselves last over a power failure. The files were flushed by their writers.
void flush_folder(const fs::path& folder)
{
    const int descriptor = open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (descriptor < 0)
        return;
    (void)fsync(descriptor);
    close(descriptor);
}

}  // namespace

fs::path folder_of(const fs::path& path) { return path.has_parent_path() ? path.parent_path() : fs::path("."); }

fs::path link_target(const std::string& path)
{
    std::error_code error;
    fs::path target = path;
    // A circle of links ends at the limit. Writing then fails with the system's own error.
    for (int links = 0; links < kMostLinks && fs::is_symlink(fs::symlink_status(target, error)); ++links) {
        const fs::path next = fs::read_symlink(target, error);
        if (error)
            break;
        target = target.parent_path() / next;
    }
    return target;
}

StagedOutputs::Stage::Stage(const fs::path& folder, const std::string& output)
{
    // A handler must not see a folder that is made but not in the list yet.
    const SignalsLater later;
    // In the folder of the target: rename() works within one file system only.
    std::string name = (folder / ".cleft-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr)
        throw cannot_write(output, errno);
    path_ = std::move(name);
    // Opened now, since opendir() asks for memory and remove() may run where there is none, or in a
    // signal handler.
    listing_ = opendir(path_.c_str());
    if (listing_ == nullptr) {
        const int error = errno;
        rmdir(path_.c_str());
        throw cannot_write(output, error);
    }
    // A list through the objects themselves: adding to it and walking it need no memory.
    next = newest;
    newest = this;
}

StagedOutputs::Stage::~Stage()
{
    const SignalsLater later;
    remove();
    closedir(listing_);
    Stage** link = &newest;
    while (*link != this)
        link = &(*link)->next;
    *link = next;
}

void StagedOutputs::Stage::remove() noexcept
{
    rewinddir(listing_);
    while (const dirent* entry = readdir(listing_))
        // "." and ".." fail with an error that nobody looks at.
        unlinkat(dirfd(listing_), entry->d_name, 0);
    rmdir(path_.c_str());
}

StagedOutputs::Stage* StagedOutputs::Stage::newest = nullptr;

void StagedOutputs::remove_all() noexcept
{
    // POSIX does not list readdir() for handlers. glibc's takes a lock of the stream alone, and
    // signals are blocked wherever else the stream is read.
    for (Stage* stage = Stage::newest; stage != nullptr; stage = stage->next)
        stage->remove();
}

std::vector<std::string> StagedOutputs::Stage::names() const
{
    std::vector<std::string> names;
    rewinddir(listing_);
    while (const dirent* entry = readdir(listing_))
        if (std::strcmp(entry->d_name, ".") != 0 && std::strcmp(entry->d_name, "..") != 0)
            names.emplace_back(entry->d_name);
    // The order of moves must not depend on the file system.
    std::sort(names.begin(), names.end());
    return names;
}

StagedOutputs::~StagedOutputs() = default;

const StagedOutputs::Output& StagedOutputs::add(const std::string& path)
{
    auto stage = std::make_unique<Stage>(folder_of(link_target(path)), path);
    // The final name in a folder of its own: writers choose the format by the extension, and
    // TetGen's put two files beside.
    const fs::path staged = stage->path() / fs::path(path).filename();
    outputs_.push_back({path, std::move(stage), staged});
    return outputs_.back();
}

void StagedOutputs::write(const std::string& path, const std::function<void(const std::string& place)>& write)
{
    const std::string to = place(path);
    try {
        write(to);
    } catch (const Failure& failure) {
        throw described(failure);
    }
}

Failure StagedOutputs::described(const Failure& failure) const
{
    std::string sentence = failure.what();
    for (const Output& output : outputs_) {
        const fs::path parent = fs::path(output.path).parent_path();
        sentence = replaced(sentence, (output.stage->path() / "").string(),
                            parent.empty() ? std::string() : (parent / "").string());
    }
    Failure described(failure.exit_code, failure.status, sentence);
    described.is_reported = failure.is_reported;
    return described;
}

double StagedOutputs::bytes(const std::string& path) const
{
    for (const Output& output : outputs_) {
        std::error_code error;
        const auto size = output.path == path ? fs::file_size(output.staged, error) : 0;
        if (output.path == path && !error)
            return static_cast<double>(size);
    }
    return 0;
}

fs::path StagedOutputs::near(const fs::path& staged, const fs::path& target)
{
    const fs::path folder = folder_of(target);
    if (!is_on_another_file_system(staged, folder))
        return staged;
    copies_.push_back(std::make_unique<Stage>(folder, target.string()));
    const fs::path copy = copies_.back()->path() / target.filename();
    const int error = copy_contents(staged, copy);
    if (error != 0)
        throw cannot_write(target, error);
    return copy;
}

void StagedOutputs::commit()
{
    const SignalsLater later;
    std::vector<Move> moves;
    for (const Output& output : outputs_) {
        // All files of the folder go, as a format may have several.
        for (const std::string& name : output.stage->names()) {
            const fs::path target = link_target((fs::path(output.path).parent_path() / name).string());
            const fs::path staged = near(output.stage->path() / name, target);
            moves.push_back({staged, target, {}});
            keep_old(moves.back(), staged.parent_path() / ("old-" + std::to_string(moves.size())));
        }
    }
    for (Move& move : moves) {
        if (std::rename(move.staged.c_str(), move.target.c_str()) != 0) {
            const int error = errno;
            // Files that have their names already are taken back, so that all outputs are of one
            // run.
            std::for_each(moves.begin(), moves.end(), undo);
            throw cannot_write(move.target, error);
        }
        move.done = true;
    }
    std::set<fs::path> folders;
    for (const Move& move : moves)
        folders.insert(folder_of(move.target));
    for (const fs::path& folder : folders)
        flush_folder(folder);
}

}  // namespace cleft_cli
