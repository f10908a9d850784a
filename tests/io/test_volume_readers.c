/* NRRD, MetaImage and legacy VTK: every type of voxels in every encoding and order of bytes, and files that are cut
 * short at every byte, each of which must be refused. */
#include "folder.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

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

static int set_up(void** state)
{
    fixture* f = calloc(1, sizeof *f);
    *state = f;
    return make_folder(f->folder, &f->context);
}

static int tear_down(void** state)
{
    fixture* f = *state;
    const int removed = remove_folder(f->folder);
    cleft_context_destroy(f->context);
    free(f);
    return removed;
}

static void put(fixture* f, const void* data, size_t size)
{
    assert_true(f->size + size <= ROOM);
    memcpy(f->bytes + f->size, data, size);
    f->size += size;
}

static void put_text(fixture* f, const char* format, ...)
{
    char text[1024];
    va_list list;
    va_start(list, format);
    const int size = vsnprintf(text, sizeof text, format, list);
    va_end(list);
    put(f, text, (size_t)size);
}

static const char* store(fixture* f, const char* name, size_t size)
{
    snprintf(f->path, sizeof f->path, "%s/%s", f->folder, name);
    FILE* file = fopen(f->path, "wb");
    assert_non_null(file);
    assert_int_equal(fwrite(f->bytes, 1, size, file), size);
    fclose(file);
    return f->path;
}

/* Labels that tell whether bytes are in order and signs are kept; the last one is a single digit. */
static int64_t label_of(const type* t, int voxel)
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
static size_t native_voxels(const type* t, unsigned char* out)
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

static void swap(unsigned char* voxels, int size)
{
    for (int v = 0; v < VOXELS; ++v)
        for (int i = 0; i < size / 2; ++i) {
            unsigned char* at = voxels + v * size;
            const unsigned char kept = at[i];
            at[i] = at[size - 1 - i];
            at[size - 1 - i] = kept;
        }
}

static void put_deflated(fixture* f, const unsigned char* data, size_t size, int as_gzip)
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

static void put_voxels(fixture* f, const type* t, encoding how, int big_endian, int as_gzip)
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

static void put_nrrd(fixture* f, const type* t, const char* name, encoding how, int big_endian)
{
    static const char* const encodings[] = {"raw", "gzip", "ascii", "hex"};
    f->size = 0;
    put_text(f, "NRRD0004\ntype: %s\ndimension: 3\nsizes: %d %d %d\nspacings: 1 1 1\nencoding: %s\n", name, NX, NY, NZ,
             encodings[how]);
    put_text(f, "endian: %s\n\n", big_endian ? "big" : "little");
    put_voxels(f, t, how, big_endian, 1);
}

static void put_meta(fixture* f, const type* t, const char* name, encoding how, int big_endian)
{
    f->size = 0;
    put_text(f, "ObjectType = Image\nNDims = 3\nDimSize = %d %d %d\nElementSpacing = 1 1 1\nElementType = %s\n", NX, NY,
             NZ, name);
    put_text(f, "BinaryData = %s\nCompressedData = %s\nBinaryDataByteOrderMSB = %s\nElementDataFile = LOCAL\n",
             how == TEXT ? "False" : "True", how == DEFLATED ? "True" : "False", big_endian ? "True" : "False");
    put_voxels(f, t, how, big_endian, 0);
}

static void put_vtk(fixture* f, const type* t, const char* name, encoding how, int on_cells)
{
    f->size = 0;
    put_text(f, "# vtk DataFile Version 3.0\na title\n%s\nDATASET STRUCTURED_POINTS\n",
             how == TEXT ? "ASCII" : "BINARY");
    put_text(f, "DIMENSIONS %d %d %d\nORIGIN 0 0 0\nSPACING 1 1 1\n", NX + on_cells, NY + on_cells, NZ + on_cells);
    put_text(f, "%s %d\nSCALARS labels %s\nLOOKUP_TABLE default\n", on_cells ? "CELL_DATA" : "POINT_DATA", VOXELS,
             name);
    put_voxels(f, t, how, 1, 0);
}

static cleft_status read_labels(fixture* f, cleft_volume** volume)
{
    const char* path = f->path;
    const cleft_io_reading reading = {.struct_size = sizeof reading, .kind = CLEFT_IO_KIND_LABELS};
    return cleft_io_read_volume(f->context, NULL, &path, 1, &reading, volume);
}

