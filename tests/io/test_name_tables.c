/* Names of labels from tables: on volumes and meshes, with a sentence about what is uncertain. */
#include "io/folder_fixture.h"
#include "io/sample_mesh.h"

#include <stdio.h>

static char said[1000];

static void keep_log(int32_t level, const char* sentence, void* user)
{
    (void)user;
    assert_int_equal(level, CLEFT_LOG_WARNING);
    strncat(said, sentence, sizeof said - strlen(said) - 2);
    strcat(said, "\n");
}

/* What was said before is forgotten. */
static const char* written(fixture* f, const char* text)
{
    said[0] = '\0';
    return written_names(f, text);
}

static cleft_mesh* sample(fixture* f)
{
    cleft_mesh* mesh = sample_mesh_create(f->context);
    assert_non_null(mesh);
    assert_int_equal(cleft_context_set_log(f->context, keep_log, NULL), CLEFT_OK);
    return mesh;
}

/* Of the labels 1, 2 and -5. */
static cleft_volume* small_volume(fixture* f)
{
    static const int32_t labels[] = {1, 2, -5, 1, 2, -5, 1, 2};
    static const int64_t dims[] = {2, 2, 2};
    cleft_volume* volume = NULL;
    assert_int_equal(cleft_volume_create_labels(f->context, CLEFT_TYPE_INT32, labels, dims, NULL, NULL, &volume),
                     CLEFT_OK);
    assert_int_equal(cleft_context_set_log(f->context, keep_log, NULL), CLEFT_OK);
    return volume;
}

static void a_volume_gets_the_names_of_a_table(void** state)
{
    fixture* f = *state;
    cleft_volume* volume = small_volume(f);
    assert_int_equal(cleft_volume_set_label_name(volume, -5, "air"), CLEFT_OK);
    assert_int_equal(
        cleft_io_read_volume_names(f->context, written(f, "1 liver\n2\tleft\tlung\n77 no such label\n"), volume),
        CLEFT_OK);
    assert_string_equal(said, "");
    assert_string_equal(cleft_volume_label_name(volume, 1), "liver");
    assert_string_equal(cleft_volume_label_name(volume, 2), "left lung");
    assert_string_equal(cleft_volume_label_name(volume, -5), "air");
    /* A label without a name in the table keeps its own. */
    assert_int_equal(cleft_io_read_volume_names(f->context, written(f, "1\n2 lung\n"), volume), CLEFT_OK);
    assert_string_equal(cleft_volume_label_name(volume, 1), "liver");
    cleft_volume_destroy(volume);
}

static void a_mesh_gets_the_names_of_a_table(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    assert_int_equal(cleft_io_read_mesh_names(f->context, written(f, "3 right lung\n"), mesh), CLEFT_OK);
    assert_string_equal(said, "");
    assert_string_equal(cleft_mesh_label_name(mesh, 3), "right lung");
    assert_string_equal(cleft_mesh_label_name(mesh, -7), "");
    cleft_mesh_destroy(mesh);
}

static void what_is_uncertain_is_told(void** state)
{
    static const struct {
        const char* table;
        const char* said; /* NULL: nothing */
    } rows[] = {
        {"3 right lung\n", NULL},
        {"3 right\n", "it calls label 3 'right', and the mesh 'right lung'; the names of the table are taken"},
        {"3 a b\n-7 c\n", "it calls label -7 'c', and the mesh 'left'; so it is with 2 labels; the names"},
        {"3 x\n3 a b\n", "label 3 is called 'x' and then 'a b', which is taken"},
        {"0 Unknown 0 0 0 0\n3 x 1 2 3 0\n-7 left 1 2 3\n5 Unknown 0 0 0 0\n",
         "line 3 is not a name without blanks and four numbers, as the lines of FreeSurfer around it, so label -7 is "
         "called 'left 1 2 3'"},
        {"3 x 1 2 3 0\n-7 left lung\n", "line 2 is not a name without blanks"},
        {"# ITK-SNAP\n3 255 0 0 0.5 1 1 \"x\"\n4 255 0 0 1 1 1 \"y\"\n-7 left\n5 z\n",
         "line 4 is not six numbers and a name in quotes, as the lines of ITK-SNAP around it, so label -7 is called "
         "'left'; so it is with 2 lines"},
        {"12 bone\n", "it has no name for any label of the mesh"},
        {"3 Area 17\n4 Field 18\n", "taken for no parts of them, as in tables of MRIcron: 'Area 17' is 'Area'"},
    };
    fixture* f = *state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        cleft_mesh* mesh = sample(f);
        assert_int_equal(cleft_mesh_set_label_name(mesh, 3, "right lung"), CLEFT_OK);
        assert_int_equal(cleft_mesh_set_label_name(mesh, -7, "left"), CLEFT_OK);
        assert_int_equal(cleft_io_read_mesh_names(f->context, written(f, rows[i].table), mesh), CLEFT_OK);
        if (rows[i].said)
            assert_non_null(strstr(said, rows[i].said));
        else
            assert_string_equal(said, "");
        assert_true(!rows[i].said || strstr(said, "names.txt': "));
        cleft_mesh_destroy(mesh);
    }
}

