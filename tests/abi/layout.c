/* Made by tools/generate.py: what programs that are compiled today rely on, which are places, least sizes and
 * numbers. Compiling this file is the test, on machines of 64 bits. Structs grow at their end, so lines are added and
 * never changed: the generator refuses to take one away. Nothing pads the end of a struct, for a later field would lie
 * in what an older program left there. */
#include <stddef.h>

#include "cleft/cleft.h"
#include "cleft/cleft_io.h"

#define HOLDS(condition) _Static_assert(condition, #condition)
#define PLACE(type, field, offset) HOLDS(offsetof(type, field) == (offset))
#define ENDS_WITH(type, field) HOLDS(sizeof(type) == offsetof(type, field) + sizeof(((type*)0)->field))

#if UINTPTR_MAX == UINT64_MAX
HOLDS(sizeof(cleft_option_description) >= 80);
ENDS_WITH(cleft_option_description, calls);
PLACE(cleft_option_description, struct_size, 0);
PLACE(cleft_option_description, key, 4);
PLACE(cleft_option_description, type, 8);
PLACE(cleft_option_description, name, 16);
PLACE(cleft_option_description, value, 24);
PLACE(cleft_option_description, least, 32);
PLACE(cleft_option_description, greatest, 40);
PLACE(cleft_option_description, choices, 48);
PLACE(cleft_option_description, text, 56);
PLACE(cleft_option_description, group, 64);
PLACE(cleft_option_description, calls, 72);

HOLDS(sizeof(cleft_estimate) >= 40);
ENDS_WITH(cleft_estimate, peak_bytes);
PLACE(cleft_estimate, struct_size, 0);
PLACE(cleft_estimate, is_rough, 4);
PLACE(cleft_estimate, tets, 8);
PLACE(cleft_estimate, whole_tets, 16);
PLACE(cleft_estimate, background_tets, 24);
PLACE(cleft_estimate, peak_bytes, 32);

HOLDS(sizeof(cleft_quality) >= 432);
ENDS_WITH(cleft_quality, dihedral_histogram);
PLACE(cleft_quality, struct_size, 0);
PLACE(cleft_quality, reserved, 4);
PLACE(cleft_quality, tet_count, 8);
PLACE(cleft_quality, min_dihedral, 16);
PLACE(cleft_quality, max_dihedral, 24);
PLACE(cleft_quality, tets_below_5, 32);
PLACE(cleft_quality, tets_below_10, 40);
PLACE(cleft_quality, tets_below_15, 48);
PLACE(cleft_quality, tets_below_20, 56);
PLACE(cleft_quality, tets_above_165, 64);
PLACE(cleft_quality, radius_ratio_median, 72);
PLACE(cleft_quality, radius_ratio_95, 80);
PLACE(cleft_quality, radius_ratio_max, 88);
PLACE(cleft_quality, edge_ratio_max, 96);
PLACE(cleft_quality, min_edge, 104);
PLACE(cleft_quality, mean_edge, 112);
PLACE(cleft_quality, max_edge, 120);
PLACE(cleft_quality, min_volume, 128);
PLACE(cleft_quality, total_volume, 136);
PLACE(cleft_quality, dihedral_histogram, 144);

HOLDS(sizeof(cleft_metric_quality) >= 400);
ENDS_WITH(cleft_metric_quality, dihedral_histogram);
PLACE(cleft_metric_quality, struct_size, 0);
PLACE(cleft_metric_quality, reserved, 4);
PLACE(cleft_metric_quality, tet_count, 8);
PLACE(cleft_metric_quality, edge_count, 16);
PLACE(cleft_metric_quality, edges_in_range, 24);
PLACE(cleft_metric_quality, edge_least, 32);
PLACE(cleft_metric_quality, edge_01, 40);
PLACE(cleft_metric_quality, edge_median, 48);
PLACE(cleft_metric_quality, edge_99, 56);
PLACE(cleft_metric_quality, edge_greatest, 64);
PLACE(cleft_metric_quality, mean_ratio_least, 72);
PLACE(cleft_metric_quality, mean_ratio_01, 80);
PLACE(cleft_metric_quality, mean_ratio_median, 88);
PLACE(cleft_metric_quality, min_dihedral, 96);
PLACE(cleft_metric_quality, max_dihedral, 104);
PLACE(cleft_metric_quality, dihedral_histogram, 112);

