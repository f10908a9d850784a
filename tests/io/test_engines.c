/* The Delaunay engines give the same bytes of the mesh, for the test volumes and several seeds; without TetGen, it is
 * refused where it is asked for. */
#include "cleft/cleft_io.h"
#include "support/capi.h"

#include <stdio.h>
#include <string.h>

static cleft_volume* read_volume(cleft_context* context, const char* name)
{
    char path[1024];
    const char* paths[1] = {path};
    cleft_volume* volume = NULL;
    snprintf(path, sizeof path, "%s/%s.nrrd", TEST_DATA, name);
    assert_ok(context, cleft_io_read_volume(context, NULL, paths, 1, NULL, &volume));
    return volume;
}

static cleft_mesh* mesh_by(cleft_context* context, const cleft_volume* volume, int64_t engine, int64_t seed)
{
    cleft_options* options = NULL;
    cleft_mesh* mesh = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_DELAUNAY, engine), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_SEED, seed), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "improve", "off"), CLEFT_OK);
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    cleft_options_destroy(options);
    return mesh;
}

static void assert_same_bytes(const cleft_mesh* a, const cleft_mesh* b)
{
    const size_t points = (size_t)cleft_mesh_point_count(a), tets = (size_t)cleft_mesh_tet_count(a);
    assert_int_equal(cleft_mesh_point_count(b), points);
    assert_int_equal(cleft_mesh_tet_count(b), tets);
    assert_memory_equal(cleft_mesh_points(a), cleft_mesh_points(b), points * 3 * sizeof(double));
    assert_memory_equal(cleft_mesh_tets(a), cleft_mesh_tets(b), tets * 4 * sizeof(int32_t));
    assert_memory_equal(cleft_mesh_tet_labels(a), cleft_mesh_tet_labels(b), tets * sizeof(int32_t));
}

static void both_engines_give_the_same_mesh(void** state)
{
    static const char* const names[] = {"CIT168", "mickey", "spheres1", "spheres2", "spheres3", "spheres4"};
    (void)state;
    if (!cleft_has_tetgen())
        skip();
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        cleft_context* context = new_context();
        cleft_volume* volume = read_volume(context, names[i]);
        for (int64_t seed = 0; seed < 3; ++seed) {
            cleft_mesh* own = mesh_by(context, volume, CLEFT_DELAUNAY_CLEFT, seed);
            cleft_mesh* other = mesh_by(context, volume, CLEFT_DELAUNAY_TETGEN, seed);
            assert_same_bytes(own, other);
            cleft_mesh_destroy(own);
            cleft_mesh_destroy(other);
        }
        cleft_volume_destroy(volume);
        cleft_context_destroy(context);
    }
}

static void tetgen_is_refused_where_it_is_not(void** state)
{
    cleft_options* options = NULL;
    (void)state;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    const cleft_status status = cleft_options_set_text(options, "delaunay", "tetgen");
    if (cleft_has_tetgen()) {
        assert_int_equal(status, CLEFT_OK);
    } else {
        assert_int_equal(status, CLEFT_ERROR_UNSUPPORTED);
        assert_string_equal(cleft_options_last_error(options), "delaunay is tetgen, and this library has no TetGen");
    }
    cleft_options_destroy(options);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(both_engines_give_the_same_mesh),
        cmocka_unit_test(tetgen_is_refused_where_it_is_not),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