/* Headings as those of BIDS, in any order. */
static void columns_have_headings(void** state)
{
    static const char* const tables[] = {
        "index\tname\tabbreviation\tcolor\n0\tair\ta\t#000000\n3\tright lung 1 2 3 "
        "4\tR\t#ff0000\n-7\tn/a\tL\t#00ff00\n",
        "name\tindex\r\nair\t0\r\n\r\nright lung 1 2 3 4\t3\r\nn/a\t-7\r\n",
    };
    static const struct {
        const char* table;
        const char* said;
    } mistakes[] = {
        {"index\tname\n3\n", "line 2: it has fewer columns than the headings"},
        {"index\tname\nn/a\tlung\n", "line 2: it begins with no label"},
        {"label\tname\n3\tlung\n", "line 1: it begins with no label"},
        {"index,name\n3,lung\n", "line 1: it begins with no label"},
        {"index\tname\n3\ta\001b\n", "line 2: the name has a control character"},
    };
    fixture* f = *state;
    for (size_t i = 0; i < sizeof tables / sizeof *tables; ++i) {
        cleft_mesh* mesh = sample(f);
        assert_int_equal(cleft_io_read_mesh_names(f->context, written(f, tables[i]), mesh), CLEFT_OK);
        assert_string_equal(said, "");
        assert_string_equal(cleft_mesh_label_name(mesh, 3), "right lung 1 2 3 4");
        assert_string_equal(cleft_mesh_label_name(mesh, -7), "");
        cleft_mesh_destroy(mesh);
    }
    cleft_mesh* mesh = sample(f);
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; ++i) {
        assert_int_equal(cleft_io_read_mesh_names(f->context, written(f, mistakes[i].table), mesh), CLEFT_ERROR_FORMAT);
        assert_non_null(strstr(cleft_context_last_error(f->context), mistakes[i].said));
    }
    cleft_mesh_destroy(mesh);
}

static void mistakes_are_refused(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    assert_int_equal(cleft_io_read_mesh_names(f->context, written(f, "3 right\nlung\n"), mesh), CLEFT_ERROR_FORMAT);
    assert_non_null(strstr(cleft_context_last_error(f->context), "names.txt', line 2"));
    assert_int_equal(cleft_io_read_mesh_names(f->context, written(f, "3 a\001b\n"), mesh), CLEFT_ERROR_FORMAT);
    assert_non_null(strstr(cleft_context_last_error(f->context), "line 1: the name has a control character"));
    assert_string_equal(cleft_mesh_label_name(mesh, 3), "");
    assert_int_equal(cleft_io_read_mesh_names(f->context, "/none.txt", mesh), CLEFT_ERROR_FILE);
    assert_int_equal(cleft_io_read_mesh_names(f->context, NULL, mesh), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_io_read_mesh_names(f->context, "/none.txt", NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_io_read_volume_names(f->context, "/none.txt", NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_io_read_mesh_names(NULL, "/none.txt", mesh), CLEFT_ERROR_NULL);
    cleft_mesh_destroy(mesh);
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        CASE(a_volume_gets_the_names_of_a_table),
        CASE(a_mesh_gets_the_names_of_a_table),
        CASE(what_is_uncertain_is_told),
        CASE(columns_have_headings),
        CASE(mistakes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
