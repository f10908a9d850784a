// One function a format. All ranks call it together.
#pragma once

#include "mpi/part_view.hpp"
#include "mpi/shared_stage.hpp"

#include <functional>
#include <string>
#include <vector>

namespace cleft::mpi
{

// What a writer works with besides the part.
struct Writing {
    const SharedStage& stage;
    Exchange& exchange;
    std::function<void(double fraction)> report;  // throws where a cancel was asked for
};

// The answers are the names of the files in the stage, the target last if it is one of them. All throw Error.
std::vector<std::string> write_mfem(const PartView& part, const Writing& writing);
std::vector<std::string> write_pvtu(const PartView& part, const Writing& writing);
std::vector<std::string> write_vtkhdf(const PartView& part, const Writing& writing);

}  // namespace cleft::mpi
