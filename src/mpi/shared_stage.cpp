// Renaming is the work of one rank, so that nothing is half renamed if another one ends.
#include "mpi/shared_stage.hpp"

#include "io/path_kind.hpp"
#include "io/system_failure.hpp"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <system_error>

namespace cleft::mpi
{

namespace fs = std::filesystem;

namespace
{

[[noreturn]] void cannot_write_target(const fs::path& path, int error)
{
    io::throw_system_failure("cannot write '" + path.string() + "'", error);
}

// A folder or a device does not give its place to a file.
void require_regular_or_none(const fs::path& place, const std::string& path)
{
    std::error_code ignored;
    if (io::is_there(place.string()) && !fs::is_regular_file(place, ignored))
        throw Error(CLEFT_ERROR_FILE, "cannot write '" + path + "': it is no regular file");
}

// Links are followed, so that a link stays one.
fs::path file_behind(const std::string& path)
{
    std::error_code error;
    // Without a folder that is there, the answer would be relative.
    fs::path target = fs::weakly_canonical(fs::absolute(path, error), error);
    if (error)
        cannot_write_target(path, error.value());
    require_regular_or_none(target, path);
    return target;
}

// The text that rank 0 has.
std::string text_of_rank_0(const std::string& own, Exchange& exchange)
{
    Array<Array<char>> send(to_size(exchange.ranks()));
    if (exchange.rank() == 0)
        for (Array<char>& text : send)
            text.assign(own.begin(), own.end());
    const Array<char> received = exchange.all_to_all(send).items;
    return {received.begin(), received.end()};
}

// A file that takes its name, and can give it back to the one that had it.
class Renaming
{
public:
    Renaming(fs::path from, fs::path to, fs::path old)
        : from_(std::move(from)), to_(std::move(to)), old_(std::move(old))
    {
    }
    void carry_out()
    {
        had_one_ = std::rename(to_.c_str(), old_.c_str()) == 0;
        if (!had_one_ && errno != ENOENT)
            cannot_write_target(to_, errno);
        if (std::rename(from_.c_str(), to_.c_str()) == 0)
            return;
        const int error = errno;
        take_back();
        cannot_write_target(to_, error);
    }
    // What cannot be put back stays as it is.
    void take_back() noexcept
    {
        if (had_one_)
            (void)std::rename(old_.c_str(), to_.c_str());
        else
            (void)unlink(to_.c_str());
    }

private:
    fs::path from_, to_, old_;
    bool had_one_ = false;
};

}  // namespace

SharedStage::~SharedStage()
{
    std::error_code ignored;
    if (is_mine_)
        fs::remove_all(folder_, ignored);
}

void SharedStage::open(const std::string& target, Exchange& exchange)
{
    if (exchange.rank() == 0) {
        target_ = file_behind(target);
        said_ = target.substr(0, target.rfind('/') + 1);
        // The dot hides it from patterns such as "*", which another program may be reading.
        std::string name = (target_.parent_path() / ".cleft-mpi-XXXXXX").string();
        if (!mkdtemp(name.data()))
            cannot_write_target(target, errno);
        folder_ = name;
        is_mine_ = true;
    }
    target_ = text_of_rank_0(target_.string(), exchange);
    folder_ = text_of_rank_0(folder_.string(), exchange);
    said_ = text_of_rank_0(said_, exchange);
    if (!io::is_folder(folder_.string()))
        throw Error(CLEFT_ERROR_FILE,
                    "cannot write '" + said_ + name() + "': this rank does not see the folder that rank 0 writes to");
}

std::string SharedStage::with_final_names(std::string sentence) const
{
    const std::string prefix = folder_.string() + "/";
    for (size_t at; !folder_.empty() && (at = sentence.find(prefix)) != std::string::npos;)
        sentence.replace(at, prefix.size(), said_);
    return sentence;
}

void commit(const std::vector<StagedFiles>& files)
{
    std::vector<Renaming> all;
    for (const StagedFiles& staged : files)
        for (const std::string& name : staged.names) {
            require_regular_or_none(staged.stage.final_place(name), staged.stage.said_place(name));
            all.emplace_back(staged.stage.place(name), staged.stage.final_place(name),
                             staged.stage.place("old-" + std::to_string(all.size())));
        }
    size_t done = 0;
    try {
        for (; done < all.size(); ++done)
            all[done].carry_out();
    } catch (...) {
        while (done > 0)
            all[--done].take_back();
        throw;
    }
}

}  // namespace cleft::mpi
