// The bound is that of the data of a process, which has all memory that is not a file's or another process's too.
#include "mpi/command/memory_bound.hpp"

#include "cli/exit_code.hpp"

#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace cleft_mpi_cli
{
namespace
{

// Sizes take 15 bytes for each voxel that they are computed from. MPI, HDF5 and the heap take more than 20 MB, whatever
// the volume is.
constexpr double kBytesOfVoxel = 20, kBytesOfProcess = 32 << 20;
// The planes that sizes of a slab are computed from, with the default options: so many times its own, and some more.
constexpr double kTimesOfSlab = 3, kPlanesBeside = 40;
// Thinner slabs have few tetrahedra that are not near a seam.
constexpr int64_t kThinnestSlab = 8;

}  // namespace

uint64_t bytes_of_size(const std::string& text)
{
    static const std::string kUnits = "KMGT";
    char* end = nullptr;
    const double number = std::strtod(text.c_str(), &end);
    const std::string unit = end;
    const std::size_t power = unit.empty() ? std::string::npos : kUnits.find(unit.front());
    const double bytes = power == std::string::npos ? 0 : std::ldexp(number, 10 * (static_cast<int>(power) + 1));
    // No rank has 2^60 bytes.
    if (end == text.c_str() || unit.size() != 1 || !(bytes >= 1 && bytes <= std::ldexp(1, 60)))
        throw cleft_cli::usage_failure("--memory: '" + text +
                                       "' is no size: give a number and K, M, G or T, such as 4G");
    return static_cast<uint64_t>(bytes);
}

void hold_memory_within(uint64_t bytes)
{
    rlimit limit{};
    getrlimit(RLIMIT_DATA, &limit);
    limit.rlim_cur = std::min<rlim_t>(bytes, limit.rlim_max);
    if (setrlimit(RLIMIT_DATA, &limit) != 0)
        throw cleft_cli::Failure(cleft_cli::EXIT_MESHING_FAILED, CLEFT_ERROR_INTERNAL,
                                 "--memory: the system does not bound the memory of a process");
}

int64_t block_within(uint64_t bytes, const std::string& size, const int64_t dims[3])
{
    const double plane = kBytesOfVoxel * static_cast<double>(dims[0]) * static_cast<double>(dims[1]);
    const double planes = (static_cast<double>(bytes) - kBytesOfProcess) / plane;
    const auto fit = static_cast<int64_t>(std::min((planes - kPlanesBeside) / kTimesOfSlab, 1e9));
    const int64_t least = std::min(kThinnestSlab, dims[2]);
    if (fit < least) {
        const double needed = kBytesOfProcess + plane * (kTimesOfSlab * static_cast<double>(least) + kPlanesBeside);
        throw cleft_cli::usage_failure("--memory " + size + " is too little for slabs of " + std::to_string(least) +
                                       " planes of this volume, which take about " +
                                       std::to_string(static_cast<int64_t>(std::ceil(needed / (1 << 20)))) + "M");
    }
    return std::min(fit, std::max(least, dims[2] / 4));
}

}  // namespace cleft_mpi_cli
