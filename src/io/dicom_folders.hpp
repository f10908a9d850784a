// Folders in which DICOM files lie, also deeper down.
#pragma once

#include <string>
#include <vector>

namespace cleft::io
{

// The regular files of a folder, sorted.
std::vector<std::string> files_in(const std::string& folder);
// As many as are needed to know DICOM.
// Fewer, or none, where the file is short or cannot be read.
std::string first_bytes_of(const std::string& path);
// The folders below this one that hold DICOM files themselves, sorted. Throws if there are too many files
// to look through.
std::vector<std::string> dicom_folders_below(const std::string& folder);
// Says where series are, or how slices of other formats are given.
[[noreturn]] void refuse_folder_without_series(const std::string& folder, const std::vector<std::string>& below);

}  // namespace cleft::io
