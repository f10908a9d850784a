// Lists folders by the calls of the system.
#include "io/folder_names.hpp"

#include <dirent.h>

#include <algorithm>
#include <cerrno>
#include <memory>
#include <new>

namespace cleft::io
{

std::vector<std::string> names_in(const std::string& folder)
{
    const std::unique_ptr<DIR, int (*)(DIR*)> listing(opendir(folder.c_str()), closedir);
    if (!listing && errno == ENOMEM)
        throw std::bad_alloc();
    std::vector<std::string> names;
    // readdir() gives no order. Sorting makes series and messages the same on every file system.
    while (const dirent* entry = listing ? readdir(listing.get()) : nullptr) {
        const std::string name = entry->d_name;
        if (name != "." && name != "..")
            names.push_back(name);
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace cleft::io
