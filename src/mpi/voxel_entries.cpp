// The functions of cleft_mpi.h that read volumes.
#include "base/struct_size.hpp"
#include "cleft/cleft_mpi.h"
#include "io/entry.hpp"
#include "mpi/hdf5_voxels.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>

template <>
inline constexpr size_t cleft::kFirstSize<cleft_voxels> = CLEFT_END_OF(cleft_voxels, read);

namespace cleft::mpi
{

namespace
{

int read_box(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room, void* user)
{
    return status_of([&] { static_cast<const Hdf5Voxels*>(user)->read(first, count, voxels); },
                     [&](cleft_status status, const char* why) noexcept {
                         if (sentence && room > 0)
                             std::snprintf(sentence, static_cast<size_t>(room), "%s", why);
                         return status;
                     });
}

void warn(cleft_context* context, const std::string& sentence)
{
    io::check(context, cleft_context_log(context, CLEFT_LOG_WARNING, sentence.c_str()));
}

void put_in_world(cleft_context* context, const Hdf5Voxels& voxels, const double* spacing, cleft_voxels& out)
{
    std::array<double, 3> step{1, 1, 1}, origin{0, 0, 0};
    const bool has_spacing = voxels.get_attribute("spacing", step);
    voxels.get_attribute("origin", origin);
    if (spacing)
        std::copy(spacing, spacing + 3, step.begin());
    else if (!has_spacing)
        warn(context,
             "'" + voxels.path() + "': the data set has no attribute 'spacing'; voxels are taken as unit cubes");
    for (size_t i = 0; i < 3; ++i) {
        if (!std::isfinite(step[i]) || step[i] <= 0)
            throw Error(spacing ? CLEFT_ERROR_ARGUMENT : CLEFT_ERROR_FORMAT,
                        "'" + voxels.path() + "': the size of a voxel is not positive along each axis");
        out.affine[5 * i] = step[i];
        out.affine[4 * i + 3] = origin[i];
    }
}

}  // namespace

}  // namespace cleft::mpi

cleft_status cleft_mpi_voxels_open(cleft_context* context, const char* path, const char* dataset, const double* spacing,
                                   cleft_voxels* out) noexcept
{
    return cleft::io::entry(context, {}, [&] {
        cleft::check_struct_size(*cleft::io::required(out, "out"), "cleft_voxels");
        auto voxels =
            std::make_unique<cleft::mpi::Hdf5Voxels>(cleft::io::required(path, "path"), dataset ? dataset : "");
        cleft_voxels made{};
        made.type = voxels->type();
        const auto dims = voxels->dims();
        std::copy(dims.begin(), dims.end(), made.dims);
        cleft::mpi::put_in_world(context, *voxels, spacing, made);
        made.user = voxels.get();
        made.read = cleft::mpi::read_box;
        cleft::copy_out(made, *out);
        (void)voxels.release();  // owned by *out
    });
}

void cleft_mpi_voxels_close(cleft_voxels* voxels) noexcept
{
    if (!voxels || voxels->read != cleft::mpi::read_box)
        return;
    delete static_cast<cleft::mpi::Hdf5Voxels*>(voxels->user);
    voxels->user = nullptr;
    voxels->read = nullptr;
}