static void check_labels(fixture* f, const type* t, double offset)
{
    cleft_volume* volume = NULL;
    if (read_labels(f, &volume) != CLEFT_OK)
        fail_msg("%.*s\n%s", 200, (const char*)f->bytes, cleft_context_last_error(f->context));
    for (int v = 0; v < VOXELS; ++v) {
        const double centre[3] = {v % NX + offset, v / NX % NY + offset, v / (NX * NY) + offset};
        int32_t label = -1;
        assert_int_equal(cleft_volume_sample(volume, centre, 1, &label), CLEFT_OK);
        assert_int_equal(label, label_of(t, v));
    }
    cleft_volume_destroy(volume);
}

/* The next of the names that '|' separates, "" at the end. */
static const char* next_name(const char* names, char* name)
{
    const size_t length = strcspn(names, "|");
    memcpy(name, names, length);
    name[length] = '\0';
    return names + length + (names[length] == '|');
}

static void test_every_nrrd(void** state)
{
    fixture* f = *state;
    char name[64];
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        for (const char* names = next_name(types[i].nrrd, name); *name; names = next_name(names, name))
            for (encoding how = RAW; how <= HEX; ++how)
                for (int big_endian = 0; big_endian < 2; ++big_endian) {
                    put_nrrd(f, &types[i], name, how, big_endian);
                    store(f, "a.nrrd", f->size);
                    check_labels(f, &types[i], 0);
                }
}

static void test_every_metaimage(void** state)
{
    fixture* f = *state;
    char name[64];
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        for (const char* names = next_name(types[i].meta, name); *name; names = next_name(names, name))
            for (encoding how = RAW; how <= TEXT; ++how)
                for (int big_endian = 0; big_endian < 2; ++big_endian) {
                    put_meta(f, &types[i], name, how, big_endian);
                    store(f, "a.mha", f->size);
                    check_labels(f, &types[i], 0);
                }
}

static void test_every_vtk(void** state)
{
    fixture* f = *state;
    char name[64];
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        for (const char* names = next_name(types[i].vtk, name); *name; names = next_name(names, name))
            for (int text = 0; text < 2; ++text)
                for (int on_cells = 0; on_cells < 2; ++on_cells) {
                    put_vtk(f, &types[i], name, text ? TEXT : RAW, on_cells);
                    store(f, "a.vtk", f->size);
                    check_labels(f, &types[i], on_cells ? 0.5 : 0);
                }
}

/* Each beginning of a file that is whole is refused. */
static void refuse_all_beginnings(fixture* f, const char* name)
{
    for (size_t size = 0; size < f->size; ++size) {
        cleft_volume* volume = NULL;
        store(f, name, size);
        const cleft_status status = read_labels(f, &volume);
        if (status != CLEFT_ERROR_FORMAT && status != CLEFT_ERROR_FILE && status != CLEFT_ERROR_UNSUPPORTED)
            fail_msg("%s of %zu bytes of %zu: status %d", name, size, f->size, (int)status);
        if (!strstr(cleft_context_last_error(f->context), name))
            fail_msg("'%s' does not name %s", cleft_context_last_error(f->context), name);
        assert_null(volume);
    }
}

static void test_all_beginnings_are_refused(void** state)
{
    fixture* f = *state;
    const type* shorts = &types[3];
    for (encoding how = RAW; how <= HEX; ++how) {
        put_nrrd(f, shorts, "ushort", how, 0);
        refuse_all_beginnings(f, "a.nrrd");
    }
    for (encoding how = RAW; how <= TEXT; ++how) {
        put_meta(f, shorts, "MET_USHORT", how, 0);
        refuse_all_beginnings(f, "a.mha");
    }
    for (int text = 0; text < 2; ++text) {
        put_vtk(f, shorts, "unsigned_short", text ? TEXT : RAW, 1);
        refuse_all_beginnings(f, "a.vtk");
    }
}

