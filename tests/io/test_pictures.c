/* Pictures of meshes: what they show, and what cannot be drawn. Pixels are read back by libpng. */
#include "folder_fixture.h"

#include <math.h>
#include <png.h>

enum { SIDE = 120 };
enum { OUTER = 1, INNER = 2 };

typedef struct picture {
    int width, height;
    uint8_t* rgba; /* four bytes a pixel */
} picture;

static cleft_io_picture small_picture(void)
{
    const cleft_io_picture look = {.struct_size = sizeof look, .width = SIDE, .height = SIDE};
    return look;
}

static picture read_png(const char* path)
{
    png_image image = {.version = PNG_IMAGE_VERSION};
    assert_true(png_image_begin_read_from_file(&image, path));
    image.format = PNG_FORMAT_RGBA;
    picture out = {(int)image.width, (int)image.height, malloc(PNG_IMAGE_SIZE(image))};
    assert_true(png_image_finish_read(&image, NULL, out.rgba, 0, NULL));
    return out;
}

static const uint8_t* pixel_at(const picture* p, int x, int y) { return p->rgba + 4 * (y * p->width + x); }
static const uint8_t* middle_of(const picture* p) { return pixel_at(p, p->width / 2, p->height / 2); }

/* The hues of labels 1 and 2, in any light. */
static int is_sky_blue(const uint8_t* c) { return c[2] > c[1] && c[1] > c[0] && c[2] > c[0] + 40; }
static int is_orange(const uint8_t* c) { return c[0] > c[1] && c[1] > c[2] && c[0] > c[2] + 40; }
static int is_grey(const uint8_t* c) { return abs(c[0] - c[2]) < 20 && abs(c[0] - c[1]) < 20; }
static int is_color(const uint8_t* c, int red, int green, int blue)
{
    return c[0] == red && c[1] == green && c[2] == blue;
}

static int64_t count_if(const picture* p, int (*holds)(const uint8_t*))
{
    int64_t count = 0;
    for (int i = 0; i < p->width * p->height; ++i)
        count += holds(p->rgba + 4 * i);
    return count;
}

/* A box of n x n x n cubes of six tetrahedra; label INNER where no cube is at the wall. `map` moves the points. */
static cleft_mesh* make_box(cleft_context* context, int n, double (*map)(double))
{
    static const int paths[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    const int m = n + 1;
    double* points = malloc(sizeof(double) * 3 * (size_t)(m * m * m));
    int32_t* tets = malloc(sizeof(int32_t) * 24 * (size_t)(n * n * n));
    int32_t* labels = malloc(sizeof(int32_t) * 6 * (size_t)(n * n * n));
    for (int p = 0; p < m * m * m; ++p) {
        points[3 * p] = map(p % m);
        points[3 * p + 1] = map(p / m % m);
        points[3 * p + 2] = map(p / m / m);
    }
    for (int c = 0; c < n * n * n; ++c) {
        const int i = c % n, j = c / n % n, k = c / n / n;
        const int low = i < j ? (i < k ? i : k) : (j < k ? j : k), high = i > j ? (i > k ? i : k) : (j > k ? j : k);
        for (int t = 0; t < 6; ++t) {
            for (int v = 0; v < 4; ++v) {
                const int corner = paths[t][v];
                tets[24 * c + 4 * t + v] = i + (corner & 1) + m * (j + (corner >> 1 & 1) + m * (k + (corner >> 2)));
            }
            labels[6 * c + t] = low > 0 && high < n - 1 ? INNER : OUTER;
        }
    }
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(context, m * m * m, points, 6 * n * n * n, tets, labels, 0, &mesh), CLEFT_OK);
    free(points);
    free(tets);
    free(labels);
    return mesh;
}

static double as_it_is(double x) { return x; }
static double in_parts_of_1024(double x) { return x / 1024; }
static double nearly_too_large(double x) { return (x - 3) * 0.55e308; }
static double nearly_too_small(double x) { return x * 1e-300; }

static picture draw_some(fixture* f, const cleft_mesh* mesh, const cleft_io_picture* look, int32_t strip, int32_t whole)
{
    const char* path = path_of(f, "a.png");
    const cleft_status status =
        cleft_io_write_picture(f->context, mesh, &strip, strip != 0, &whole, whole != 0, look, path);
    if (status != CLEFT_OK)
        fail_msg("%s", cleft_context_last_error(f->context));
    return read_png(path);
}

