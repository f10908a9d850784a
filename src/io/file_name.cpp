// Takes names of files apart: their extensions, and the common part of TetGen's three names.
#include "io/file_name.hpp"

#include "io/ascii.hpp"

#include <string_view>

namespace cleft::io
{

namespace
{

std::string last_extension(const std::string& name)
{
    const size_t dot = name.rfind('.');
    // A leading dot marks a hidden file (".nii") and no extension.
    return dot == std::string::npos || dot == 0 ? "" : name.substr(dot);
}

}  // namespace

std::string extension_of(const std::string& path)
{
    const std::string name = path.substr(path.find_last_of('/') + 1);
    const std::string extension = in_small_letters(last_extension(name));
    if (extension != ".gz")
        return extension;
    return extension_of(name.substr(0, name.size() - extension.size())) + extension;
}

std::string tetgen_prefix(const std::string& path)
{
    for (const std::string_view extension : {".node", ".ele", ".face"})
        if (extension_of(path) == extension)
            return path.substr(0, path.size() - extension.size());
    return path;
}

}  // namespace cleft::io