/* No byte of what is compressed can be another without being noticed. */
static void test_changed_bytes_of_compressed_voxels_are_refused(void** state)
{
    fixture* f = *state;
    put_nrrd(f, &types[1], "uchar", DEFLATED, 0);
    const unsigned char* end = (const unsigned char*)strstr((const char*)f->bytes, "\n\n");
    assert_non_null(end);
    for (size_t at = (size_t)(end - f->bytes) + 2 + 10; at < f->size; ++at) { /* ten bytes are gzip's own header */
        cleft_volume* volume = NULL;
        f->bytes[at] ^= 0x10;
        store(f, "a.nrrd", f->size);
        assert_int_equal(read_labels(f, &volume), CLEFT_ERROR_FORMAT);
        f->bytes[at] ^= 0x10;
    }
}

/* Other headers, one field changed each: refused with a sentence that has the words. */
static void test_headers_that_are_refused(void** state)
{
    static const struct {
        const char* header;
        const char* words;
    } nrrd[] = {
        {"type: char\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n", "'type' is 'char'"},
        {"type: block\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n", "'type' is 'block'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: bzip2\n", "'encoding' is 'bzip2'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2\nencoding: raw\n", "'sizes' is '2 2'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2 2\nencoding: raw\n", "'sizes' is '2 2 2 2'"},
        {"type: uchar\ndimension: 3\nsizes: 2 0 2\nencoding: raw\n", "'sizes' is '0'"},
        {"type: uchar\ndimension: 3\nsizes: 2 -2 2\nencoding: raw\n", "'sizes' is '-2'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2.5 2\nencoding: raw\n", "'sizes' is '2.5'"},
        {"type: uchar\ndimension: 3\nsizes: 2 99999999999999999999 2\nencoding: raw\n", "'sizes' is '9999999"},
        {"type: uchar\ndimension: 3\nsizes: 4294967296 4294967296 4\nencoding: raw\n", "too many voxels"},
        {"type: uchar\ndimension: 17\nsizes: 2 2 2\nencoding: raw\n", "'dimension' is '17'"},
        {"type: uchar\ndimension: 0\nsizes: 2\nencoding: raw\n", "'dimension' is '0'"},
        {"type: uchar\nsizes: 2 2 2\ndimension: 3\nencoding: raw\n", "'dimension' must come before"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nsizes: 2 2 2\nencoding: raw\n", "stands there twice"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\n", "no field 'encoding'"},
        {"dimension: 3\nsizes: 2 2 2\nencoding: raw\n", "no field 'type'"},
        {"type: ushort\ndimension: 3\nsizes: 2 2 1\nencoding: raw\n", "no field 'endian'"},
        {"type: ushort\ndimension: 3\nsizes: 2 2 1\nencoding: raw\nendian: middle\n", "'endian' is 'middle'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nsizzes: 1\n", "'sizzes' is '1'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nno field at all\n", "'no field at all'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace: moon\nspace directions: (1,0,0) (0,1,0) "
         "(0,0,1)\n",
         "'space' is 'moon'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n",
         "'space'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace: LPS\nspace directions: (1,0,0) (0,1) "
         "(0,0,1)\n",
         "has 2 numbers"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace: LPS\nspace directions: (1,0,0) (0,0,1)\n",
         "a vector for each axis"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace: LPS\nspace directions: (1,0,x) (0,1,0) "
         "(0,0,1)\n",
         "'space directions' is 'x'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspace: LPS\nspace directions: (nan,0,0) (0,1,0) "
         "(0,0,1)\n",
         "spacing along the 1st axis"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspacings: 1 0 1\n",
         "spacing along the 2nd axis is 0"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nspacings: 1 inf 1\n",
         "spacing along the 2nd axis is"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nline skip: -1\n", "'line skip' is '-1'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\nbyte skip: -2\n", "'byte skip' is '-2'"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: absent.raw\n", "absent.raw"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: a%s.raw 1 2 1\n", "one %d"},
        {"type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\ndata file: a%d.raw 1 3 1\n", "3 data files"},
        {"type: uchar\ndimension: 5\nsizes: 2 2 2 2 2\nencoding: raw\n", "axes"},
        {"type: uchar\ndimension: 1\nsizes: 8\nencoding: raw\n", "axes of space"},
    };
    fixture* f = *state;
    for (size_t i = 0; i < sizeof nrrd / sizeof *nrrd; ++i) {
        cleft_volume* volume = NULL;
        f->size = 0;
        put_text(f, "NRRD0005\n");
        put(f, nrrd[i].header, strlen(nrrd[i].header));
        put(f, "\n\1\2\1\2\1\2\1\2", 9);
        store(f, "a.nrrd", f->size);
        if (read_labels(f, &volume) == CLEFT_OK)
            fail_msg("not refused: %s", nrrd[i].header);
        if (!strstr(cleft_context_last_error(f->context), nrrd[i].words))
            fail_msg("'%s' does not say: %s", cleft_context_last_error(f->context), nrrd[i].words);
    }
}

static void test_metaimages_that_are_refused(void** state)
{
    static const struct {
        const char* from; /* a part of the header, and what stands there instead */
        const char* to;
        const char* words;
    } changes[] = {
        {"NDims = 3", "NDims = -1", "'NDims' is '-1'"},
        {"NDims = 3", "NDims = 5", "'NDims' is '5'"},
        {"NDims = 3", "", "no field 'NDims'"},
        {"DimSize = 3 2 2", "DimSize = 3 2", "'DimSize' is '3 2'"},
        {"DimSize = 3 2 2", "DimSize = 3 2 0", "'DimSize' is '3 2 0'"},
        {"DimSize = 3 2 2", "DimSize = 4294967296 4294967296 4", "too many voxels"},
        {"DimSize = 3 2 2", "DimSize = 3 2 2\nDimSize = 3 2 2", "stands there twice"},
        {"MET_UCHAR", "MET_STRING", "'ElementType' is 'MET_STRING'"},
        {"MET_UCHAR", "MET_UCHAR\nElementNumberOfChannels = 3", "3 numbers a voxel"},
        {"ObjectType = Image", "ObjectType = Mesh", "'ObjectType' is 'Mesh'"},
        {"ElementSpacing = 1 1 1", "ElementSpacing = 1 x 1", "'ElementSpacing' is 'x'"},
        {"ElementSpacing = 1 1 1", "ElementSpacing = 1 0 1", "spacing along the 2nd axis is 0"},
        {"ElementSpacing = 1 1 1", "TransformMatrix = 1 0 0 0 0 0 0 0 1", "'TransformMatrix'"},
        {"ElementSpacing = 1 1 1", "Offset = 1 2 3\nOrigin = 1 2 4", "'Offset' says otherwise"},
        {"BinaryData = True", "BinaryData = Perhaps", "'BinaryData' is 'Perhaps'"},
        {"ElementDataFile = LOCAL", "ElementDataFile = absent.raw", "absent.raw"},
        {"ElementDataFile = LOCAL", "ElementDataFile = x%s%n.raw 1 2 1", "one %d"},
        {"ElementDataFile = LOCAL", "ElementDataFile = x%d.raw 1 9 1", "9 files"},
        {"ElementDataFile = LOCAL", "ElementDataFile = LIST\none\ntwo\nthree", "files': 2 are wanted"},
        {"ElementDataFile = LOCAL", "HeaderSize = -2\nElementDataFile = LOCAL", "'HeaderSize' is '-2'"},
    };
    fixture* f = *state;
    for (size_t i = 0; i < sizeof changes / sizeof *changes; ++i) {
        cleft_volume* volume = NULL;
        put_meta(f, &types[1], "MET_UCHAR", RAW, 0);
        f->bytes[f->size] = '\0';
        char* at = strstr((char*)f->bytes, changes[i].from);
        assert_non_null(at);
        char rest[ROOM];
        const size_t kept = f->size - (size_t)((unsigned char*)at - f->bytes) - strlen(changes[i].from);
        memcpy(rest, at + strlen(changes[i].from), kept);
        f->size = (size_t)((unsigned char*)at - f->bytes);
        put(f, changes[i].to, strlen(changes[i].to));
        put(f, rest, kept);
        store(f, "a.mha", f->size);
        if (read_labels(f, &volume) == CLEFT_OK)
            fail_msg("not refused: %s", changes[i].to);
        if (!strstr(cleft_context_last_error(f->context), changes[i].words))
            fail_msg("'%s' does not say: %s", cleft_context_last_error(f->context), changes[i].words);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_every_nrrd),
        TEST(test_every_metaimage),
        TEST(test_every_vtk),
        TEST(test_all_beginnings_are_refused),
        TEST(test_changed_bytes_of_compressed_voxels_are_refused),
        TEST(test_headers_that_are_refused),
        TEST(test_metaimages_that_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