static picture draw(fixture* f, const cleft_mesh* mesh, const cleft_io_picture* look)
{
    return draw_some(f, mesh, look, 0, 0);
}

static void mesh_stands_before_the_backdrop(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 6, as_it_is);
    cleft_io_picture look = small_picture();
    static const int corners[3][4] = {{255, 255, 255, 255}, {20, 22, 27, 255}, {0, 0, 0, 0}};
    for (int backdrop = 0; backdrop < 3; ++backdrop) {
        look.backdrop = backdrop;
        picture p = draw(f, mesh, &look);
        for (int corner = 0; corner < 4; ++corner)
            for (int c = 0; c < 4; ++c)
                assert_int_equal(pixel_at(&p, corner % 2 * (SIDE - 1), corner / 2 * (SIDE - 1))[c],
                                 corners[backdrop][c]);
        assert_true(is_sky_blue(middle_of(&p)));
        assert_int_equal(middle_of(&p)[3], 255);
        free(p.rgba);
    }
    cleft_mesh_destroy(mesh);
}

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

static void cut_shows_what_is_inside(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 6, as_it_is);
    for (int axis = 0; axis < 3; ++axis)
        for (int side = -1; side <= 1; side += 2) {
            cleft_io_picture look = small_picture();
            look.view[axis] = side;
            picture p = draw(f, mesh, &look);
            assert_true(is_sky_blue(middle_of(&p)));
            assert_int_equal(count_if(&p, is_orange), 0);
            free(p.rgba);
            look.cut[axis] = 0.5;
            p = draw(f, mesh, &look);
            assert_true(is_orange(middle_of(&p)));
            assert_true(count_if(&p, is_sky_blue) > 0);
            free(p.rgba);
        }
    cleft_mesh_destroy(mesh);
}

/* Three cuts take one corner away, and not three halves. */
static void cuts_take_a_corner(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 6, as_it_is);
    cleft_io_picture look = small_picture();
    look.view[0] = look.view[1] = look.view[2] = 1;
    picture whole = draw(f, mesh, &look);
    look.cut[0] = look.cut[1] = look.cut[2] = 0.5;
    picture open = draw(f, mesh, &look);
    assert_true(is_orange(middle_of(&open)));
    /* The outline stays: the corner is before the rest. */
    int64_t differing = 0;
    for (int i = 0; i < SIDE * SIDE; ++i)
        differing += is_color(whole.rgba + 4 * i, 255, 255, 255) != is_color(open.rgba + 4 * i, 255, 255, 255);
    assert_true(differing < SIDE);
    free(whole.rgba);
    free(open.rgba);
    cleft_mesh_destroy(mesh);
}

static void lists_leave_labels_out_or_whole(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 6, as_it_is);
    cleft_io_picture look = small_picture();
    look.view[1] = -1;
    picture p = draw_some(f, mesh, &look, OUTER, 0);
    assert_true(is_orange(middle_of(&p)));
    assert_int_equal(count_if(&p, is_sky_blue), 0);
    free(p.rgba);
    look.cut[1] = 0.95; /* behind the inner label */
    p = draw_some(f, mesh, &look, 0, INNER);
    assert_true(is_orange(middle_of(&p)));
    free(p.rgba);
    p = draw(f, mesh, &look);
    assert_true(is_sky_blue(middle_of(&p)));
    free(p.rgba);
    look.cut[1] = 0.5; /* into the hole that the inner label leaves */
    p = draw_some(f, mesh, &look, INNER, 0);
    assert_true(is_sky_blue(middle_of(&p)));
    assert_int_equal(count_if(&p, is_orange), 0);
    free(p.rgba);
    cleft_mesh_destroy(mesh);
}

static int is_dark(const uint8_t* c) { return c[0] + c[1] + c[2] < 300; }

static void edges_are_dark_lines(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 3, as_it_is);
    cleft_io_picture look = small_picture();
    look.width = look.height = 400;
    look.view[2] = 1;
    int64_t dark[3];
    for (int i = 0; i < 3; ++i) {
        look.no_edges = i == 0;
        look.line_width = i == 2 ? 4 : 0;
        picture p = draw(f, mesh, &look);
        dark[i] = count_if(&p, is_dark);
        free(p.rgba);
    }
    assert_int_equal(dark[0], 0);
    /* Four lines each way and six diagonals, each about 360 pixels long; wide ones do not fade. */
    assert_true(dark[1] > 2000 && dark[1] < 10000);
    assert_true(dark[2] > 2 * dark[1]);
    cleft_mesh_destroy(mesh);
}

