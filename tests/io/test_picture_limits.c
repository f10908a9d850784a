/* Pictures of meshes at the limits: what is drawn all the same, and what is refused. */
#include "pictures.h"

#include <math.h>

static void size_is_as_asked(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 3, as_it_is);
    static const int sizes[][2] = {{0, 0}, {1, 1}, {7, 300}, {257, 33}};
    for (int i = 0; i < 4; ++i) {
        cleft_io_picture look = small_picture();
        look.width = sizes[i][0];
        look.height = sizes[i][1];
        picture p = draw(f, mesh, &look);
        assert_int_equal(p.width, i == 0 ? 1200 : sizes[i][0]);
        assert_int_equal(p.height, i == 0 ? 900 : sizes[i][1]);
        assert_true(is_sky_blue(middle_of(&p)));
        free(p.rgba);
    }
    picture p = draw(f, mesh, NULL);
    assert_int_equal(p.width, 1200);
    free(p.rgba);
    cleft_mesh_destroy(mesh);
}

/* Rows are compressed in pieces of half a MiB: some of these pictures have several, and some end with one. */
static void pictures_of_any_size_are_read(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 6, as_it_is);
    static const int sizes[][2] = {{1, 1}, {341, 511}, {341, 512}, {341, 513}, {341, 1024}, {341, 1025}, {900, 800}};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        cleft_io_picture look = small_picture();
        look.width = sizes[i][0];
        look.height = sizes[i][1];
        picture p = draw(f, mesh, &look);
        assert_int_equal(p.width, sizes[i][0]);
        assert_int_equal(p.height, sizes[i][1]);
        /* The mesh fills a single pixel. */
        assert_true(i == 0 || is_color(p.rgba, 255, 255, 255));
        free(p.rgba);
    }
    cleft_mesh_destroy(mesh);
}

static double with_rounding(double x) { return 1000 + x / 3; }
static double in_parts_of_1024(double x) { return x / 1024; }
static double nearly_too_large(double x) { return (x - 3) * 0.55e308; }
static double nearly_too_small(double x) { return x * 1e-300; }

static void scale_does_not_matter(void** state)
{
    fixture* f = *state;
    double (*const maps[])(double) = {as_it_is, in_parts_of_1024, nearly_too_large, nearly_too_small};
    picture first = {0};
    for (int i = 0; i < 4; ++i) {
        cleft_mesh* mesh = make_box(f->context, 6, maps[i]);
        cleft_io_picture look = small_picture();
        look.cut[1] = 0.5;
        picture p = draw(f, mesh, &look);
        assert_true(is_orange(middle_of(&p)));
        if (i == 0)
            first = p;
        else {
            if (i == 1) /* a power of two changes no digit */
                assert_same(&p, &first);
            free(p.rgba);
        }
        for (look.by = CLEFT_IO_BY_ANGLE; look.by <= CLEFT_IO_BY_SIZE; ++look.by) {
            look.legend = 1;
            p = draw(f, mesh, &look);
            free(p.rgba);
        }
        cleft_mesh_destroy(mesh);
    }
    free(first.rgba);
}

/* As many labels as a legend has no place for. */
static void thousands_of_labels_are_drawn(void** state)
{
    fixture* f = *state;
    enum { LABELS = 10000 };
    double* points = malloc(sizeof(double) * 12 * LABELS);
    int32_t* tets = malloc(sizeof(int32_t) * 4 * LABELS);
    int32_t* labels = malloc(sizeof(int32_t) * LABELS);
    for (int t = 0; t < LABELS; ++t) {
        static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        for (int i = 0; i < 12; ++i)
            points[12 * t + i] = corners[i] + (i % 3 == 0 ? t % 100 : i % 3 == 1 ? t / 100 : 0);
        for (int v = 0; v < 4; ++v)
            tets[4 * t + v] = 4 * t + v;
        labels[t] = t % 2 ? t : INT32_MIN + t;
    }
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(f->context, 4 * LABELS, points, LABELS, tets, labels, 0, &mesh), CLEFT_OK);
    cleft_io_picture look = small_picture();
    look.legend = 1;
    picture p = draw(f, mesh, &look);
    assert_true(count_if(&p, is_ink) > 0);
    free(p.rgba);
    cleft_mesh_destroy(mesh);
    free(points);
    free(tets);
    free(labels);
}