HOLDS(sizeof(cleft_validation) >= 128);
ENDS_WITH(cleft_validation, hull_triangles);
PLACE(cleft_validation, struct_size, 0);
PLACE(cleft_validation, valid, 4);
PLACE(cleft_validation, negative_tets, 8);
PLACE(cleft_validation, flat_tets, 16);
PLACE(cleft_validation, repeated_corners, 24);
PLACE(cleft_validation, crowded_faces, 32);
PLACE(cleft_validation, folded_faces, 40);
PLACE(cleft_validation, hull_off_box, 48);
PLACE(cleft_validation, open_interface_edges, 56);
PLACE(cleft_validation, unused_points, 64);
PLACE(cleft_validation, repeated_points, 72);
PLACE(cleft_validation, volume, 80);
PLACE(cleft_validation, box_volume, 88);
PLACE(cleft_validation, hull_area, 96);
PLACE(cleft_validation, box_area, 104);
PLACE(cleft_validation, interface_triangles, 112);
PLACE(cleft_validation, hull_triangles, 120);

HOLDS(sizeof(cleft_label_report) >= 96);
ENDS_WITH(cleft_label_report, large_components_joined);
PLACE(cleft_label_report, struct_size, 0);
PLACE(cleft_label_report, label, 4);
PLACE(cleft_label_report, voxels, 8);
PLACE(cleft_label_report, voxel_volume, 16);
PLACE(cleft_label_report, mesh_volume, 24);
PLACE(cleft_label_report, tets, 32);
PLACE(cleft_label_report, voxel_components, 40);
PLACE(cleft_label_report, mesh_components, 48);
PLACE(cleft_label_report, large_components, 56);
PLACE(cleft_label_report, large_components_lost, 64);
PLACE(cleft_label_report, lost, 72);
PLACE(cleft_label_report, reserved, 76);
PLACE(cleft_label_report, large_components_broken, 80);
PLACE(cleft_label_report, large_components_joined, 88);

HOLDS(sizeof(cleft_contact) >= 24);
ENDS_WITH(cleft_contact, triangles);
PLACE(cleft_contact, struct_size, 0);
PLACE(cleft_contact, first, 4);
PLACE(cleft_contact, second, 8);
PLACE(cleft_contact, reserved, 12);
PLACE(cleft_contact, triangles, 16);

HOLDS(sizeof(cleft_distance) >= 88);
ENDS_WITH(cleft_distance, volume_greatest);
PLACE(cleft_distance, struct_size, 0);
PLACE(cleft_distance, first, 4);
PLACE(cleft_distance, second, 8);
PLACE(cleft_distance, third, 12);
PLACE(cleft_distance, is_line, 16);
PLACE(cleft_distance, reserved, 20);
PLACE(cleft_distance, elements, 24);
PLACE(cleft_distance, points, 32);
PLACE(cleft_distance, mesh_mean, 40);
PLACE(cleft_distance, mesh_99, 48);
PLACE(cleft_distance, mesh_greatest, 56);
PLACE(cleft_distance, volume_mean, 64);
PLACE(cleft_distance, volume_99, 72);
PLACE(cleft_distance, volume_greatest, 80);

HOLDS(sizeof(cleft_io_format_description) >= 40);
ENDS_WITH(cleft_io_format_description, text);
PLACE(cleft_io_format_description, struct_size, 0);
PLACE(cleft_io_format_description, format, 4);
PLACE(cleft_io_format_description, directions, 8);
PLACE(cleft_io_format_description, reserved, 12);
PLACE(cleft_io_format_description, name, 16);
PLACE(cleft_io_format_description, extensions, 24);
PLACE(cleft_io_format_description, text, 32);

HOLDS(sizeof(cleft_io_reading) >= 48);
ENDS_WITH(cleft_io_reading, scale);
PLACE(cleft_io_reading, struct_size, 0);
PLACE(cleft_io_reading, world, 4);
PLACE(cleft_io_reading, kind, 8);
PLACE(cleft_io_reading, reserved, 12);
PLACE(cleft_io_reading, spacing, 16);
PLACE(cleft_io_reading, scale, 40);

HOLDS(sizeof(cleft_io_raw) >= 72);
ENDS_WITH(cleft_io_raw, spacing);
PLACE(cleft_io_raw, struct_size, 0);
PLACE(cleft_io_raw, type, 4);
PLACE(cleft_io_raw, big_endian, 8);
PLACE(cleft_io_raw, kind, 12);
PLACE(cleft_io_raw, skip, 16);
PLACE(cleft_io_raw, dims, 24);
PLACE(cleft_io_raw, spacing, 48);

