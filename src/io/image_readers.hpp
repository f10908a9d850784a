// The readers of single files, one for each format. `is` knows a format by the first bytes
// of the file; `read` throws Errors that do not name the file. Formats whose voxels
// may be read by parts have a `locate`, and those that may have a tensor at each voxel a function for it.
#pragma once

#include "io/file_head.hpp"
#include "io/stored_image.hpp"
#include "io/tensor_image.hpp"

namespace cleft::io
{

bool is_nrrd(const FileHead& head);
Image read_nrrd(const std::string& path, const FileHead& head);
StoredImage locate_nrrd(const std::string& path, const FileHead& head);
TensorImage read_nrrd_tensors(const std::string& path, const FileHead& head);
bool is_metaimage(const FileHead& head);
Image read_metaimage(const std::string& path, const FileHead& head);
StoredImage locate_metaimage(const std::string& path, const FileHead& head);
bool is_vtk_volume(const FileHead& head);
Image read_vtk_volume(const std::string& path, const FileHead& head);
StoredImage locate_vtk_volume(const std::string& path, const FileHead& head);
TensorImage read_vtk_tensors(const std::string& path, const FileHead& head);
bool is_vti(const FileHead& head);
TensorImage read_vti_tensors(const std::string& path, const FileHead& head);
bool is_gipl(const FileHead& head);
Image read_gipl(const std::string& path, const FileHead& head);
bool is_mrc(const FileHead& head);
Image read_mrc(const std::string& path, const FileHead& head);
bool is_nifti(const FileHead& head);
Image read_nifti(const std::string& path, const FileHead& head);
StoredImage locate_nifti(const std::string& path, const FileHead& head);
TensorImage read_nifti_tensors(const std::string& path, const FileHead& head);
bool is_tiff(const FileHead& head);
Image read_tiff(const std::string& path, const FileHead& head);
bool is_png(const FileHead& head);
Image read_png(const std::string& path, const FileHead& head);
bool is_jpeg(const FileHead& head);
Image read_jpeg(const std::string& path, const FileHead& head);
bool is_bmp(const FileHead& head);
Image read_bmp(const std::string& path, const FileHead& head);
// Formats that are known by name, and which programs turn into others. Always throws.
bool has_foreign_mark(const FileHead& head);  // known by the first bytes
bool is_foreign_format(const FileHead& head);
Image refuse_foreign_format(const std::string& path, const FileHead& head);
// Throws for a mesh of MFEM, whose parts have no extension that would be known. Errors do not name the file.
void refuse_foreign_mesh(const std::string& path);

}  // namespace cleft::io
