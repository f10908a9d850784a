/* What programs that are compiled today rely on: places, least sizes and numbers. Compiling this file is the test,
 * on machines of 64 bits. Structs grow at their end: lines are added, never changed. */
#include <stddef.h>

#include "cleft/cleft.h"
#include "cleft/cleft_io.h"

#define HOLDS(condition) _Static_assert(condition, #condition)
#define PLACE(type, field, offset) HOLDS(offsetof(type, field) == (offset))

#if UINTPTR_MAX == UINT64_MAX
HOLDS(sizeof(cleft_option_description) >= 64);
PLACE(cleft_option_description, name, 16);
PLACE(cleft_option_description, value, 24);
PLACE(cleft_option_description, text, 56);
HOLDS(sizeof(cleft_io_format_description) >= 40);
PLACE(cleft_io_format_description, name, 16);
#endif

HOLDS(sizeof(cleft_quality) >= 432);
PLACE(cleft_quality, tet_count, 8);
PLACE(cleft_quality, min_dihedral, 16);
PLACE(cleft_quality, radius_ratio_median, 72);
PLACE(cleft_quality, total_volume, 136);
PLACE(cleft_quality, dihedral_histogram, 144);

HOLDS(sizeof(cleft_validation) >= 128);
PLACE(cleft_validation, valid, 4);
PLACE(cleft_validation, negative_tets, 8);
PLACE(cleft_validation, volume, 80);
PLACE(cleft_validation, interface_triangles, 112);

HOLDS(sizeof(cleft_label_report) >= 96);
PLACE(cleft_label_report, label, 4);
PLACE(cleft_label_report, voxel_volume, 16);
PLACE(cleft_label_report, lost, 72);
PLACE(cleft_label_report, large_components_broken, 80);
PLACE(cleft_label_report, large_components_joined, 88);

HOLDS(sizeof(cleft_contact) >= 24);
PLACE(cleft_contact, first, 4);
PLACE(cleft_contact, triangles, 16);

HOLDS(sizeof(cleft_io_reading) >= 48);
PLACE(cleft_io_reading, spacing, 16);
PLACE(cleft_io_reading, scale, 40);
HOLDS(sizeof(cleft_io_raw) >= 72);
PLACE(cleft_io_raw, skip, 16);
PLACE(cleft_io_raw, dims, 24);
PLACE(cleft_io_raw, spacing, 48);

HOLDS(sizeof(cleft_status) == 4 && sizeof(cleft_option) == 4 && sizeof(cleft_type) == 4);

HOLDS(CLEFT_OK == 0);
HOLDS(CLEFT_ERROR_INTERNAL == -1);
HOLDS(CLEFT_ERROR_OUT_OF_MEMORY == -2);
HOLDS(CLEFT_ERROR_CANCELLED == -3);
HOLDS(CLEFT_ERROR_NULL == -4);
HOLDS(CLEFT_ERROR_ARGUMENT == -5);
HOLDS(CLEFT_ERROR_NOT_FINITE == -6);
HOLDS(CLEFT_ERROR_TOO_LARGE == -7);
HOLDS(CLEFT_ERROR_BUFFER == -8);
HOLDS(CLEFT_ERROR_OPTION == -9);
HOLDS(CLEFT_ERROR_UNSUPPORTED == -10);
HOLDS(CLEFT_ERROR_INVALID_MESH == -11);
HOLDS(CLEFT_ERROR_LABEL_LOST == -12);
HOLDS(CLEFT_ERROR_FILE == -13);
HOLDS(CLEFT_ERROR_FORMAT == -14);
HOLDS(CLEFT_ERROR_HANDLE == -15);
HOLDS(CLEFT_ERROR_BUSY == -16);

HOLDS(CLEFT_LOG_WARNING == 1);
HOLDS(CLEFT_LOG_INFO == 2);
HOLDS(CLEFT_LOG_DEBUG == 3);

