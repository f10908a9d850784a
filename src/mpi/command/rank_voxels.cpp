// A file has its voxels from the component of files, or from that of MPI, which knows HDF5.
#include "mpi/command/rank_voxels.hpp"

#include "cleft/cleft_io_parts.h"
#include "cleft/cleft_mpi.h"

#include <cmath>

namespace cleft_mpi_cli
{
namespace
{

// The origin stays that of the file.
void set_spacing(cleft_voxels& voxels, const std::vector<double>& spacing)
{
    for (std::size_t axis = 0; axis < spacing.size(); ++axis) {
        double* const step = voxels.affine + axis;
        const double factor = spacing[axis] / std::hypot(step[0], step[4], step[8]);
        for (const int row : {0, 4, 8})
            step[row] *= factor;
    }
}

}  // namespace

void CloseVoxels::operator()(cleft_voxels* voxels) const
{
    // Each leaves the other's as it is.
    cleft_mpi_voxels_close(voxels);
    cleft_io_voxels_close(voxels);
    delete voxels;
}

Voxels open_voxels(const cleft_cli::Session& session, const PartsArguments& arguments)
{
    Voxels voxels(new cleft_voxels{});
    voxels->struct_size = sizeof *voxels;
    const char* path = arguments.input().c_str();
    const std::vector<double>& spacing = arguments.volume.spacing;
    if (arguments.is_hdf5()) {
        session.check(cleft_mpi_voxels_open(session.context(), path,
                                            arguments.dataset.empty() ? nullptr : arguments.dataset.c_str(),
                                            spacing.empty() ? nullptr : spacing.data(), voxels.get()),
                      cleft_cli::EXIT_CANNOT_READ);
        return voxels;
    }
    const cleft_io_raw raw = arguments.volume.raw();
    const bool is_raw = !arguments.volume.dims.empty();
    session.check(cleft_io_voxels_open(session.context(), path, is_raw ? &raw : nullptr, voxels.get()),
                  cleft_cli::EXIT_CANNOT_READ);
    if (!is_raw)
        set_spacing(*voxels, spacing);
    return voxels;
}

int NotedVoxels::read(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                      void* user)
{
    auto& self = *static_cast<NotedVoxels*>(user);
    const int failed = self.of_.read(first, count, voxels, sentence, room, self.of_.user);
    self.have_failed_ = self.have_failed_ || failed != 0;
    return failed;
}

}  // namespace cleft_mpi_cli
