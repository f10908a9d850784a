/* Every kind of TIFF that libtiff can write is read voxel by voxel, or refused by a sentence that says what it is. What
 * other programs write is tested by check_tiff.py. */
#include "cleft/cleft_io.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tiffio.h>
#include <unistd.h>

#include <cmocka.h>

enum { WIDTH = 37, HEIGHT = 21, PAGES = 3, TILE = 16, ROWS = 8 };

typedef struct fixture {
    cleft_context* context;
    char folder[64];
    char path[128];
} fixture;

typedef struct kind {
    const char* mode; /* of TIFFOpen: 8 BigTIFF, b big-endian */
    uint16_t bits;
    uint16_t format;
    uint16_t compression;
    uint16_t predictor;
    uint16_t planar;
    uint16_t fill_order;
    uint16_t photometric;
    int tiled;
} kind;

static const kind plain = {
    "w", 8, SAMPLEFORMAT_UINT, COMPRESSION_NONE, 1, PLANARCONFIG_CONTIG, FILLORDER_MSB2LSB, PHOTOMETRIC_MINISBLACK, 0};

static int set_up(void** state)
{
    fixture* f = calloc(1, sizeof *f);
    strcpy(f->folder, "/tmp/cleft_tiff_XXXXXX");
    *state = f;
    if (!mkdtemp(f->folder) || cleft_context_create(&f->context) != CLEFT_OK)
        return -1;
    snprintf(f->path, sizeof f->path, "%s/a.tif", f->folder);
    return 0;
}

static int tear_down(void** state)
{
    fixture* f = *state;
    unlink(f->path);
    const int removed = rmdir(f->folder);
    cleft_context_destroy(f->context);
    free(f);
    return removed;
}

static int64_t value_of(const kind* k, int x, int y, int z)
{
    const int mixed = (x * 7 + y * 13 + z * 5 + (x * y) % 11) % 9;
    if (k->bits < 8)
        return mixed % (1 << k->bits);
    const int64_t wide = k->bits == 8 ? mixed * 14 : k->bits == 16 ? mixed * 3000 : mixed * 200000000LL;
    return k->format == SAMPLEFORMAT_INT && mixed % 2 ? -wide : wide;
}

/* Stores the value at number `index` of a row of numbers. */
static void store(const kind* k, unsigned char* row, int index, int64_t value)
{
    if (k->bits < 8) {
        const int in_byte = 8 / k->bits;
        row[index / in_byte] |= (unsigned char)(value << (k->bits * (in_byte - 1 - index % in_byte)));
    } else if (k->format == SAMPLEFORMAT_IEEEFP && k->bits == 32) {
        const float number = (float)value;
        memcpy(row + 4 * index, &number, sizeof number);
    } else if (k->format == SAMPLEFORMAT_IEEEFP && k->bits == 64) {
        const double number = (double)value;
        memcpy(row + 8 * index, &number, sizeof number);
    } else { /* this machine is little-endian */
        memcpy(row + k->bits / 8 * index, &value, k->bits / 8);
    }
}

static void set_fields(TIFF* file, const kind* k)
{
    TIFFSetField(file, TIFFTAG_IMAGEWIDTH, WIDTH);
    TIFFSetField(file, TIFFTAG_IMAGELENGTH, HEIGHT);
    TIFFSetField(file, TIFFTAG_BITSPERSAMPLE, k->bits);
    TIFFSetField(file, TIFFTAG_SAMPLEFORMAT, k->format);
    TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, 1);
    TIFFSetField(file, TIFFTAG_COMPRESSION, k->compression);
    TIFFSetField(file, TIFFTAG_PLANARCONFIG, k->planar);
    TIFFSetField(file, TIFFTAG_PHOTOMETRIC, k->photometric);
    TIFFSetField(file, TIFFTAG_FILLORDER, k->fill_order);
    if (k->predictor != 1)
        TIFFSetField(file, TIFFTAG_PREDICTOR, k->predictor);
    if (k->tiled) {
        TIFFSetField(file, TIFFTAG_TILEWIDTH, TILE);
        TIFFSetField(file, TIFFTAG_TILELENGTH, TILE);
    } else {
        TIFFSetField(file, TIFFTAG_ROWSPERSTRIP, ROWS);
    }
}