static void broken_meshes_are_drawn(void** state)
{
    fixture* f = *state;
    /* An inverted tetrahedron, one with a corner twice, one in a plane, one in a point. */
    static const double points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 0};
    static const int32_t tets[] = {1, 0, 2, 3, 0, 0, 1, 2, 0, 1, 2, 4, 3, 3, 3, 3};
    static const int32_t labels[] = {0, 1, 2, 3};
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(f->context, 5, points, 4, tets, labels, 0, &mesh), CLEFT_OK);
    cleft_io_picture look = small_picture();
    look.legend = 1;
    for (look.by = CLEFT_IO_BY_LABEL; look.by <= CLEFT_IO_BY_SIZE; ++look.by) {
        picture p = draw(f, mesh, &look);
        assert_true(count_if(&p, is_grey) > 0);
        free(p.rgba);
    }
    cleft_mesh_destroy(mesh);
    /* All points in one place: nothing but the backdrop. */
    static const double same[12] = {5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5};
    static const int32_t one[] = {0, 1, 2, 3};
    assert_int_equal(cleft_mesh_create(f->context, 4, same, 1, one, NULL, 0, &mesh), CLEFT_OK);
    look.by = CLEFT_IO_BY_SIZE;
    look.legend = 0;
    picture p = draw(f, mesh, &look);
    assert_true(is_color(middle_of(&p), 255, 255, 255));
    free(p.rgba);
    cleft_mesh_destroy(mesh);
}

static cleft_status write_look(fixture* f, const cleft_mesh* mesh, const cleft_io_picture* look)
{
    return cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, look, path_of(f, "refused.png"));
}

static void values_that_cannot_be_are_refused(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 2, as_it_is);
#define REFUSED(field, value, words)                                                \
    do {                                                                            \
        cleft_io_picture look = small_picture();                                    \
        look.field = value;                                                         \
        assert_refused(f, write_look(f, mesh, &look), CLEFT_ERROR_ARGUMENT, words); \
    } while (0)
    REFUSED(struct_size, 0, "struct_size of the cleft_io_picture is 0");
    REFUSED(by, 4, "by of the picture is 4; it must be 0 to 3");
    REFUSED(by, -1, "by of the picture is -1");
    REFUSED(width, -1, "width of the picture is -1; it must be 1 to 8192 pixels");
    REFUSED(height, 8193, "height of the picture is 8193");
    REFUSED(backdrop, 3, "backdrop of the picture is 3");
    REFUSED(reserved, 7, "reserved of the picture is 7");
    REFUSED(cut[0], 1.5, "cut along x of the picture is 1.5; it must be a share of the box, 0 to 1");
    REFUSED(cut[1], -0.1, "cut along y of the picture is -0.1");
    REFUSED(cut[2], NAN, "cut along z of the picture is nan");
    REFUSED(view[1], INFINITY, "view of the picture is (0, inf, 0)");
    REFUSED(up[0], NAN, "up of the picture is (nan, 0, 0)");
    REFUSED(zoom, 51, "zoom of the picture is 51; it must be above 0 and at most 50");
    REFUSED(zoom, NAN, "zoom of the picture is nan");
    REFUSED(line_width, -1, "line_width of the picture is -1");
    REFUSED(range[0], 1, "range of the picture is 1 to 0");
    REFUSED(range[1], INFINITY, "range of the picture is 0 to inf");
#undef REFUSED
    cleft_io_picture look = small_picture();
    look.view[1] = -2;
    look.up[1] = 1;
    assert_refused(f, write_look(f, mesh, &look), CLEFT_ERROR_ARGUMENT,
                   "up of the picture is (0, 1, 0); it must be in another direction than view");
    cleft_mesh_destroy(mesh);
}

