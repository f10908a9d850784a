// The failures of fields.
#include "io/hdf5_cursor.hpp"

#include "base/error.hpp"

namespace cleft::io
{

uint64_t Hdf5Cursor::version(uint64_t least, uint64_t greatest, const char* structure)
{
    const uint64_t version = byte();
    if (version < least || version > greatest)
        throw Error(CLEFT_ERROR_UNSUPPORTED, std::string("it has ") + structure + " of HDF5 in version " +
                                                 std::to_string(version) + ", which cannot be read");
    return version;
}

void Hdf5Cursor::damaged() { throw Error(CLEFT_ERROR_FORMAT, "it is a damaged HDF5 file"); }

}  // namespace cleft::io
