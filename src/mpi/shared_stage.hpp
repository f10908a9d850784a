// The files that all ranks write together: all of them or none. They are written into a folder beside their target,
// and take their names when all ranks have written all.
#pragma once

#include "parts/exchange.hpp"

#include <filesystem>
#include <string>
#include <vector>

namespace cleft::mpi
{

class SharedStage
{
public:
    SharedStage() = default;
    // Rank 0 removes the folder, and what has not taken its name. No other rank may be at work in it.
    ~SharedStage();
    SharedStage(const SharedStage&) = delete;
    SharedStage& operator=(const SharedStage&) = delete;

    // Makes the folder. All ranks call it; the target of rank 0 counts. Throws Error.
    void open(const std::string& target, Exchange& exchange);

    // Of the target.
    std::string name() const { return target_.filename().string(); }
    // Where a file is written that is to lie beside the target, or to be it.
    std::string place(const std::string& name) const { return (folder_ / name).string(); }

    // Where it lies in the end.
    std::filesystem::path final_place(const std::string& name) const { return target_.parent_path() / name; }

    // The same as the user says it.
    std::string said_place(const std::string& name) const { return said_ + name; }

    // A sentence about a file in the folder becomes one about the file that the user knows.
    std::string with_final_names(std::string sentence) const;

private:
    std::filesystem::path target_, folder_;
    std::string said_;  // the folder of the target as the user says it, up to its last "/"
    bool is_mine_ = false;
};

// The names of files in a stage.
struct StagedFiles {
    const SharedStage& stage;
    std::vector<std::string> names;
};

// On rank 0 alone, when all ranks have written: gives the files their names, in this order. All or none: if one fails,
// what was there before is put back.
void commit(const std::vector<StagedFiles>& files);

}  // namespace cleft::mpi
