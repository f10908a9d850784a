// Folders in which DICOM files lie, also deeper down.
#include "io/dicom_folders.hpp"

#include "base/error.hpp"
#include "io/dicom_data.hpp"
#include "io/file_name.hpp"
#include "io/formats.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
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
    std::string bytes(132, '\0');
    std::ifstream file(path, std::ios::binary);
    file.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<size_t>(file.gcount()));
    return bytes;
}

namespace
{

// Files of the system that have no size may keep their readers waiting.
bool has_bytes(const fs::directory_entry& entry)
{
    std::error_code error;
    return entry.is_regular_file(error) && entry.file_size(error) > 0 && !error;
}

}  // namespace

std::vector<std::string> files_in(const std::string& folder)
{
    std::vector<std::string> paths;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error))
        if (has_bytes(entry))
            paths.push_back(entry.path().string());
    std::sort(paths.begin(), paths.end());
    return paths;
}

std::vector<std::string> dicom_folders_below(const std::string& folder)
{
    constexpr int most_files = 20000;
    std::set<std::string> found;
    std::error_code error;
    int files = 0;
    for (auto at = fs::recursive_directory_iterator(folder, fs::directory_options::skip_permission_denied, error);
         !error && at != fs::recursive_directory_iterator(); at.increment(error)) {
        const std::string parent = at->path().parent_path().string();
        if (++files > most_files)
            throw Error(CLEFT_ERROR_FILE,
                        "the folder holds no DICOM series, and too many files below it to look "
                        "through: give the folder of a series");
        if (at.depth() > 0 && found.count(parent) == 0 && has_bytes(*at) &&
            is_dicom_head(first_bytes_of(at->path().string())))
            found.insert(parent);
    }
    return {found.begin(), found.end()};
}

void refuse_folder_without_series(const std::string& folder, const std::vector<std::string>& below)
{
    constexpr size_t told = 8;
    std::string sentence = "the folder holds no DICOM series";
    if (!below.empty()) {
        sentence += ", but " + std::to_string(below.size()) + " folders in it hold some; give one of them:";
        for (size_t i = 0; i < std::min(told, below.size()); ++i)
            sentence += std::string(i > 0 ? ", '" : " '") + below[i] + "'";
        throw Error(CLEFT_ERROR_FILE, sentence + (below.size() > told ? " ..." : ""));
    }
    for (const char* name : {".zarray", ".zgroup", ".zattrs", "zarr.json"})
        if (fs::exists(fs::path(folder) / name))
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