HOLDS(CLEFT_OPTION_BACKGROUND == 1);
HOLDS(CLEFT_OPTION_SIZE == 2);
HOLDS(CLEFT_OPTION_SIZE_MIN == 3);
HOLDS(CLEFT_OPTION_SIZE_MAX == 4);
HOLDS(CLEFT_OPTION_FEATURE_SCALE == 5);
HOLDS(CLEFT_OPTION_GRADATION == 6);
HOLDS(CLEFT_OPTION_INTERFACE_SIZE == 7);
HOLDS(CLEFT_OPTION_TETS == 8);
HOLDS(CLEFT_OPTION_SMOOTH == 9);
HOLDS(CLEFT_OPTION_SNAP == 10);
HOLDS(CLEFT_OPTION_IMPROVE == 11);
HOLDS(CLEFT_OPTION_STEPS == 12);
HOLDS(CLEFT_OPTION_SEED == 13);
HOLDS(CLEFT_OPTION_STRICT == 14);
HOLDS(CLEFT_OPTION_REPAIR == 15);
HOLDS(CLEFT_OPTION_MAX_TETS == 16);
HOLDS(CLEFT_OPTION_KEEP_THIN == 17);

HOLDS(CLEFT_BACKGROUND_PARTICLES == 0);
HOLDS(CLEFT_BACKGROUND_LATTICE == 1);
HOLDS(CLEFT_BACKGROUND_OCTREE == 2);

HOLDS(CLEFT_SNAP_QUALITY == 0);
HOLDS(CLEFT_SNAP_SAFE == 1);
HOLDS(CLEFT_SNAP_NONE == 2);

HOLDS(CLEFT_IMPROVE_OFF == 0);
HOLDS(CLEFT_IMPROVE_FAST == 1);
HOLDS(CLEFT_IMPROVE_BEST == 2);

HOLDS(CLEFT_OPTION_TYPE_INTEGER == 1);
HOLDS(CLEFT_OPTION_TYPE_REAL == 2);
HOLDS(CLEFT_OPTION_TYPE_CHOICE == 3);
HOLDS(CLEFT_OPTION_TYPE_FLAG == 4);

HOLDS(CLEFT_TYPE_UINT8 == 1);
HOLDS(CLEFT_TYPE_UINT16 == 2);
HOLDS(CLEFT_TYPE_INT16 == 3);
HOLDS(CLEFT_TYPE_UINT32 == 4);
HOLDS(CLEFT_TYPE_INT32 == 5);
HOLDS(CLEFT_TYPE_FLOAT32 == 6);
HOLDS(CLEFT_TYPE_FLOAT64 == 7);

HOLDS(CLEFT_SIDE_X_MIN == 0);
HOLDS(CLEFT_SIDE_X_MAX == 1);
HOLDS(CLEFT_SIDE_Y_MIN == 2);
HOLDS(CLEFT_SIDE_Y_MAX == 3);
HOLDS(CLEFT_SIDE_Z_MIN == 4);
HOLDS(CLEFT_SIDE_Z_MAX == 5);
HOLDS(CLEFT_SIDE_OTHER == 6);

HOLDS(CLEFT_FORMAT_BY_NAME == 0);
HOLDS(CLEFT_FORMAT_VTU == 1);
HOLDS(CLEFT_FORMAT_VTP == 2);
HOLDS(CLEFT_FORMAT_VTK == 3);
HOLDS(CLEFT_FORMAT_MEDIT == 4);
HOLDS(CLEFT_FORMAT_MSH41 == 5);
HOLDS(CLEFT_FORMAT_MSH22 == 6);
HOLDS(CLEFT_FORMAT_ABAQUS == 7);
HOLDS(CLEFT_FORMAT_TETGEN == 8);
HOLDS(CLEFT_FORMAT_STL == 9);
HOLDS(CLEFT_FORMAT_PLY == 10);

HOLDS(CLEFT_IO_READS_MESH == 1);
HOLDS(CLEFT_IO_WRITES_MESH == 2);
HOLDS(CLEFT_IO_READS_VOLUME == 4);
HOLDS(CLEFT_IO_WRITES_SIZING == 8);

HOLDS(CLEFT_IO_UNKNOWN == 0);
HOLDS(CLEFT_IO_VOLUME == 1);
HOLDS(CLEFT_IO_MESH == 2);

HOLDS(CLEFT_IO_WORLD_LPS == 0);
HOLDS(CLEFT_IO_WORLD_RAS == 1);

HOLDS(CLEFT_IO_KIND_AUTO == 0);
HOLDS(CLEFT_IO_KIND_LABELS == 1);
HOLDS(CLEFT_IO_KIND_INDICATORS == 2);