/* FNV-1a. */
static uint64_t digest(const picture* p)
{
    uint64_t sum = 0xcbf29ce484222325;
    for (int i = 0; i < 4 * p->width * p->height; ++i)
        sum = (sum ^ p->rgba[i]) * 0x100000001b3;
    return sum;
}

static void assert_same(const picture* a, const picture* b)
{
    assert_int_equal(a->width, b->width);
    assert_int_equal(a->height, b->height);
    assert_memory_equal(a->rgba, b->rgba, 4 * (size_t)(a->width * a->height));
}

static void pixels_depend_on_the_mesh_alone(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 24, as_it_is);
    cleft_io_picture look = small_picture();
    look.width = 333;
    look.cut[0] = look.cut[1] = look.cut[2] = 0.5;
    look.legend = 1;
    for (int by = CLEFT_IO_BY_LABEL; by <= CLEFT_IO_BY_SIZE; ++by) {
        look.by = by;
        picture first = {0};
        for (int threads = 1; threads <= 4; ++threads) {
            assert_int_equal(cleft_context_set_threads(f->context, threads), CLEFT_OK);
            picture p = draw(f, mesh, &look);
            if (threads == 1)
                first = p;
            else {
                assert_same(&p, &first);
                free(p.rgba);
            }
        }
        free(first.rgba);
    }
    cleft_mesh_destroy(mesh);
}

/* What gcc and clang of any machine must give; a change of the drawing changes it. */
static void pixels_are_those_of_every_machine(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 8, as_it_is);
    cleft_io_picture look = small_picture();
    look.cut[0] = look.cut[1] = 0.5;
    look.legend = 1;
    static const uint64_t digests[] = {0xd1b1239ac4a5b248, 0x107d0cfdd4a2e98d, 0xb8adb57ce58c2a06, 0xf7c0cb1bed44cacd};
    int wrong = 0;
    for (int by = CLEFT_IO_BY_LABEL; by <= CLEFT_IO_BY_SIZE; ++by) {
        look.by = by;
        picture p = draw(f, mesh, &look);
        if (digest(&p) != digests[by]) {
            print_error("coloured by %d, the digest of the pixels is 0x%llx\n", by, (unsigned long long)digest(&p));
            ++wrong;
        }
        free(p.rgba);
    }
    assert_int_equal(wrong, 0);
    cleft_mesh_destroy(mesh);
}

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

static int is_red(const uint8_t* c) { return c[0] > 2 * c[1] && c[0] > 2 * c[2]; }
static int is_blue(const uint8_t* c) { return c[2] > c[1] + 40 && c[2] > 2 * c[0]; }

/* A regular tetrahedron, and a flat one whose label is 2. */
static cleft_mesh* make_good_and_flat(cleft_context* context)
{
    static const double points[] = {0, 0, 0, 1, 1, 0, 1, 0, 1, 0, 1, 1, 3, 0, 0, 4, 0, 0, 4, 0, 1, 3, 1e-3, 1};
    static const int32_t tets[] = {0, 1, 2, 3, 4, 5, 6, 7};
    static const int32_t labels[] = {1, 2};
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(context, 8, points, 2, tets, labels, 0, &mesh), CLEFT_OK);
    return mesh;
}

static void measures_give_the_colour(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_good_and_flat(f->context);
    cleft_io_picture look = small_picture();
    look.view[1] = -1;
    look.no_edges = 1;
    for (look.by = CLEFT_IO_BY_ANGLE; look.by <= CLEFT_IO_BY_RATIO; ++look.by) {
        picture p = draw_some(f, mesh, &look, 2, 0);
        assert_true(is_blue(middle_of(&p)));
        assert_int_equal(count_if(&p, is_red), 0);
        free(p.rgba);
        p = draw_some(f, mesh, &look, 1, 0);
        assert_true(is_red(middle_of(&p)));
        assert_int_equal(count_if(&p, is_blue), 0);
        free(p.rgba);
    }
    /* Another range turns poor into good. */
    look.by = CLEFT_IO_BY_ANGLE;
    look.range[0] = -2;
    look.range[1] = -1;
    picture p = draw_some(f, mesh, &look, 1, 0);
    assert_true(is_blue(middle_of(&p)));
    free(p.rgba);
    cleft_mesh_destroy(mesh);
}

