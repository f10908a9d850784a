/* Headers of NRRD and MetaImage of which one thing is wrong: each is refused by a sentence that names it. */
#include "written_volumes.h"

typedef struct {
    const char* header; /* its fields behind the mark */
    const char* words;  /* of the refusal */
} refusal;

static void assert_nrrd_is_refused(fixture* f, const char* begin, const refusal* wanted)
{
    f->size = 0;
    put_text(f, "NRRD0005\n");
    put(f, begin, strlen(begin));
    put(f, wanted->header, strlen(wanted->header));
    put(f, "\n\1\2\1\2\1\2\1\2", 9);
    store(f, "a.nrrd", f->size);
    assert_stored_is_refused(f, wanted->header, wanted->words);
}

/* Fields of which one is wrong or missing. */
static void test_nrrd_fields_that_are_refused(void** state)
{
    static const refusal headers[] = {
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
        {"type: uchar\ndimension: 5\nsizes: 2 2 2 2 2\nencoding: raw\n", "axes"},
        {"type: uchar\ndimension: 1\nsizes: 8\nencoding: raw\n", "axes of space"},
    };
    for (size_t i = 0; i < sizeof headers / sizeof *headers; ++i)
        assert_nrrd_is_refused(*state, "", &headers[i]);
}

/* Fields that a sound header goes on with. */
static void test_nrrd_places_that_are_refused(void** state)
{
    static const refusal additions[] = {
        {"space: moon\nspace directions: (1,0,0) (0,1,0) (0,0,1)\n", "'space' is 'moon'"},
        {"space directions: (1,0,0) (0,1,0) (0,0,1)\n", "'space'"},
        {"space: LPS\nspace directions: (1,0,0) (0,1) (0,0,1)\n", "has 2 numbers"},
        {"space: LPS\nspace directions: (1,0,0) (0,0,1)\n", "a vector for each axis"},
        {"space: LPS\nspace directions: (1,0,x) (0,1,0) (0,0,1)\n", "'space directions' is 'x'"},
        {"space: LPS\nspace directions: (nan,0,0) (0,1,0) (0,0,1)\n", "spacing along the 1st axis"},
        {"spacings: 1 0 1\n", "spacing along the 2nd axis is 0"},
        {"spacings: 1 inf 1\n", "spacing along the 2nd axis is"},
        {"line skip: -1\n", "'line skip' is '-1'"},
        {"byte skip: -2\n", "'byte skip' is '-2'"},
        {"data file: absent.raw\n", "absent.raw"},
        {"data file: a%s.raw 1 2 1\n", "one %d"},
        {"data file: a%d.raw 1 3 1\n", "3 data files"},
    };
    for (size_t i = 0; i < sizeof additions / sizeof *additions; ++i)
        assert_nrrd_is_refused(*state, "type: uchar\ndimension: 3\nsizes: 2 2 2\nencoding: raw\n", &additions[i]);
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
        assert_stored_is_refused(f, changes[i].to, changes[i].words);
    }
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(test_nrrd_fields_that_are_refused),
        TEST(test_nrrd_places_that_are_refused),
        TEST(test_metaimages_that_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
