// An input as files: what reads files by their paths is fuzzed so.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

namespace fuzz
{

// The parts of an input become the files of the list `names` (separated by blanks, "folder/file" too) in a folder of
// this process, which is gone when the process ends. A line "--next file--" is between the parts; files that
// have no part are not there. The answer is the path of that folder, with a slash at its end.
std::string give_files(const uint8_t* data, size_t size, const char* names);

}  // namespace fuzz