/* Text, whose strokes cover few pixels as a whole. */
static int is_ink(const uint8_t* c) { return c[0] < 110 && is_grey(c); }

static void legend_explains_the_colours(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = make_box(f->context, 3, as_it_is);
    cleft_io_picture look = small_picture();
    look.width = 400;
    look.height = 300;
    look.no_edges = 1;
    picture p = draw(f, mesh, &look);
    assert_int_equal(count_if(&p, is_ink), 0);
    free(p.rgba);
    look.legend = 1;
    p = draw(f, mesh, &look);
    const int64_t ink = count_if(&p, is_ink);
    assert_true(ink > 5);
    /* Of labels that are seen only. */
    assert_int_equal(count_if(&p, is_orange), 0);
    free(p.rgba);
    look.cut[1] = 0.5;
    p = draw(f, mesh, &look);
    int64_t swatch = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = p.width * 9 / 10; x < p.width; ++x)
            swatch += is_orange(pixel_at(&p, x, y));
    assert_true(swatch > 50);
    look.cut[1] = 0;
    free(p.rgba);
    /* A name makes more text. A long one is cut short, and what no line of text has stays away from the file. */
    char name[3000];
    memset(name, 'x', sizeof name);
    memcpy(name + sizeof name - 8, "\xc3\xa9<&\">'", 8);
    assert_int_equal(cleft_mesh_set_label_name(mesh, OUTER, name), CLEFT_OK);
    p = draw(f, mesh, &look);
    assert_true(count_if(&p, is_ink) > 3 * ink);
    assert_true(is_sky_blue(pixel_at(&p, 400 * 3 / 10, 150)));
    free(p.rgba);
    look.by = CLEFT_IO_BY_ANGLE;
    p = draw(f, mesh, &look);
    int has_red = 0, has_blue = 0;
    for (int y = 0; y < p.height; ++y)
        for (int x = p.width * 6 / 10; x < p.width; ++x) {
            has_red |= is_red(pixel_at(&p, x, y));
            has_blue |= is_blue(pixel_at(&p, x, y));
        }
    assert_true(has_red && has_blue);
    free(p.rgba);
    cleft_mesh_destroy(mesh);
}

/* Text shrinks until each label has its row. */
static void all_labels_of_an_atlas_are_listed(void** state)
{
    fixture* f = *state;
    enum { LABELS = 40 };
    double points[12 * LABELS];
    int32_t tets[4 * LABELS], labels[LABELS];
    for (int t = 0; t < LABELS; ++t) {
        static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        for (int i = 0; i < 12; ++i)
            points[12 * t + i] = corners[i] + (i % 3 == 0 ? t : 0);
        for (int v = 0; v < 4; ++v)
            tets[4 * t + v] = 4 * t + v;
        labels[t] = t + 1;
    }
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_mesh_create(f->context, 4 * LABELS, points, LABELS, tets, labels, 0, &mesh), CLEFT_OK);
    cleft_io_picture look = small_picture();
    look.width = look.height = 900;
    look.legend = 1;
    picture p = draw(f, mesh, &look);
    /* Rows of the legend: runs of coloured pixels down the column of the swatches. */
    int most = 0;
    for (int x = p.width / 2; x < p.width; ++x) {
        int runs = 0;
        for (int y = 1; y < p.height; ++y)
            runs += is_color(pixel_at(&p, x, y - 1), 255, 255, 255) && !is_color(pixel_at(&p, x, y), 255, 255, 255);
        most = runs > most ? runs : most;
    }
    assert_true(most >= LABELS);
    free(p.rgba);
    cleft_mesh_destroy(mesh);
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

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(mesh_stands_before_the_backdrop),
        TEST(size_is_as_asked),
        TEST(pictures_of_any_size_are_read),
        TEST(cut_shows_what_is_inside),
        TEST(cuts_take_a_corner),
        TEST(lists_leave_labels_out_or_whole),
        TEST(edges_are_dark_lines),
        TEST(pixels_depend_on_the_mesh_alone),
        TEST(pixels_are_those_of_every_machine),
        TEST(scale_does_not_matter),
        TEST(measures_give_the_colour),
        TEST(legend_explains_the_colours),
        TEST(all_labels_of_an_atlas_are_listed),
        TEST(thousands_of_labels_are_drawn),
        TEST(broken_meshes_are_drawn),
        TEST(values_that_cannot_be_are_refused),
        TEST(what_cannot_be_drawn_is_refused),
        TEST(unknown_labels_are_warned_about),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
