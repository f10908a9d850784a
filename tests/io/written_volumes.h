/* Volumes of one layout for tests of readers: every type of voxels, encoding and order of bytes, as NRRD, MetaImage and
 * legacy VTK. */
#ifndef WRITTEN_VOLUMES_H
#define WRITTEN_VOLUMES_H

#include "folder.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>
#include <zlib.h>

enum { NX = 3, NY = 2, NZ = 2, VOXELS = NX * NY * NZ, ROOM = 1 << 16 };

typedef struct fixture {
    cleft_context* context;
    char folder[FOLDER_NAME];
    char path[128];
    unsigned char bytes[ROOM];
    size_t size;
} fixture;

typedef enum encoding { RAW, DEFLATED, TEXT, HEX } encoding;

typedef struct type {
    const char* nrrd; /* its names, separated by '|' */
    const char* meta; /* the same */
    const char* vtk;
    int size;
    int is_signed;
    int is_real;
} type;

static const type types[] = {
    {"signed char|int8|int8_t", "MET_CHAR", "char", 1, 1, 0},
    {"uchar|unsigned char|uint8|uint8_t|UCHAR", "MET_UCHAR", "unsigned_char", 1, 0, 0},
    {"short|short int|signed short|signed short int|int16|int16_t", "MET_SHORT", "short", 2, 1, 0},
    {"ushort|unsigned short|unsigned short int|uint16|uint16_t", "MET_USHORT", "unsigned_short", 2, 0, 0},
    {"int|signed int|int32|int32_t", "MET_INT|MET_LONG", "int|vtkIdType|vtktypeint32", 4, 1, 0},
    {"uint|unsigned int|uint32|uint32_t", "MET_UINT|MET_ULONG", "unsigned_int", 4, 0, 0},
    {"longlong|long long|long long int|signed long long|signed long long int|int64|int64_t", "MET_LONG_LONG",
     "long|vtktypeint64", 8, 1, 0},
    {"ulonglong|unsigned long long|unsigned long long int|uint64|uint64_t", "MET_ULONG_LONG",
     "unsigned_long|vtktypeuint64", 8, 0, 0},
    {"float", "MET_FLOAT", "float", 4, 1, 1},
    {"double", "MET_DOUBLE", "double", 8, 1, 1},
};

static inline int set_up(void** state)
{
    fixture* f = calloc(1, sizeof *f);
    *state = f;
    return make_folder(f->folder, &f->context);
}

static inline int tear_down(void** state)
{
    fixture* f = *state;
    const int removed = remove_folder(f->folder);
    cleft_context_destroy(f->context);
    free(f);
    return removed;
}

static inline void put(fixture* f, const void* data, size_t size)
{
    assert_true(f->size + size <= ROOM);
    memcpy(f->bytes + f->size, data, size);
    f->size += size;
}

static inline void put_text(fixture* f, const char* format, ...)
{
    char text[1024];
    va_list list;
    va_start(list, format);
    const int size = vsnprintf(text, sizeof text, format, list);
    va_end(list);
    put(f, text, (size_t)size);
}

static inline const char* store(fixture* f, const char* name, size_t size)
{
    snprintf(f->path, sizeof f->path, "%s/%s", f->folder, name);
    FILE* file = fopen(f->path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(f->bytes, 1, size, file), size);
    fclose(file);
    return f->path;
}

/* Labels that tell whether bytes are in order and signs are kept; the last one is a single digit. */
static inline int64_t label_of(const type* t, int voxel)
{
    static const int64_t small[4] = {0, 1, 100, 7};
    if (voxel == 2 && t->is_signed)
        return -5;
    if (voxel == 3 && t->size > 1)
        return 0x1234;
    if (voxel == 5 && t->size > 2)
        return 0x123456;
    return small[voxel % 4];
}

/* The voxels as bytes in memory order. */
static inline size_t native_voxels(const type* t, unsigned char* out)
{
    for (int v = 0; v < VOXELS; ++v) {
        const int64_t label = label_of(t, v);
        const float narrow = (float)label;
        const double wide = (double)label;
        const void* from = !t->is_real ? (const void*)&label : t->size == 4 ? (const void*)&narrow : &wide;
        memcpy(out + (size_t)v * (size_t)t->size, from, (size_t)t->size); /* little-endian machines */
    }
    return (size_t)VOXELS * (size_t)t->size;
}

