// Writing that ends no process: a limit on the size of files is met with an error, not with a signal.
#pragma once

#include <cstddef>

namespace cleft::io
{

// Writes all bytes. The answer is 0 or the error number; EFBIG where RLIMIT_FSIZE does not allow more. SIGXFSZ, which
// by default ends the process, is kept from the calling thread meanwhile.
int write_quietly(int descriptor, const char* bytes, size_t count) noexcept;

}  // namespace cleft::io
