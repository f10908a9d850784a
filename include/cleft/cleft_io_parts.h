/*
 * Label maps in files that libcleft_io reads part by part. No process holds the whole volume then. They are for
 * cleft_part_create() in cleft_parts.h, and for any other caller who wants some of the voxels of a file.
 *
 * Conventions are those of cleft_io.h.
 */
#ifndef CLEFT_IO_PARTS_H
#define CLEFT_IO_PARTS_H

#include "cleft/cleft_io.h"
#include "cleft/cleft_parts.h"

#ifdef __cplusplus
extern "C" {
#endif

/** Opens a label map whose voxels lie uncompressed in one file, and fills `out`, whose struct_size the caller sets.
 *  `raw` describes a file without a header; its kind must not be CLEFT_IO_KIND_INDICATORS. If `raw` is NULL, the file
 *  is NRRD, MetaImage, NIfTI, or VTK legacy; docs/formats.md says more.
 *
 *  The size, the world (LPS) and the labels are those that cleft_io_read_volume() or cleft_io_read_raw() gives for the
 *  same file as a label map. Signed bytes become int16, and unsigned numbers of 32 bits and all of 64 bits int32. The
 *  function does not look at the voxels, so it cannot tell a grey image from labels. Names of labels are not read.
 *
 *  out->read() reads from the file, which stays open. It uses no context, so a context that is busy does not hinder
 *  it. It returns 0 or a cleft_status: CLEFT_ERROR_ARGUMENT for voxels outside of the volume, CLEFT_ERROR_FORMAT for a
 *  file that has become shorter or a label beyond 32 bits, CLEFT_ERROR_FILE if the system cannot read. The sentence
 *  names the file.
 *
 *  The log callback gets the warnings about the header. Errors:
 *  - CLEFT_ERROR_UNSUPPORTED for voxels that are compressed, text, floating-point, scaled or in several files, and for
 *    all other formats; the message gives a way to convert the file.
 *  - CLEFT_ERROR_FORMAT for a damaged header, and for a file that is shorter than its header says.
 *  - CLEFT_ERROR_FILE for a file that does not exist or cannot be read.
 *
 *  The caller must pass `out` to cleft_io_voxels_close(). On failure `out` is unchanged. \since 0.1 */
CLEFT_NODISCARD CLEFT_IO_API cleft_status cleft_io_voxels_open(cleft_context* context, const char* path,
                                                               const cleft_io_raw* raw,
                                                               cleft_voxels* out) CLEFT_NOEXCEPT;
/** Closes the file of a label map that cleft_io_voxels_open() opened, and sets `read` and `user` to NULL. A struct of
 *  any other origin is left as it is, also one of zeros; NULL is allowed. \since 0.1 */
CLEFT_IO_API void cleft_io_voxels_close(cleft_voxels* voxels) CLEFT_NOEXCEPT;

#ifdef __cplusplus
}
#endif

#endif