static inline void swap(unsigned char* voxels, int size)
{
    for (int v = 0; v < VOXELS; ++v)
        for (int i = 0; i < size / 2; ++i) {
            unsigned char* at = voxels + v * size;
            const unsigned char kept = at[i];
            at[i] = at[size - 1 - i];
            at[size - 1 - i] = kept;
        }
}

static inline void put_deflated(fixture* f, const unsigned char* data, size_t size, int as_gzip)
{
    unsigned char out[4096];
    z_stream stream;
    memset(&stream, 0, sizeof stream);
    assert_int_equal(deflateInit2(&stream, 9, Z_DEFLATED, as_gzip ? 15 + 16 : 15, 8, Z_DEFAULT_STRATEGY), Z_OK);
    stream.next_in = (Bytef*)(uintptr_t)data;
    stream.avail_in = (uInt)size;
    stream.next_out = out;
    stream.avail_out = sizeof out;
    assert_int_equal(deflate(&stream, Z_FINISH), Z_STREAM_END);
    put(f, out, stream.total_out);
    deflateEnd(&stream);
}

static inline void put_voxels(fixture* f, const type* t, encoding how, int big_endian, int as_gzip)
{
    unsigned char voxels[VOXELS * 8];
    const size_t size = native_voxels(t, voxels);
    if (big_endian)
        swap(voxels, t->size);
    if (how == RAW)
        put(f, voxels, size);
    else if (how == DEFLATED)
        put_deflated(f, voxels, size, as_gzip);
    for (size_t i = 0; how == HEX && i < size; ++i)
        put_text(f, "%s%02x", i % 20 == 0 && i > 0 ? "\n" : "", voxels[i]);
    for (int v = 0; how == TEXT && v < VOXELS; ++v)
        put_text(f, "%s%lld", v == 0 ? "" : v % NX == 0 ? "\n" : " ", (long long)label_of(t, v));
}

static inline void put_nrrd(fixture* f, const type* t, const char* name, encoding how, int big_endian)
{
    static const char* const encodings[] = {"raw", "gzip", "ascii", "hex"};
    f->size = 0;
    put_text(f, "NRRD0004\ntype: %s\ndimension: 3\nsizes: %d %d %d\nspacings: 1 1 1\nencoding: %s\n", name, NX, NY, NZ,
             encodings[how]);
    put_text(f, "endian: %s\n\n", big_endian ? "big" : "little");
    put_voxels(f, t, how, big_endian, 1);
}

static inline void put_meta(fixture* f, const type* t, const char* name, encoding how, int big_endian)
{
    f->size = 0;
    put_text(f, "ObjectType = Image\nNDims = 3\nDimSize = %d %d %d\nElementSpacing = 1 1 1\nElementType = %s\n", NX, NY,
             NZ, name);
    put_text(f, "BinaryData = %s\nCompressedData = %s\nBinaryDataByteOrderMSB = %s\nElementDataFile = LOCAL\n",
             how == TEXT ? "False" : "True", how == DEFLATED ? "True" : "False", big_endian ? "True" : "False");
    put_voxels(f, t, how, big_endian, 0);
}

static inline void put_vtk(fixture* f, const type* t, const char* name, encoding how, int on_cells)
{
    f->size = 0;
    put_text(f, "# vtk DataFile Version 3.0\na title\n%s\nDATASET STRUCTURED_POINTS\n",
             how == TEXT ? "ASCII" : "BINARY");
    put_text(f, "DIMENSIONS %d %d %d\nORIGIN 0 0 0\nSPACING 1 1 1\n", NX + on_cells, NY + on_cells, NZ + on_cells);
    put_text(f, "%s %d\nSCALARS labels %s\nLOOKUP_TABLE default\n", on_cells ? "CELL_DATA" : "POINT_DATA", VOXELS,
             name);
    put_voxels(f, t, how, 1, 0);
}

static inline cleft_status read_labels(fixture* f, cleft_volume** volume)
{
    const char* path = f->path;
    const cleft_io_reading reading = {.struct_size = sizeof reading, .kind = CLEFT_IO_KIND_LABELS};
    return cleft_io_read_volume(f->context, NULL, &path, 1, &reading, volume);
}

/* The volume that was stored is refused by a sentence that has the words; `what` was wrong in it. */
static inline void assert_stored_is_refused(fixture* f, const char* what, const char* words)
{
    cleft_volume* volume = NULL;
    if (read_labels(f, &volume) == CLEFT_OK)
        fail_msg("not refused: %s", what);
    if (!strstr(cleft_context_last_error(f->context), words))
        fail_msg("'%s' does not say: %s", cleft_context_last_error(f->context), words);
}

#endif