static void what_cannot_be_drawn_is_refused(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 2, as_it_is);
    static const int32_t all[] = {OUTER, INNER};
    const char* path = path_of(f, "refused.png");
    assert_int_equal(cleft_io_write_picture(NULL, mesh, NULL, 0, NULL, 0, NULL, path), CLEFT_ERROR_NULL);
    assert_refused(f, cleft_io_write_picture(f->context, NULL, NULL, 0, NULL, 0, NULL, path), CLEFT_ERROR_NULL, "mesh");
    assert_refused(f, cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, NULL, NULL), CLEFT_ERROR_NULL, "path");
    assert_refused(f, cleft_io_write_picture(f->context, mesh, NULL, 1, NULL, 0, NULL, path), CLEFT_ERROR_NULL,
                   "strip");
    assert_refused(f, cleft_io_write_picture(f->context, mesh, NULL, 0, all, -1, NULL, path), CLEFT_ERROR_ARGUMENT,
                   "the number of labels in whole is -1");
    assert_refused(f, cleft_io_write_picture(f->context, mesh, all, 2, NULL, 0, NULL, path), CLEFT_ERROR_ARGUMENT,
                   "the picture would be empty: strip and cut leave no tetrahedron");
    assert_refused(f, cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, NULL, path_of(f, "a.jpg")),
                   CLEFT_ERROR_ARGUMENT, "a.jpg': a picture is written as .png");
    assert_refused(f, cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, NULL, path_of(f, "none/a.png")),
                   CLEFT_ERROR_FILE, "none/a.png");
    cleft_mesh_destroy(mesh);
    assert_int_equal(cleft_mesh_create(f->context, 0, NULL, 0, NULL, NULL, 0, &mesh), CLEFT_OK);
    assert_refused(f, cleft_io_write_picture(f->context, mesh, NULL, 0, NULL, 0, NULL, path_of(f, "refused.png")),
                   CLEFT_ERROR_ARGUMENT, "the mesh has no tetrahedra to draw");
    cleft_mesh_destroy(mesh);
    /* Nothing was written. */
    assert_int_not_equal(access(path_of(f, "refused.png"), F_OK), 0);
}

static void keep_sentence(int32_t level, const char* sentence, void* user)
{
    assert_int_equal(level, CLEFT_LOG_WARNING);
    strcat(user, sentence);
    strcat(user, ";");
}

static void unknown_labels_are_warned_about(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 3, as_it_is);
    char sentences[500] = "";
    assert_int_equal(cleft_context_set_log(f->context, keep_sentence, sentences), CLEFT_OK);
    picture p = draw_some(f, mesh, NULL, 77, -5);
    free(p.rgba);
    assert_string_equal(sentences,
                        "strip names label 77, which the mesh does not have;"
                        "whole names label -5, which the mesh does not have;");
    cleft_mesh_destroy(mesh);
}

static void what_a_legend_cannot_show_is_told(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 3, as_it_is);
    char sentences[500] = "";
    assert_int_equal(cleft_context_set_log(f->context, keep_sentence, sentences), CLEFT_OK);
    /* "日本" */
    assert_int_equal(cleft_mesh_set_label_name(mesh, OUTER, "Gr\u00f6\u00dfe \u65e5\u672c"), CLEFT_OK);
    cleft_io_picture look = small_picture();
    picture p = draw(f, mesh, &look);
    free(p.rgba);
    assert_string_equal(sentences, "");
    look.legend = 1;
    p = draw(f, mesh, &look);
    free(p.rgba);
    assert_non_null(strstr(sentences,
                           "the legend can draw Latin and Greek letters alone, and shows others as '?': in "
                           "the names of 1 label, '"));
    assert_non_null(strstr(sentences, "Gr\u00f6\u00dfe \u65e5\u672c';"));
    cleft_mesh_destroy(mesh);
}

/* The picture of a legend with one name. */
static picture legend_with(fixture* f, const char* name)
{
    cleft_mesh* mesh = make_box(f->context, 1, as_it_is);
    assert_int_equal(cleft_mesh_set_label_name(mesh, OUTER, name), CLEFT_OK);
    cleft_io_picture look = small_picture();
    look.width = 600;
    look.height = 600;
    look.legend = 1;
    picture p = draw(f, mesh, &look);
    cleft_mesh_destroy(mesh);
    return p;
}

static int64_t differing_pixels(const picture* a, const picture* b)
{
    int64_t count = 0;
    assert_true(a->width == b->width && a->height == b->height);
    for (int64_t i = 0; i < (int64_t)a->width * a->height; ++i)
        count += memcmp(a->rgba + 4 * i, b->rgba + 4 * i, 4) != 0;
    return count;
}

