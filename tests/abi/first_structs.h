/* The structs of the C interface as programs were compiled with that were built early (commit 6f1bd40): today's library
 * must serve them. Structs that came later begin with the form that they had in their first release. */
#ifndef CLEFT_TESTS_FIRST_STRUCTS_H
#define CLEFT_TESTS_FIRST_STRUCTS_H

#include <stdint.h>

typedef struct first_option_description {
    uint32_t struct_size;
    int32_t key;
    int32_t type;
    const char* name;
    double value;
    double least;
    double greatest;
    const char* choices;
    const char* text;
} first_option_description;

typedef struct first_quality {
    uint32_t struct_size;
    uint32_t reserved;
    int64_t tet_count;
    double min_dihedral;
    double max_dihedral;
    int64_t tets_below_5;
    int64_t tets_below_10;
    int64_t tets_below_15;
    int64_t tets_below_20;
    int64_t tets_above_165;
    double radius_ratio_median;
    double radius_ratio_95;
    double radius_ratio_max;
    double edge_ratio_max;
    double min_edge;
    double mean_edge;
    double max_edge;
    double min_volume;
    double total_volume;
    int64_t dihedral_histogram[36];
} first_quality;

typedef struct first_validation {
    uint32_t struct_size;
    int32_t valid;
    int64_t negative_tets;
    int64_t flat_tets;
    int64_t repeated_corners;
    int64_t crowded_faces;
    int64_t folded_faces;
    int64_t hull_off_box;
    int64_t open_interface_edges;
    int64_t unused_points;
    int64_t repeated_points;
    double volume;
    double box_volume;
    double hull_area;
    double box_area;
} first_validation;

typedef struct first_label_report {
    uint32_t struct_size;
    int32_t label;
    int64_t voxels;
    double voxel_volume;
    double mesh_volume;
    int64_t tets;
    int64_t voxel_components;
    int64_t mesh_components;
    int64_t large_components;
    int64_t large_components_lost;
    int32_t lost;
    int32_t large_components_broken;
} first_label_report;

typedef struct first_contact {
    uint32_t struct_size;
    int32_t first;
    int32_t second;
    int32_t reserved;
    int64_t triangles;
} first_contact;

typedef struct first_io_format_description {
    uint32_t struct_size;
    int32_t format;
    int32_t directions;
    int32_t reserved;
    const char* name;
    const char* extensions;
    const char* text;
} first_io_format_description;

typedef struct first_io_reading {
    uint32_t struct_size;
    int32_t world;
    int32_t kind;
    int32_t reserved;
    double spacing[3];
} first_io_reading;

typedef struct first_io_raw {
    uint32_t struct_size;
    int32_t type;
    int32_t big_endian;
    int32_t reserved;
    int64_t skip;
    int64_t dims[3];
    double spacing[3];
} first_io_raw;

typedef struct first_io_picture {
    uint32_t struct_size;
    int32_t by;
    int32_t width;
    int32_t height;
    int32_t backdrop;
    int32_t no_edges;
    int32_t legend;
    int32_t reserved;
    double cut[3];
    double view[3];
    double up[3];
    double zoom;
    double line_width;
    double range[2];
} first_io_picture;

typedef struct first_io_view {
    uint32_t struct_size;
    int32_t reserved;
    int64_t max_tets;
    double goal;
    const char* title;
    const char* report;
    const char* names;
    const void* other;
    const char* other_title;
    const char* other_report;
} first_io_view;

#endif
