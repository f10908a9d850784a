// Lists folders by the calls of the system.
#include "io/folder_names.hpp"

#include "io/system_failure.hpp"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>

namespace cleft::io
{

std::vector<std::string> names_in(const std::string& folder)
{
    const std::unique_ptr<DIR, int (*)(DIR*)> listing(opendir(folder.c_str()), closedir);
    // A closed folder is not an empty one.
    if (!listing)
        throw_system_failure("the folder '" + folder + "' cannot be read", errno);
    std::vector<std::string> names;
    // readdir() gives no order. Sorting makes series and messages the same on every file system.
    while (const dirent* entry = readdir(listing.get())) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..")
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace cleft::io
