/* A small label map, and its bytes in any type and order, for tests of files that are read by parts. */
#ifndef STORED_VOXELS_H
#define STORED_VOXELS_H

#include "folder_fixture.h"

#include "cleft/cleft_io_parts.h"

enum { NX = 5, NY = 4, NZ = 3, VOXELS = NX * NY * NZ };

/* A type in a file: its names and number in three formats, and what the labels of it become. */
typedef struct stored_type {
    const char* nrrd;
    const char* meta;
    int nifti;
    int size;
    cleft_type labels;
    int64_t values[4]; /* the least and the greatest label, and two between */
} stored_type;

static const stored_type stored_types[] = {
    {"uchar", "MET_UCHAR", 2, 1, CLEFT_TYPE_UINT8, {0, 1, 200, 255}},
    {"signed char", "MET_CHAR", 256, 1, CLEFT_TYPE_INT16, {-128, -1, 5, 127}},
    {"ushort", "MET_USHORT", 512, 2, CLEFT_TYPE_UINT16, {0, 0x0102, 0x8001, 65535}},
    {"short", "MET_SHORT", 4, 2, CLEFT_TYPE_INT16, {-32768, -2, 0x0102, 32767}},
    {"uint", "MET_UINT", 768, 4, CLEFT_TYPE_INT32, {0, 0x01020304, 65536, INT32_MAX}},
    {"int", "MET_INT", 8, 4, CLEFT_TYPE_INT32, {INT32_MIN, -5, 0x01020304, INT32_MAX}},
    {"uint64", "MET_ULONG_LONG", 1280, 8, CLEFT_TYPE_INT32, {0, 7, 0x01020304, INT32_MAX}},
    {"int64", "MET_LONG_LONG", 1024, 8, CLEFT_TYPE_INT32, {INT32_MIN, -5, 0x01020304, INT32_MAX}},
};
enum { STORED_TYPES = sizeof stored_types / sizeof *stored_types };

/* Labels without a pattern: a wrong place shows. */
static inline int64_t stored_label(const stored_type* type, int voxel)
{
    return type->values[((uint32_t)(voxel + 1) * 2654435761U) >> 30];
}

static inline void put_whole(uint8_t* to, int64_t value, int size, int big_endian)
{
    for (int b = 0; b < size; ++b)
        to[big_endian ? size - 1 - b : b] = (uint8_t)((uint64_t)value >> (8 * b));
}

/* All voxels, in at most 8 * VOXELS bytes; gives their number. */
static inline size_t put_voxels(uint8_t* to, const stored_type* type, int big_endian)
{
    for (int v = 0; v < VOXELS; ++v)
        put_whole(to + v * type->size, stored_label(type, v), type->size, big_endian);
    return (size_t)(VOXELS * type->size);
}

/* One voxel of what read() gave. */
static inline int64_t label_in(const void* voxels, cleft_type type, int64_t index)
{
    switch (type) {
        case CLEFT_TYPE_UINT8:
            return ((const uint8_t*)voxels)[index];
        case CLEFT_TYPE_UINT16:
            return ((const uint16_t*)voxels)[index];
        case CLEFT_TYPE_INT16:
            return ((const int16_t*)voxels)[index];
        case CLEFT_TYPE_UINT32:
            return ((const uint32_t*)voxels)[index];
        default:
            return ((const int32_t*)voxels)[index];
    }
}

/* Writes a header, and the voxels behind it or in "a.raw" after `skip` bytes. */
static inline const char* written(fixture* f, const char* name, const char* header, const char* skipped,
                                  const stored_type* type, int big_endian)
{
    uint8_t bytes[8 * VOXELS];
    const size_t size = put_voxels(bytes, type, big_endian);
    if (skipped) {
        write_file(path_of(f, "a.raw"), skipped, strlen(skipped), bytes, size);
        write_file(path_of(f, name), header, strlen(header), "", 0);
    } else {
        write_file(path_of(f, name), header, strlen(header), bytes, size);
    }
    return f->path;
}

static inline const char* nrrd_header(const stored_type* type, int big_endian, const char* end)
{
    static char text[1000];
    snprintf(text, sizeof text,
             "NRRD0005\ntype: %s\ndimension: 3\nspace: right-anterior-superior\nsizes: %d %d %d\n"
             "space directions: (0.1,0.2,0) (0,-0.3,0.7) (1,0,1.1)\nspace origin: (1.1,2.3,-0.7)\n"
             "encoding: raw\nendian: %s\n%s",
             type->nrrd, NX, NY, NZ, big_endian ? "big" : "little", end);
    return text;
}

static inline const char* meta_header(const stored_type* type, int big_endian, const char* end)
{
    static char text[1000];
    snprintf(text, sizeof text,
             "ObjectType = Image\nNDims = 3\nDimSize = %d %d %d\nElementType = %s\nElementSpacing = 0.1 0.3 0.7\n"
             "Offset = 1.1 2.3 -0.7\nTransformMatrix = 0 1 0 0.6 0 0.8 0.8 0 -0.6\nBinaryDataByteOrderMSB = %s\n%s",
             NX, NY, NZ, type->meta, big_endian ? "True" : "False", end);
    return text;
}

static inline void put_real(uint8_t* to, float value, int big_endian)
{
    int32_t bits;
    memcpy(&bits, &value, sizeof bits);
    put_whole(to, bits, 4, big_endian);
}

enum { NIFTI_HEADER = 348, NIFTI_VOXELS = 352 + 32 };

/* The header of a single file with an extension, or of one of two. */
static inline void put_nifti_header(uint8_t* to, const stored_type* type, int big, int single, float slope)
{
    static const float rows[12] = {0.1F, 0.2F, 0, 1.1F, 0, -0.3F, 0.7F, 2.3F, 1, 0, 1.1F, -0.7F};
    const int dim[8] = {3, NX, NY, NZ, 1, 1, 1, 1};
    memset(to, 0, NIFTI_VOXELS);
    put_whole(to, NIFTI_HEADER, 4, big);
    for (int i = 0; i < 8; ++i) {
        put_whole(to + 40 + 2 * i, dim[i], 2, big);
        put_real(to + 76 + 4 * i, 1, big);
    }
    put_whole(to + 70, type->nifti, 2, big);
    put_whole(to + 72, 8 * type->size, 2, big);
    put_real(to + 108, single ? NIFTI_VOXELS : 0, big);
    put_real(to + 112, slope, big);
    put_whole(to + 254, 1, 2, big);
    for (int i = 0; i < 12; ++i)
        put_real(to + 280 + 4 * i, rows[i], big);
    memcpy(to + 344, single ? "n+1" : "ni1", 4);
    to[348] = 1;
    put_whole(to + 352, 32, 4, big);
}

static inline cleft_voxels opened(fixture* f, const char* path, const cleft_io_raw* raw)
{
    cleft_voxels voxels = {.struct_size = sizeof voxels};
    if (cleft_io_voxels_open(f->context, path, raw, &voxels) != CLEFT_OK)
        fail_msg("%s", cleft_context_last_error(f->context));
    return voxels;
}

static inline void refuse_open(fixture* f, const char* path, const cleft_io_raw* raw, cleft_status wanted,
                               const char* words)
{
    cleft_voxels voxels = {.struct_size = sizeof voxels};
    assert_refused(f, cleft_io_voxels_open(f->context, path, raw, &voxels), wanted, words);
    assert_null(voxels.user);
    assert_ptr_equal(voxels.read, NULL);
    cleft_io_voxels_close(&voxels);
}

#endif
