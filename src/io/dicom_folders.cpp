// Folders in which DICOM files lie, also deeper down.
#include "io/dicom_folders.hpp"

#include "base/error.hpp"
#include "io/dicom_data.hpp"
#include "io/file_name.hpp"
#include "io/folder_names.hpp"
#include "io/formats.hpp"
#include "io/path_kind.hpp"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

namespace cleft::io
{

namespace fs = std::filesystem;

namespace
{

// The extension as it is written.
std::string last_part(const std::string& path) { return path.substr(path.size() - extension_of(path).size()); }

}  // namespace

std::string first_bytes_of(const std::string& path)
{
    // The preamble of 128 bytes and the prefix "DICM".
    std::string bytes(132, '\0');
    const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
    const ssize_t got = file >= 0 ? read(file, bytes.data(), bytes.size()) : 0;
    if (file >= 0)
        close(file);
    // A file that cannot be opened or read gives no bytes, and so is taken for no DICOM. Folders of
    // scanners hold files of other users.
    bytes.resize(static_cast<size_t>(std::max<ssize_t>(0, got)));
    return bytes;
}

namespace
{

// Files of the system that have no size may keep their readers waiting.
bool has_bytes(const std::string& path)
{
    struct stat status {
    };
    // stat() follows links: a link to a slice is a slice.
    return stat(path.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_size > 0;
}

// A link to a folder is not followed: it may lead back up, and the search would not end.
bool is_folder_itself(const std::string& path)
{
    struct stat status {
    };
    return lstat(path.c_str(), &status) == 0 && S_ISDIR(status.st_mode);
}

// Of a folder that a search comes across. Folders of other users are closed, and the search goes on.
std::vector<std::string> names_if_open(const std::string& folder)
{
    try {
        return names_in(folder);
    } catch (const Error&) {
        return {};
    }
}

std::string joined(const std::string& folder, const std::string& name) { return (fs::path(folder) / name).string(); }

}  // namespace

std::vector<std::string> files_in(const std::string& folder)
{
    std::vector<std::string> paths;
    for (const std::string& name : names_in(folder))
        if (has_bytes(joined(folder, name)))
            paths.push_back(joined(folder, name));
    return paths;
}

std::vector<std::string> dicom_folders_below(const std::string& folder)
{
    // A study has some thousands of files. A search through a home folder or a whole disk, where
    // the path was a mistake, ends here within seconds.
    constexpr int kMostFiles = 20000;
    std::set<std::string> found;
    std::vector<std::string> folders = {folder};
    int files = 0;
    while (!folders.empty()) {
        const std::string parent = folders.back();
        folders.pop_back();
        for (const std::string& name : names_if_open(parent)) {
            const std::string path = joined(parent, name);
            if (++files > kMostFiles)
                throw Error(CLEFT_ERROR_FILE,
                            "the folder holds no DICOM series, and too many files below it to look "
                            "through: give the folder of a series");
            if (is_folder_itself(path))
                folders.push_back(path);
            else if (parent != folder && found.count(parent) == 0 && has_bytes(path) &&
                     is_dicom_head(first_bytes_of(path)))
                // One DICOM file makes a folder a candidate; the first test spares opening all the
                // others.
                found.insert(parent);
        }
    }
    return {found.begin(), found.end()};
}

void refuse_folder_without_series(const std::string& folder, const std::vector<std::string>& below)
{
    // As many as a message can list and still be read.
    constexpr size_t kNamed = 8;
    std::string sentence = "the folder holds no DICOM series";
    if (!below.empty()) {
        sentence += ", but " + std::to_string(below.size()) + " folders in it hold some; give one of them:";
        for (size_t i = 0; i < std::min(kNamed, below.size()); ++i)
            sentence += std::string(i > 0 ? ", '" : " '") + below[i] + "'";
        throw Error(CLEFT_ERROR_FILE, sentence + (below.size() > kNamed ? " ..." : ""));
    }
    // The files by which Zarr versions 2 and 3 mark an array or a group. They have no data that any
    // other reader here could find.
    for (const char* name : {".zarray", ".zgroup", ".zattrs", "zarr.json"})
        if (is_there(joined(folder, name)))
            throw Error(CLEFT_ERROR_UNSUPPORTED,
                        "it is a Zarr store, which cannot be read: read its array by zarr and "
                        "save it as .nii.gz or .nrrd");
    for (const std::string& path : files_in(folder))
        if (is_volume_path(path))
            throw Error(CLEFT_ERROR_FILE, sentence + "; slices in files of their own are given by a pattern, as '" +
                                              (fs::path(folder) / ("*" + last_part(path))).string() + "'");
    throw Error(CLEFT_ERROR_FILE, sentence);
}

}  // namespace cleft::io
