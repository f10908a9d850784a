/* Meshes made block by block: valid, as good as that of the whole, with its volumes, and the same for any threads. */
#include "support/capi.h"

#include <math.h>
#include <string.h>

enum { SIDE = 24 };

static cleft_options* options_of(const char* background, const char* block)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", background), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "block", block), CLEFT_OK);
    /* What the thinnest of the blocks below allow: sizes are at most a quarter of a block. */
    assert_int_equal(cleft_options_set_text(options, "size_max", "1.5"), CLEFT_OK);
    return options;
}

static cleft_mesh* mesh_of(cleft_context* context, const cleft_volume* volume, const char* background,
                           const char* block)
{
    cleft_options* options = options_of(background, block);
    cleft_mesh* mesh = NULL;
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    cleft_options_destroy(options);
    return mesh;
}

static void assert_valid(cleft_context* context, const cleft_mesh* mesh)
{
    cleft_validation found;
    memset(&found, 0, sizeof found);
    found.struct_size = sizeof found;
    assert_ok(context, cleft_mesh_validate(context, mesh, 1, &found));
    assert_int_equal(found.valid, 1);
}

static void assert_volumes(cleft_context* context, const cleft_volume* volume, const cleft_mesh* mesh)
{
    cleft_report* report = NULL;
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    assert_int_equal(cleft_report_count(report), 3);
    for (int32_t i = 0; i < cleft_report_count(report); ++i) {
        cleft_label_report row;
        memset(&row, 0, sizeof row);
        row.struct_size = sizeof row;
        assert_int_equal(cleft_report_label(report, i, &row), CLEFT_OK);
        assert_true(fabs(row.mesh_volume / row.voxel_volume - 1) < 0.01);
        assert_int_equal(row.mesh_components, row.voxel_components);
    }
    cleft_report_destroy(report);
}

static int are_same(const cleft_mesh* a, const cleft_mesh* b)
{
    const int64_t points = cleft_mesh_point_count(a), tets = cleft_mesh_tet_count(a);
    return points == cleft_mesh_point_count(b) && tets == cleft_mesh_tet_count(b) &&
           !memcmp(cleft_mesh_points(a), cleft_mesh_points(b), sizeof(double) * 3 * (size_t)points) &&
           !memcmp(cleft_mesh_tets(a), cleft_mesh_tets(b), sizeof(int32_t) * 4 * (size_t)tets) &&
           !memcmp(cleft_mesh_tet_labels(a), cleft_mesh_tet_labels(b), sizeof(int32_t) * (size_t)tets);
}