static void write_page(TIFF* file, const kind* k, int z)
{
    unsigned char buffer[TILE * TILE * 8 + WIDTH * 8];
    if (k->tiled) {
        for (int top = 0; top < HEIGHT; top += TILE)
            for (int left = 0; left < WIDTH; left += TILE) {
                memset(buffer, 0, sizeof buffer);
                for (int y = top; y < top + TILE && y < HEIGHT; ++y)
                    for (int x = left; x < left + TILE && x < WIDTH; ++x)
                        store(k, buffer + (y - top) * TILE * k->bits / 8, x - left, value_of(k, x, y, z));
                assert_true(TIFFWriteTile(file, buffer, (uint32_t)left, (uint32_t)top, 0, 0) > 0);
            }
        return;
    }
    for (int y = 0; y < HEIGHT; ++y) {
        memset(buffer, 0, sizeof buffer);
        for (int x = 0; x < WIDTH; ++x)
            store(k, buffer, x, value_of(k, x, y, z));
        assert_int_equal(TIFFWriteScanline(file, buffer, (uint32_t)y, 0), 1);
    }
}

static void write_stack(const char* path, const kind* k)
{
    TIFF* file = TIFFOpen(path, k->mode);
    assert_non_null(file);
    for (int z = 0; z < PAGES; ++z) {
        set_fields(file, k);
        write_page(file, k, z);
        TIFFWriteDirectory(file);
    }
    TIFFClose(file);
}

static cleft_status read_stack(fixture* f, cleft_volume** volume)
{
    const char* path = f->path;
    const cleft_io_reading labels = {.struct_size = sizeof labels, .kind = CLEFT_IO_KIND_LABELS};
    return cleft_io_read_volume(f->context, NULL, &path, 1, &labels, volume);
}

static void check_stack(fixture* f, const kind* k)
{
    cleft_volume* volume = NULL;
    if (read_stack(f, &volume) != CLEFT_OK)
        fail_msg("%d bits, format %d, compression %d, mode %s: %s", k->bits, k->format, k->compression, k->mode,
                 cleft_context_last_error(f->context));
    int64_t dims[3];
    assert_int_equal(cleft_volume_dims(volume, dims), CLEFT_OK);
    assert_true(dims[0] == WIDTH && dims[1] == HEIGHT && dims[2] == PAGES);
    for (int z = 0; z < PAGES; ++z)
        for (int y = 0; y < HEIGHT; ++y)
            for (int x = 0; x < WIDTH; ++x) {
                const double centre[3] = {x, y, z};
                int32_t label = 0;
                assert_int_equal(cleft_volume_sample(volume, centre, 1, &label), CLEFT_OK);
                if (label != value_of(k, x, y, z))
                    fail_msg("%d bits, format %d, compression %d, predictor %d, mode %s: %d at (%d, %d, %d)", k->bits,
                             k->format, k->compression, k->predictor, k->mode, (int)label, x, y, z);
            }
    cleft_volume_destroy(volume);
}

static void refuse(fixture* f, cleft_status wanted, const char* words)
{
    cleft_volume* volume = NULL;
    assert_int_equal(read_stack(f, &volume), wanted);
    assert_null(volume);
    if (!strstr(cleft_context_last_error(f->context), words))
        fail_msg("'%s' does not say '%s'", cleft_context_last_error(f->context), words);
}

static void round_trip(fixture* f, const kind* k)
{
    write_stack(f->path, k);
    check_stack(f, k);
}

