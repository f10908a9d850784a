// Volumes of DICOM: one file, or the series in a folder.
#pragma once

#include "io/file_head.hpp"
#include "io/image.hpp"

#include <string>

namespace cleft::io
{

// By the prefix "DICM", or by a first element where a file has no preamble.
bool is_dicom(const FileHead& head);
// Errors do not name the file.
Image read_dicom_image(const std::string& path, const FileHead& head);
// The one series of a folder, its slices in the order of their places. Errors do not name the folder.
Image read_dicom_folder(const std::string& folder);

}  // namespace cleft::io