static void blocks_are_as_good_as_the_whole(void** state)
{
    static const char* const kBackgrounds[] = {"particles", "octree", "lattice"};
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, SIDE);
    for (size_t b = 0; b < sizeof kBackgrounds / sizeof *kBackgrounds; ++b) {
        cleft_mesh* whole = mesh_of(context, volume, kBackgrounds[b], "0");
        cleft_mesh* blocks = mesh_of(context, volume, kBackgrounds[b], "8");
        cleft_quality quality;
        memset(&quality, 0, sizeof quality);
        quality.struct_size = sizeof quality;
        assert_valid(context, blocks);
        assert_volumes(context, volume, blocks);
        assert_int_equal(cleft_mesh_quality(context, blocks, &quality), CLEFT_OK);
        assert_true(quality.min_dihedral > 24.99);
        /* Seams take some more tetrahedra, but hardly any. */
        assert_true(fabs((double)cleft_mesh_tet_count(blocks) / (double)cleft_mesh_tet_count(whole) - 1) < 0.1);
        assert_false(are_same(blocks, whole));
        cleft_mesh_destroy(whole);
        cleft_mesh_destroy(blocks);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* A block that is as thick as the volume is the volume. */
static void one_block_is_the_whole(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 12);
    cleft_mesh *whole = mesh_of(context, volume, "octree", "0"), *block = mesh_of(context, volume, "octree", "12");
    assert_true(are_same(whole, block));
    cleft_mesh_destroy(whole);
    cleft_mesh_destroy(block);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static void any_threads_make_the_same_blocks(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, SIDE);
    for (int kind = 0; kind < 2; ++kind) {
        const char* const background = kind == 0 ? "octree" : "particles";
        assert_int_equal(cleft_context_set_threads(context, 1), CLEFT_OK);
        cleft_mesh* one = mesh_of(context, volume, background, "6");
        for (int32_t threads = 2; threads < 4; ++threads) {
            assert_int_equal(cleft_context_set_threads(context, threads), CLEFT_OK);
            cleft_mesh* some = mesh_of(context, volume, background, "6");
            assert_true(are_same(one, some));
            cleft_mesh_destroy(some);
        }
        cleft_mesh_destroy(one);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* Blocks of one plane are thinner than their tetrahedra: the mesh is worse, but it is one. */
static void thin_blocks_are_valid(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, 12);
    for (int kind = 0; kind < 2; ++kind) {
        cleft_mesh* mesh = mesh_of(context, volume, kind == 0 ? "octree" : "particles", "1");
        assert_valid(context, mesh);
        cleft_mesh_destroy(mesh);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* One of the user, too: tetrahedra that are as long as their block is thick could not be improved. */
static void no_size_is_above_a_quarter_of_a_block(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, SIDE);
    static const char* const kNames[] = {"size", "size_max"};
    for (size_t i = 0; i < sizeof kNames / sizeof *kNames; ++i) {
        cleft_options* options = options_of("octree", "8");
        cleft_sizing* sizing = NULL;
        assert_int_equal(cleft_options_set_text(options, "size_max", "0"), CLEFT_OK);
        assert_int_equal(cleft_options_set_text(options, kNames[i], "6"), CLEFT_OK);
        assert_ok(context, cleft_sizing_create(context, volume, options, &sizing));
        for (int v = 0; v < SIDE * SIDE * SIDE; ++v)
            assert_true(cleft_sizing_values(sizing)[v] <= 2);
        cleft_sizing_destroy(sizing);
        cleft_options_destroy(options);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static cleft_mesh* background_of(cleft_context* context, const cleft_sizing* sizing, const char* block)
{
    cleft_options* options = options_of("particles", block);
    cleft_mesh* background = NULL;
    assert_ok(context, cleft_background_create(context, sizing, options, &background));
    cleft_options_destroy(options);
    return background;
}

static double volume_of(const cleft_mesh* mesh)
{
    const double* points = cleft_mesh_points(mesh);
    double volume = 0;
    for (int64_t t = 0; t < cleft_mesh_tet_count(mesh); ++t) {
        const int32_t* tet = cleft_mesh_tets(mesh) + 4 * t;
        double e[3][3];
        for (int i = 0; i < 3; ++i)
            for (int a = 0; a < 3; ++a)
                e[i][a] = points[3 * tet[i + 1] + a] - points[3 * tet[0] + a];
        const double sixfold = e[0][0] * (e[1][1] * e[2][2] - e[1][2] * e[2][1]) -
                               e[0][1] * (e[1][0] * e[2][2] - e[1][2] * e[2][0]) +
                               e[0][2] * (e[1][0] * e[2][1] - e[1][1] * e[2][0]);
        assert_true(sixfold > 0);
        volume += sixfold / 6;
    }
    return volume;
}

static int64_t points_at_height(const cleft_mesh* mesh, double z)
{
    int64_t count = 0;
    for (int64_t p = 0; p < cleft_mesh_point_count(mesh); ++p)
        count += cleft_mesh_points(mesh)[3 * p + 2] == z;
    return count;
}

/* Both blocks beside a cut have the same particles in it, and the same triangles. Three blocks: the middle one gets
   both. Sizes that grow from block to block, and one size, for which particles begin as a lattice. */
static void particles_of_blocks_meet(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, SIDE);
    for (int kind = 0; kind < 2; ++kind) {
        float sizes[SIDE * SIDE * SIDE];
        for (int v = 0; v < SIDE * SIDE * SIDE; ++v)
            sizes[v] = kind == 0 ? 1.8F : 0.8F + 0.05F * (float)(v / (SIDE * SIDE));
        cleft_sizing* sizing = NULL;
        assert_ok(context, cleft_sizing_create_values(context, volume, CLEFT_TYPE_FLOAT32, sizes, 0, NULL, &sizing));
        cleft_mesh *blocks = background_of(context, sizing, "8"), *whole = background_of(context, sizing, "0");
        /* No triangle of the hull is inside the box: it would be one that a block has and its neighbour has not. */
        assert_valid(context, blocks);
        assert_true(fabs(volume_of(blocks) / (SIDE * SIDE * SIDE) - 1) < 1e-9);
        assert_true(fabs(volume_of(whole) / (SIDE * SIDE * SIDE) - 1) < 1e-9);
        assert_true(fabs((double)cleft_mesh_tet_count(blocks) / (double)cleft_mesh_tet_count(whole) - 1) < 0.1);
        for (int cut = 1; cut < 3; ++cut) {
            /* About 1.2 for each square of the size. */
            const double wanted = 1.2 * SIDE * SIDE / pow((double)sizes[SIDE * SIDE * (8 * cut)], 2);
            const double ratio = (double)points_at_height(blocks, 8 * cut) / wanted;
            assert_true(ratio > 0.8 && ratio < 1.4);
        }
        cleft_mesh_destroy(blocks);
        cleft_mesh_destroy(whole);
        cleft_sizing_destroy(sizing);
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* A wall with nothing but its corners: they lie on a circle, and both sides must take the same diagonal. */
static void particles_of_columns_meet(void** state)
{
    enum { LONG = 60 };
    static const int64_t kDims[3] = {1, 2, LONG};
    static const double kUnit[12] = {1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5};
    (void)state;
    uint8_t labels[2 * LONG] = {0};
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    cleft_sizing* sizing = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, labels, kDims, kUnit, NULL, &volume));
    assert_ok(context, cleft_sizing_create_constant(context, volume, 2.5, &sizing));
    for (int tetgen = 0; tetgen <= cleft_has_tetgen(); ++tetgen) {
        cleft_options* options = options_of("particles", "6");
        cleft_mesh* background = NULL;
        assert_int_equal(cleft_options_set_text(options, "delaunay", tetgen ? "tetgen" : "cleft"), CLEFT_OK);
        assert_ok(context, cleft_background_create(context, sizing, options, &background));
        assert_valid(context, background);
        assert_true(fabs(volume_of(background) / (2 * LONG) - 1) < 1e-9);
        for (int cut = 1; cut < 10; ++cut)
            assert_int_equal(points_at_height(background, 6 * cut), 4);
        cleft_mesh_destroy(background);
        cleft_options_destroy(options);
    }
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* In blocks that are thinner than two sizes, tetrahedra from wall to wall would be flat. */
static void thin_blocks_have_the_particles_of_the_whole(void** state)
{
    (void)state;
    cleft_context* context = new_context();
    cleft_volume* volume = ball_volume(context, SIDE);
    cleft_sizing* sizing = NULL;
    assert_ok(context, cleft_sizing_create_constant(context, volume, 2.1, &sizing));
    cleft_mesh *whole = background_of(context, sizing, "0"), *thin = background_of(context, sizing, "4");
    cleft_mesh* thick = background_of(context, sizing, "6");
    assert_true(are_same(whole, thin));
    assert_false(are_same(whole, thick));
    cleft_mesh_destroy(whole);
    cleft_mesh_destroy(thin);
    cleft_mesh_destroy(thick);
    cleft_sizing_destroy(sizing);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

/* A tree has its roots whatever the sizes are: blocks must not hide how many a thin box needs. */
static void blocks_keep_to_max_tets(void** state)
{
    enum { LONG = 4, PLANES = 40 };
    static const int64_t kDims[3] = {LONG, 1, PLANES};
    static const double kStretched[12] = {400, 0, 0, 0, 0, 1, 0, 0, 0, 0, 100, 0};
    int32_t labels[LONG * PLANES];
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    cleft_options* options = NULL;
    (void)state;
    for (int v = 0; v < LONG * PLANES; ++v)
        labels[v] = v / LONG / 10;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", "octree"), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "max_tets", "20000"), CLEFT_OK);
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, labels, kDims, kStretched, NULL, &volume));
    for (int blocks = 0; blocks < 2; ++blocks) {
        cleft_mesh* mesh = NULL;
        assert_int_equal(cleft_options_set_text(options, "block", blocks ? "10" : "0"), CLEFT_OK);
        assert_fails(context, CLEFT_ERROR_TOO_LARGE, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
        assert_non_null(strstr(cleft_context_last_error(context), "the box is so thin"));
    }
    cleft_options_destroy(options);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(blocks_are_as_good_as_the_whole),
        cmocka_unit_test(one_block_is_the_whole),
        cmocka_unit_test(any_threads_make_the_same_blocks),
        cmocka_unit_test(thin_blocks_are_valid),
        cmocka_unit_test(no_size_is_above_a_quarter_of_a_block),
        cmocka_unit_test(blocks_keep_to_max_tets),
        cmocka_unit_test(particles_of_columns_meet),
        cmocka_unit_test(particles_of_blocks_meet),
        cmocka_unit_test(thin_blocks_have_the_particles_of_the_whole),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