/* Bits, sample formats, byte orders, BigTIFF, strips and tiles, planar order; uncompressed and by deflate. */
static void test_types(void** state)
{
    const struct {
        uint16_t bits;
        uint16_t format;
    } types[] = {{1, SAMPLEFORMAT_UINT},   {2, SAMPLEFORMAT_UINT},  {4, SAMPLEFORMAT_UINT},  {8, SAMPLEFORMAT_UINT},
                 {16, SAMPLEFORMAT_UINT},  {32, SAMPLEFORMAT_UINT}, {64, SAMPLEFORMAT_UINT}, {8, SAMPLEFORMAT_INT},
                 {16, SAMPLEFORMAT_INT},   {32, SAMPLEFORMAT_INT},  {64, SAMPLEFORMAT_INT},  {32, SAMPLEFORMAT_IEEEFP},
                 {64, SAMPLEFORMAT_IEEEFP}};
    const char* modes[] = {"w", "wb", "w8", "w8b"};
    for (size_t t = 0; t < sizeof types / sizeof *types; ++t)
        for (size_t m = 0; m < 4; ++m)
            for (int tiled = 0; tiled < 2; ++tiled) {
                kind k = plain;
                k.mode = modes[m];
                k.bits = types[t].bits;
                k.format = types[t].format;
                k.tiled = tiled;
                k.planar = m % 2 ? PLANARCONFIG_SEPARATE : PLANARCONFIG_CONTIG;
                k.compression = m < 2 ? COMPRESSION_NONE : COMPRESSION_ADOBE_DEFLATE;
                round_trip(*state, &k);
            }
}

static void test_compressions(void** state)
{
    const uint16_t packed[] = {COMPRESSION_LZW,  COMPRESSION_DEFLATE, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS,
                               COMPRESSION_ZSTD, COMPRESSION_LZMA,    COMPRESSION_LERC};
    for (size_t c = 0; c < sizeof packed / sizeof *packed; ++c) {
        if (!TIFFIsCODECConfigured(packed[c]))
            continue;
        for (uint16_t bits = 8; bits <= 64; bits *= 2)
            for (uint16_t predictor = 1; predictor <= 3; ++predictor)
                for (int tiled = 0; tiled < 2; ++tiled) {
                    kind k = plain;
                    k.bits = bits;
                    k.compression = packed[c];
                    k.predictor = predictor;
                    k.tiled = tiled;
                    k.mode = tiled && predictor < 3 ? "wb" : "w"; /* libtiff 4.5 writes the third wrongly by "wb" */
                    if (predictor == 3)
                        k.format = SAMPLEFORMAT_IEEEFP;
                    const int predicts = packed[c] != COMPRESSION_PACKBITS && packed[c] != COMPRESSION_LERC;
                    if ((predictor == 1 || predicts) && (predictor < 3 || bits >= 32) &&
                        (packed[c] != COMPRESSION_LERC || bits <= 32))
                        round_trip(*state, &k);
                }
    }
}

static void test_one_bit(void** state)
{
    const uint16_t packed[] = {COMPRESSION_NONE,      COMPRESSION_CCITTRLE, COMPRESSION_CCITTFAX3,
                               COMPRESSION_CCITTFAX4, COMPRESSION_PACKBITS, COMPRESSION_LZW};
    for (size_t c = 0; c < sizeof packed / sizeof *packed; ++c)
        for (uint16_t order = FILLORDER_MSB2LSB; order <= FILLORDER_LSB2MSB; ++order)
            for (uint16_t white_is_zero = 0; white_is_zero < 2; ++white_is_zero) {
                kind k = plain;
                k.bits = 1;
                k.compression = packed[c];
                k.fill_order = order;
                k.photometric = white_is_zero ? PHOTOMETRIC_MINISWHITE : PHOTOMETRIC_MINISBLACK;
                round_trip(*state, &k);
            }
}