/* Each letter has strokes of its own, and a mark is seen whether it comes with its letter or behind it. */
static void legends_have_letters_with_marks(void** state)
{
    static const char* const names[][2] = {
        {"\u00e9", "e\u0301"}, {"\u00c4", "A\u0308"}, {"\u00ef", "i\u0308"}, {"\u0107", "c\u0301"},
        {"\u0150", "O\u030b"}, {"\u0119", "e\u0328"}, {"\u00f1", "n\u0303"}, {"\u016f", "u\u030a"},
    };
    static const char* const others[] = {"\u00df", "\u00e6", "\u0142", "\u00f8", "\u00b5", "\u03b1",
                                         "\u03c9", "\u03a9", "\u0394", "\u00bf", "\u00b2", "\u0131"};
    fixture* f = *state;
    char sentences[500] = "";
    assert_int_equal(cleft_context_set_log(f->context, keep_sentence, sentences), CLEFT_OK);
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        const char plain[] = {names[i][1][0], '\0'};
        picture one = legend_with(f, names[i][0]), two = legend_with(f, names[i][1]), without = legend_with(f, plain);
        assert_int_equal(differing_pixels(&one, &two), 0);
        assert_true(differing_pixels(&one, &without) > 2);
        free(one.rgba);
        free(two.rgba);
        free(without.rgba);
    }
    picture last = legend_with(f, "e");
    for (size_t i = 0; i < sizeof others / sizeof *others; ++i) {
        picture next = legend_with(f, others[i]);
        assert_true(last.width != next.width || differing_pixels(&last, &next) > 2);
        free(last.rgba);
        last = next;
    }
    free(last.rgba);
    assert_string_equal(sentences, "");
}

/* However near one looks. */
static void a_mesh_ends_at_its_legend(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 2, as_it_is);
    cleft_io_picture look = small_picture();
    look.by = CLEFT_IO_BY_ANGLE;
    look.zoom = 20;
    look.no_edges = 1;
    picture without = draw(f, mesh, &look);
    look.legend = 1;
    picture with = draw(f, mesh, &look);
    for (int y = 0; y < with.height; ++y) {
        /* The last column is of the mesh, or behind the legend. */
        const uint8_t* pixel = pixel_at(&with, with.width - 1, y);
        assert_false(is_color(pixel_at(&without, with.width - 1, y), 255, 255, 255));
        assert_true(is_color(pixel, 255, 255, 255));
    }
    free(with.rgba);
    free(without.rgba);
    cleft_mesh_destroy(mesh);
}

/* Sizes that differ by rounding alone have one colour, and a sentence says so. */
static void one_size_has_one_colour(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 3, with_rounding);
    char sentences[500] = "";
    assert_int_equal(cleft_context_set_log(f->context, keep_sentence, sentences), CLEFT_OK);
    cleft_io_picture look = small_picture();
    look.by = CLEFT_IO_BY_SIZE;
    look.no_edges = 1;
    look.legend = 1;
    picture p = draw(f, mesh, &look);
    assert_non_null(strstr(sentences, "all tetrahedra of the picture have the same size, "));
    /* The middle of the colours, and neither of its ends. */
    int64_t green = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = 0; x < p.width; ++x) {
            const unsigned char* pixel = pixel_at(&p, x, y);
            green += pixel[1] > pixel[0] + 30 && pixel[1] > pixel[2];
            assert_false(pixel[0] > 200 && pixel[2] < 190);
            assert_false(pixel[2] > pixel[1] + 40);
        }
    assert_true(green > 100);
    free(p.rgba);
    sentences[0] = '\0';
    look.range[0] = 0.1;
    look.range[1] = 10;
    p = draw(f, mesh, &look);
    free(p.rgba);
    assert_string_equal(sentences, "");
    cleft_mesh_destroy(mesh);
}

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(size_is_as_asked),
        TEST(pictures_of_any_size_are_read),
        TEST(scale_does_not_matter),
        TEST(thousands_of_labels_are_drawn),
        TEST(broken_meshes_are_drawn),
        TEST(values_that_cannot_be_are_refused),
        TEST(what_cannot_be_drawn_is_refused),
        TEST(unknown_labels_are_warned_about),
        TEST(what_a_legend_cannot_show_is_told),
        TEST(legends_have_letters_with_marks),
        TEST(a_mesh_ends_at_its_legend),
        TEST(one_size_has_one_colour),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
