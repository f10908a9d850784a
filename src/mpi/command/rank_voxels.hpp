// The voxels of a run, which each rank reads for itself.
#pragma once

#include "cleft/cleft_parts.h"
#include "cli/session.hpp"
#include "mpi/command/parts_arguments.hpp"

#include <memory>

namespace cleft_mpi_cli
{

struct CloseVoxels {
    void operator()(cleft_voxels* voxels) const;
};
using Voxels = std::unique_ptr<cleft_voxels, CloseVoxels>;

// Throws a Failure with the code of an input that cannot be read.
Voxels open_voxels(const cleft_cli::Session& session, const PartsArguments& arguments);

// The voxels as they are read, and whether that has failed: scratch files that cannot be written have the same status.
class NotedVoxels
{
public:
    explicit NotedVoxels(const cleft_voxels& of) : of_(of), noted_(of)
    {
        noted_.read = read;
        noted_.user = this;
    }
    const cleft_voxels* voxels() const { return &noted_; }
    bool have_failed() const { return have_failed_; }

private:
    static int read(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                    void* user);

    const cleft_voxels& of_;
    cleft_voxels noted_;
    bool have_failed_ = false;
};

}  // namespace cleft_mpi_cli