static void test_refused_types(void** state)
{
    const struct {
        uint16_t bits;
        uint16_t format;
        const char* words;
    } types[] = {{16, SAMPLEFORMAT_IEEEFP, "floating-point numbers of 16 bits"},
                 {12, SAMPLEFORMAT_UINT, "12 bits"},
                 {24, SAMPLEFORMAT_UINT, "24 bits"},
                 {4, SAMPLEFORMAT_INT, "signed numbers of 4 bits"},
                 {32, SAMPLEFORMAT_COMPLEXINT, "complex"},
                 {64, SAMPLEFORMAT_COMPLEXIEEEFP, "complex"},
                 {8, SAMPLEFORMAT_VOID, "not known"}};
    fixture* f = *state;
    for (size_t t = 0; t < sizeof types / sizeof *types; ++t) {
        kind k = plain;
        k.bits = types[t].bits;
        k.format = types[t].format;
        TIFF* file = TIFFOpen(f->path, "w");
        set_fields(file, &k);
        unsigned char row[WIDTH * 8] = {0};
        for (uint32_t y = 0; y < HEIGHT; ++y)
            TIFFWriteScanline(file, row, y, 0);
        TIFFClose(file);
        refuse(f, CLEFT_ERROR_FORMAT, types[t].words);
    }
}

static void test_colours(void** state)
{
    fixture* f = *state;
    for (uint16_t samples = 2; samples <= 4; ++samples)
        for (uint16_t planar = PLANARCONFIG_CONTIG; planar <= PLANARCONFIG_SEPARATE; ++planar) {
            kind k = plain;
            k.photometric = samples == 2 ? PHOTOMETRIC_MINISBLACK : PHOTOMETRIC_RGB;
            k.planar = planar;
            TIFF* file = TIFFOpen(f->path, "w");
            set_fields(file, &k);
            TIFFSetField(file, TIFFTAG_SAMPLESPERPIXEL, samples);
            const uint16_t extra = EXTRASAMPLE_UNSPECIFIED;
            if (samples != 3)
                TIFFSetField(file, TIFFTAG_EXTRASAMPLES, 1, &extra);
            unsigned char row[WIDTH * 4] = {0};
            for (uint16_t s = 0; s < (planar == PLANARCONFIG_SEPARATE ? samples : 1); ++s)
                for (uint32_t y = 0; y < HEIGHT; ++y)
                    TIFFWriteScanline(file, row, y, s);
            TIFFClose(file);
            char words[40];
            snprintf(words, sizeof words, "%d numbers a voxel", samples);
            refuse(f, CLEFT_ERROR_FORMAT, words);
            if (samples != 2)
                refuse(f, CLEFT_ERROR_FORMAT, "colours");
        }
}

/* The number in the palette is the label. */
static void test_palette(void** state)
{
    fixture* f = *state;
    kind k = plain;
    k.bits = 4;
    k.photometric = PHOTOMETRIC_PALETTE;
    TIFF* file = TIFFOpen(f->path, "w");
    for (int z = 0; z < PAGES; ++z) {
        uint16_t colours[16];
        for (int i = 0; i < 16; ++i)
            colours[i] = (uint16_t)(65535 - 4000 * i);
        set_fields(file, &k);
        TIFFSetField(file, TIFFTAG_COLORMAP, colours, colours, colours);
        write_page(file, &k, z);
        TIFFWriteDirectory(file);
    }
    TIFFClose(file);
    check_stack(f, &k);
}

