// What stands at a path, by the system. What it cannot look at, such as a name behind a closed folder or in a circle of
// links, is neither there nor a folder here: the call that opens it tells why.
#pragma once

#include <filesystem>
#include <string>
#include <system_error>

namespace cleft::io
{

inline bool is_there(const std::string& path)
{
    std::error_code ignored;
    return std::filesystem::exists(path, ignored);
}

inline bool is_folder(const std::string& path)
{
    std::error_code ignored;
    return std::filesystem::is_directory(path, ignored);
}

}  // namespace cleft::io
