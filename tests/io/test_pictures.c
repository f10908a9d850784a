/* Pictures of meshes: what they show. */
#include "pictures.h"

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
    static const uint64_t digests[] = {0xd1b1239ac4a5b248, 0x107d0cfdd4a2e98d, 0xb8adb57ce58c2a06, 0x634ae40fd7ca4da8};
    int wrong = 0;
    for (int by = CLEFT_IO_BY_LABEL; by <= CLEFT_IO_BY_SIZE; ++by) {
        look.by = by;
        /* All sizes of the box are one. */
        look.range[0] = by == CLEFT_IO_BY_SIZE ? 1 : 0;
        look.range[1] = by == CLEFT_IO_BY_SIZE ? 2 : 0;
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

int main(void)
{
#define TEST(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        TEST(mesh_stands_before_the_backdrop),   TEST(cut_shows_what_is_inside), TEST(cuts_take_a_corner),
        TEST(lists_leave_labels_out_or_whole),   TEST(edges_are_dark_lines),     TEST(pixels_depend_on_the_mesh_alone),
        TEST(pixels_are_those_of_every_machine), TEST(measures_give_the_colour), TEST(legend_explains_the_colours),
        TEST(all_labels_of_an_atlas_are_listed),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