/* Thumbnails and masks, marked by either tag, are no slices; pages of another size or type are an error. */
static void test_other_pages(void** state)
{
    fixture* f = *state;
    const uint32_t passed_over[] = {FILETYPE_REDUCEDIMAGE, FILETYPE_MASK};
    TIFF* file = TIFFOpen(f->path, "w");
    for (int z = 0; z < PAGES; ++z) {
        for (int other = 0; other < 2; ++other) {
            set_fields(file, &plain);
            TIFFSetField(file, TIFFTAG_SUBFILETYPE, passed_over[other]);
            write_page(file, &plain, 7);
            TIFFWriteDirectory(file);
        }
        set_fields(file, &plain);
        TIFFSetField(file, TIFFTAG_SUBFILETYPE, FILETYPE_PAGE);
        write_page(file, &plain, z);
        TIFFWriteDirectory(file);
    }
    TIFFClose(file);
    check_stack(f, &plain);

    for (int odd = 0; odd < 3; ++odd) {
        file = TIFFOpen(f->path, "w");
        for (int z = 0; z < PAGES; ++z) {
            kind k = plain;
            if (z == 1 && odd == 1)
                k.format = SAMPLEFORMAT_INT;
            if (z == 1 && odd == 2)
                k.photometric = PHOTOMETRIC_MINISWHITE;
            set_fields(file, &k);
            if (z == 1 && odd == 0)
                TIFFSetField(file, TIFFTAG_IMAGELENGTH, HEIGHT + 1);
            write_page(file, &k, z);
            if (z == 1 && odd == 0) {
                unsigned char row[WIDTH] = {0};
                TIFFWriteScanline(file, row, HEIGHT, 0);
            }
            TIFFWriteDirectory(file);
        }
        TIFFClose(file);
        refuse(f, CLEFT_ERROR_FORMAT, odd == 0 ? "the 2nd page has 37 x 22 voxels" : "the 2nd page has another type");
    }
}

static size_t load_file(const char* path, unsigned char* bytes, size_t most)
{
    FILE* file = fopen(path, "rb");
    assert_non_null(file);
    const size_t size = fread(bytes, 1, most, file);
    fclose(file);
    return size;
}

static void save_file(const char* path, const unsigned char* bytes, size_t size)
{
    FILE* file = fopen(path, "wb");
    assert_non_null(file);
    fwrite(bytes, 1, size, file);
    fclose(file);
}

/* A file that is cut short anywhere is refused: no voxel is made up. */
static void test_truncated(void** state)
{
    fixture* f = *state;
    const uint16_t packed[] = {COMPRESSION_NONE, COMPRESSION_LZW, COMPRESSION_ADOBE_DEFLATE, COMPRESSION_PACKBITS};
    for (size_t c = 0; c < 4; ++c) {
        kind k = plain;
        k.compression = packed[c];
        k.tiled = c % 2;
        write_stack(f->path, &k);
        unsigned char bytes[20000];
        const size_t size = load_file(f->path, bytes, sizeof bytes);
        for (size_t length = 0; length < size; ++length) {
            save_file(f->path, bytes, length);
            cleft_volume* volume = NULL;
            if (read_stack(f, &volume) == CLEFT_OK)
                fail_msg("compression %d: %zu of %zu bytes were enough", packed[c], length, size);
        }
    }
}

/* Bytes changed at random: read or refused, and nothing is asked for that the file cannot hold. */
static void test_damaged(void** state)
{
    fixture* f = *state;
    kind k = plain;
    k.compression = COMPRESSION_LZW;
    write_stack(f->path, &k);
    unsigned char bytes[20000];
    const size_t size = load_file(f->path, bytes, sizeof bytes);
    uint32_t random = 1;
    for (int trial = 0; trial < 400; ++trial) {
        unsigned char damaged[sizeof bytes];
        memcpy(damaged, bytes, size);
        for (int change = 0; change < 3; ++change) {
            random = random * 1664525u + 1013904223u;
            damaged[(random >> 8) % size] = (unsigned char)random;
        }
        save_file(f->path, damaged, size);
        cleft_volume* volume = NULL;
        read_stack(f, &volume);
        cleft_volume_destroy(volume);
    }
}

static void put(unsigned char* at, uint32_t value, int bytes)
{
    for (int i = 0; i < bytes; ++i)
        at[i] = (unsigned char)(value >> (8 * i));
}

