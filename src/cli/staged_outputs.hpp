// The files of a run: all of them or none. Each is written into a folder of its own beside its target, and takes its
// name when all are written.
#pragma once

#include "exit_code.hpp"

#include <dirent.h>

#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace cleft_cli
{

class StagedOutputs
{
public:
    StagedOutputs() = default;
    // Removes what was not committed.
    ~StagedOutputs();
    StagedOutputs(const StagedOutputs&) = delete;
    StagedOutputs& operator=(const StagedOutputs&) = delete;

    // Calls write(place) with the place to write to the file that is to be at `path`. It may put further files beside,
    // which go along. The sentence of a Failure that it throws has the paths that the user knows.
    void write(const std::string& path, const std::function<void(const std::string& place)>& write);
    // Where others write the file that is to be at `path`. The paths in their failures are those of described().
    std::string place(const std::string& path) { return add(path).staged.string(); }
    // The failure with the paths that the user knows.
    Failure described(const Failure& failure) const;
    // Of the file that was written for `path`.
    // 0 where it cannot be looked at.
    double bytes(const std::string& path) const;
    // Gives the files their names. All or none: if one fails, what was there before is put back.
    void commit();
    // Removes what no StagedOutputs of the process has committed, where the process ends without destructors. A signal
    // handler may call it.
    static void remove_all() noexcept;

private:
    // A folder of its own in `folder`, which goes with it. It stays open: nothing asks for memory when it goes.
    class Stage
    {
    public:
        Stage(const std::filesystem::path& folder, const std::string& output);
        ~Stage();
        Stage(const Stage&) = delete;
        Stage& operator=(const Stage&) = delete;
        std::filesystem::path path() const { return path_; }
        std::vector<std::string> names() const;  // sorted
        void remove() noexcept;

        static Stage* newest;  // the others follow
        Stage* next = nullptr;

    private:
        std::string path_;  // a path would ask for memory when the folder is there and in no list yet
        DIR* listing_ = nullptr;
    };
    struct Output {
        std::string path;
        std::unique_ptr<Stage> stage;  // in the folder of its target
        std::filesystem::path staged;  // in the stage
    };
    const Output& add(const std::string& path);
    // The staged file, or a copy of it from where a rename to the target goes.
    std::filesystem::path near(const std::filesystem::path& staged, const std::filesystem::path& target);
    std::vector<Output> outputs_;
    std::vector<std::unique_ptr<Stage>> copies_;
};

// The file that a path stands for: symbolic links are followed, also where nothing is behind.
std::filesystem::path link_target(const std::string& path);
// "." for a name without a folder.
std::filesystem::path folder_of(const std::filesystem::path& path);

}  // namespace cleft_cli