HOLDS(sizeof(cleft_io_picture) >= 136);
ENDS_WITH(cleft_io_picture, range);
PLACE(cleft_io_picture, struct_size, 0);
PLACE(cleft_io_picture, by, 4);
PLACE(cleft_io_picture, width, 8);
PLACE(cleft_io_picture, height, 12);
PLACE(cleft_io_picture, backdrop, 16);
PLACE(cleft_io_picture, no_edges, 20);
PLACE(cleft_io_picture, legend, 24);
PLACE(cleft_io_picture, reserved, 28);
PLACE(cleft_io_picture, cut, 32);
PLACE(cleft_io_picture, view, 56);
PLACE(cleft_io_picture, up, 80);
PLACE(cleft_io_picture, zoom, 104);
PLACE(cleft_io_picture, line_width, 112);
PLACE(cleft_io_picture, range, 120);

HOLDS(sizeof(cleft_io_view) >= 72);
ENDS_WITH(cleft_io_view, other_report);
PLACE(cleft_io_view, struct_size, 0);
PLACE(cleft_io_view, reserved, 4);
PLACE(cleft_io_view, max_tets, 8);
PLACE(cleft_io_view, goal, 16);
PLACE(cleft_io_view, title, 24);
PLACE(cleft_io_view, report, 32);
PLACE(cleft_io_view, names, 40);
PLACE(cleft_io_view, other, 48);
PLACE(cleft_io_view, other_title, 56);
PLACE(cleft_io_view, other_report, 64);
#endif

HOLDS(sizeof(cleft_io_backdrop) == 4);
HOLDS(sizeof(cleft_io_colouring) == 4);
HOLDS(sizeof(cleft_io_format) == 4);
HOLDS(sizeof(cleft_io_kind) == 4);
HOLDS(sizeof(cleft_io_tensor_order) == 4);
HOLDS(sizeof(cleft_io_world) == 4);
HOLDS(sizeof(cleft_option) == 4);
HOLDS(sizeof(cleft_status) == 4);
HOLDS(sizeof(cleft_type) == 4);

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
HOLDS(CLEFT_ERROR_EXCHANGE == -17);

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
HOLDS(CLEFT_OPTION_MIN_ANGLE == 18);
HOLDS(CLEFT_OPTION_DELAUNAY == 19);
HOLDS(CLEFT_OPTION_SURFACE_ERROR == 20);
HOLDS(CLEFT_OPTION_ANISOTROPY == 21);
HOLDS(CLEFT_OPTION_BLOCK == 22);

HOLDS(CLEFT_BACKGROUND_PARTICLES == 0);
HOLDS(CLEFT_BACKGROUND_LATTICE == 1);
HOLDS(CLEFT_BACKGROUND_OCTREE == 2);

HOLDS(CLEFT_SNAP_QUALITY == 0);
HOLDS(CLEFT_SNAP_SAFE == 1);
HOLDS(CLEFT_SNAP_NONE == 2);

HOLDS(CLEFT_IMPROVE_OFF == 0);
HOLDS(CLEFT_IMPROVE_FAST == 1);
HOLDS(CLEFT_IMPROVE_BEST == 2);

HOLDS(CLEFT_DELAUNAY_CLEFT == 0);
HOLDS(CLEFT_DELAUNAY_TETGEN == 1);

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
HOLDS(CLEFT_FORMAT_VTKHDF == 11);
HOLDS(CLEFT_FORMAT_PVTU == 12);

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

HOLDS(CLEFT_IO_ORDER_FILE == 0);
HOLDS(CLEFT_IO_ORDER_NRRD == 1);
HOLDS(CLEFT_IO_ORDER_VTK == 2);
HOLDS(CLEFT_IO_ORDER_NIFTI == 3);

HOLDS(CLEFT_IO_BY_LABEL == 0);
HOLDS(CLEFT_IO_BY_ANGLE == 1);
HOLDS(CLEFT_IO_BY_RATIO == 2);
HOLDS(CLEFT_IO_BY_SIZE == 3);

HOLDS(CLEFT_IO_BACKDROP_LIGHT == 0);
HOLDS(CLEFT_IO_BACKDROP_DARK == 1);
HOLDS(CLEFT_IO_BACKDROP_NONE == 2);