/* One directory of these tags, each of one LONG; `next` is where the next directory lies. */
static size_t write_directory(unsigned char* bytes, size_t at, const uint32_t (*tags)[2], int count, uint32_t next)
{
    put(bytes + at, (uint32_t)count, 2);
    for (int t = 0; t < count; ++t) {
        unsigned char* entry = bytes + at + 2 + 12 * t;
        put(entry, tags[t][0], 2);
        put(entry + 2, 4, 2);
        put(entry + 4, 1, 4);
        put(entry + 8, tags[t][1], 4);
    }
    put(bytes + at + 2 + 12 * count, next, 4);
    return at + 2 + 12 * (size_t)count + 4;
}

static void count_libtiff(int32_t level, const char* sentence, void* user)
{
    if (level == CLEFT_LOG_WARNING && strstr(sentence, "libtiff"))
        ++*(int*)user;
}

/* Pages in a circle, sizes that no file has, pages that share their bytes, strips that are not there. */
static void test_hostile(void** state)
{
    fixture* f = *state;
    unsigned char bytes[4000] = "II*";
    put(bytes + 4, 8, 4);
    uint32_t tags[][2] = {{256, 20},  {257, 20}, {258, 8},  {259, 1},  {262, 1},
                          {273, 200}, {277, 1},  {278, 20}, {279, 400}};
    enum { OFFSET = 5, COUNT = 8 };
    size_t end = write_directory(bytes, 8, (const uint32_t(*)[2])tags, 9, 8);
    save_file(f->path, bytes, 1000);
    refuse(f, CLEFT_ERROR_FORMAT, "circle");

    write_directory(bytes, 8, (const uint32_t(*)[2])tags, 9, 0);
    save_file(f->path, bytes, 1000);
    cleft_volume* volume = NULL;
    assert_int_equal(read_stack(f, &volume), CLEFT_OK);
    cleft_volume_destroy(volume);

    tags[0][1] = tags[1][1] = tags[7][1] = 0x7fffffff;
    write_directory(bytes, 8, (const uint32_t(*)[2])tags, 9, 0);
    save_file(f->path, bytes, 1000);
    refuse(f, CLEFT_ERROR_FORMAT, "the 1st page");
    tags[0][1] = tags[1][1] = tags[7][1] = 20;

    for (int fault = 0; fault < 3; ++fault) {
        uint32_t faulty[9][2];
        memcpy(faulty, tags, sizeof faulty);
        faulty[fault == 0 ? OFFSET : COUNT][1] = fault == 0 ? 800 : fault == 1 ? 0 : 399;
        write_directory(bytes, 8, (const uint32_t(*)[2])faulty, 9, 0);
        save_file(f->path, bytes, 1000);
        if (fault == 0) {
            refuse(f, CLEFT_ERROR_FORMAT, "behind the end");
        } else { /* a wrong count of bytes, where all voxels are there, is reported */
            int reported = 0;
            assert_int_equal(cleft_context_set_log(f->context, count_libtiff, &reported), CLEFT_OK);
            assert_int_equal(read_stack(f, &volume), CLEFT_OK);
            assert_int_equal(reported, 1);
            assert_int_equal(cleft_context_set_log(f->context, NULL, NULL), CLEFT_OK);
            cleft_volume_destroy(volume);
        }
    }

    size_t at = 1000;
    write_directory(bytes, 8, (const uint32_t(*)[2])tags, 9, (uint32_t)at);
    for (int page = 0; page < 20; ++page)
        at = write_directory(bytes, at, (const uint32_t(*)[2])tags, 9, page == 19 ? 0 : (uint32_t)(at + 114));
    assert_true(end < 200 && at < sizeof bytes);
    save_file(f->path, bytes, at);
    refuse(f, CLEFT_ERROR_FORMAT, "claim more voxels");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test_setup_teardown(test_types, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_compressions, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_one_bit, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_refused_types, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_colours, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_palette, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_other_pages, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_truncated, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_damaged, set_up, tear_down),
        cmocka_unit_test_setup_teardown(test_hostile, set_up, tear_down),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
