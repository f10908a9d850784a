// HDF5 keeps what went wrong on a stack of errors: the innermost one has the reason.
#include "mpi/hdf5.hpp"

#include "base/error.hpp"

#include <string>

namespace cleft::mpi
{

namespace
{

herr_t take_innermost(unsigned depth, const H5E_error2_t* error, void* reason)
{
    // The walk begins with the innermost.
    if (depth == 0 && error->desc)
        *static_cast<std::string*>(reason) = error->desc;
    return 0;
}

}  // namespace

QuietHdf5::QuietHdf5()
{
    H5Eget_auto2(H5E_DEFAULT, &function_, &data_);
    H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
}

QuietHdf5::~QuietHdf5() { H5Eset_auto2(H5E_DEFAULT, function_, data_); }

void throw_hdf5_failure()
{
    std::string reason;
    H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, take_innermost, &reason);
    throw Error(CLEFT_ERROR_FILE, reason.empty() ? "HDF5 does not tell why" : reason);
}

}  // namespace cleft::mpi
