/* Pages that show meshes: one file that needs nothing else, the same bytes each time, and no name that gets out. */
#include "io/folder_fixture.h"
#include "io/sample_mesh.h"

static const char* const hostile = "</script><script>alert(1)</script><!--\"'&\\";

static cleft_mesh* sample(fixture* f)
{
    cleft_mesh* mesh = sample_mesh_create(f->context);
    assert_non_null(mesh);
    return mesh;
}

/* The caller frees it. */
static char* text_of(const char* path)
{
    FILE* file = fopen(path, "rb");
    if (!file)
        return NULL;
    fseek(file, 0, SEEK_END);
    const size_t size = (size_t)ftell(file);
    rewind(file);
    char* text = calloc(size + 1, 1);
    assert_int_equal(fread(text, 1, size, file), size);
    fclose(file);
    return text;
}

static char* page_of(fixture* f, const cleft_mesh* mesh, const cleft_io_view* view)
{
    const cleft_status status = cleft_io_write_view(f->context, mesh, view, path_of(f, "page.html"));
    assert_string_equal(cleft_context_last_error(f->context), "");
    assert_int_equal(status, CLEFT_OK);
    char* text = text_of(path_of(f, "page.html"));
    assert_non_null(text);
    return text;
}

static int count_of(const char* text, const char* part)
{
    int count = 0;
    for (const char* at = text; (at = strstr(at, part)); ++at)
        ++count;
    return count;
}

static void a_page_needs_nothing_else(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    char* page = page_of(f, mesh, NULL);
    /* The name of a language, which no browser fetches, is the one address. */
    assert_int_equal(count_of(page, "://"), count_of(page, "http://www.w3.org/2000/svg"));
    assert_null(strstr(page, " src="));
    assert_null(strstr(page, "@import"));
    assert_null(strstr(page, "eval("));
    assert_null(strstr(page, "innerHTML"));
    assert_non_null(strstr(page, "default-src 'none'; script-src 'sha256-"));
    assert_null(strstr(page, "unsafe-inline"));
    assert_non_null(strstr(page, "\"tets\":216,"));
    assert_non_null(strstr(page, "\"label\":-7,"));
    assert_non_null(strstr(page, "\"reduction\":\"\""));
    free(page);
    cleft_mesh_destroy(mesh);
}

static void threads_and_repetitions_change_no_byte(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    char* pages[2];
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(cleft_context_set_threads(f->context, 1 + 3 * i), CLEFT_OK);
        pages[i] = page_of(f, mesh, NULL);
    }
    assert_string_equal(pages[0], pages[1]);
    free(pages[0]);
    free(pages[1]);
    cleft_mesh_destroy(mesh);
}

static void texts_stay_texts(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    assert_int_equal(cleft_mesh_set_label_name(mesh, 3, hostile), CLEFT_OK);
    char* plain = page_of(f, mesh, NULL);
    const int elements = count_of(plain, "<script");
    const cleft_io_view view = {.struct_size = sizeof view, .title = hostile, .report = "{\"a\":\"</script><b>\"}"};
    char* page = page_of(f, mesh, &view);
    assert_int_equal(count_of(page, "<script"), elements);
    assert_int_equal(count_of(page, "</script"), elements);
    assert_null(strstr(page, "alert(1)</"));
    assert_non_null(strstr(page, "{\"a\":\"\\u003c/script>\\u003cb>\"}"));
    assert_non_null(strstr(page, "<title>&#60;/script&#62;&#60;script&#62;alert(1)"));
    free(plain);
    free(page);
    cleft_mesh_destroy(mesh);
}

static void texts_that_are_not_utf8_are_replaced(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    const cleft_io_view view = {.struct_size = sizeof view, .title = "a\xFFz"};
    char* page = page_of(f, mesh, &view);
    assert_non_null(strstr(page, "<title>a\xEF\xBF\xBDz</title>"));
    assert_non_null(strstr(page, "\"title\":\"a\xEF\xBF\xBDz\""));
    free(page);
    cleft_mesh_destroy(mesh);
}

static void keep_sentence(int32_t level, const char* sentence, void* user)
{
    assert_int_equal(level, CLEFT_LOG_WARNING);
    strcat(user, sentence);
    strcat(user, ";");
}

static void large_meshes_are_shown_in_part_and_say_so(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    const cleft_io_view view = {.struct_size = sizeof view, .max_tets = 10};
    char sentences[500] = "";
    assert_int_equal(cleft_context_set_log(f->context, keep_sentence, sentences), CLEFT_OK);
    char* page = page_of(f, mesh, &view);
    assert_string_equal(sentences,
                        "'Mesh' has 216 tetrahedra, and the page shows 10 of them, those around the middle;");
    assert_non_null(strstr(page, "\"tets\":216,"));
    assert_non_null(strstr(page, "\"shown_tets\":10,\"reduction\":\"middle\""));
    free(page);
    cleft_mesh_destroy(mesh);
}

static void two_meshes_are_on_one_page(void** state)
{
    fixture* f = *state;
    cleft_mesh* meshes[] = {sample(f), sample(f)};
    const cleft_io_view view = {
        .struct_size = sizeof view, .title = "ours", .other = meshes[1], .other_title = "theirs", .goal = 20};
    char* page = page_of(f, meshes[0], &view);
    assert_non_null(strstr(page, "<title>ours | theirs</title>"));
    assert_non_null(strstr(page, "id=\"points-1\""));
    assert_non_null(strstr(page, "\"goal\":20,"));
    free(page);
    cleft_mesh_destroy(meshes[0]);
    cleft_mesh_destroy(meshes[1]);
}

/* One camera looks at both, so it is told where they hardly meet. */
static void meshes_in_different_places_are_told(void** state)
{
    static const struct {
        double factor, step;
        const char* said;
    } rows[] = {
        {1, 0, NULL},
        {0.5, 0, NULL},
        {1, 1, NULL},
        {1, 5,
         "'ours' and 'theirs' lie in different places or have different sizes, so one camera hardly shows both: "
         "along y, one reaches from 1e-07 to "},
        {1000, 0, "along z, one reaches from "},
    };
    fixture* f = *state;
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        sample_mesh moved;
        sample_mesh_fill(&moved);
        for (int p = 0; p < SAMPLE_POINTS; ++p)
            for (int axis = 0; axis < 3; ++axis)
                moved.points[3 * p + axis] =
                    rows[i].factor * moved.points[3 * p + axis] + (axis == 1 ? rows[i].step / 7 : 0);
        if (rows[i].factor == 0.5)
            for (int p = 0; p < SAMPLE_POINTS; ++p)
                moved.points[3 * p + 2] += 12346 * 0.5;
        cleft_mesh* meshes[] = {sample(f), NULL};
        assert_int_equal(cleft_mesh_create(f->context, SAMPLE_POINTS, moved.points, SAMPLE_TETS, moved.tets,
                                           moved.labels, 0, &meshes[1]),
                         CLEFT_OK);
        char sentences[1000] = "";
        assert_int_equal(cleft_context_set_log(f->context, keep_sentence, sentences), CLEFT_OK);
        const cleft_io_view view = {
            .struct_size = sizeof view, .title = "ours", .other = meshes[1], .other_title = "theirs"};
        char* page = page_of(f, meshes[0], &view);
        if (rows[i].said)
            assert_non_null(strstr(sentences, rows[i].said));
        else
            assert_string_equal(sentences, "");
        assert_non_null(strstr(page, rows[i].said ? rows[i].said : "\"places\":\"\""));
        free(page);
        cleft_mesh_destroy(meshes[0]);
        cleft_mesh_destroy(meshes[1]);
    }
}

static void names_come_from_tables_of_several_programs(void** state)
{
    static const char* const tables[] = {
        "3 right lung\n-7 \"left lung\"\n",
        "\xEF\xBB\xBF# a comment\r\n\r\n  3,right lung\r\n-7\tleft lung\r\n99 none\r\n",
        "3=right lung\n-7 = left lung",
        "# ITK-SnAP Label Description File\n"
        "    3   255    0    0        1  1  1    \"right lung\"\n"
        "   -7     0  255    0      0.5  1  1    \"left lung\"\n",
    };
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    for (size_t i = 0; i < sizeof tables / sizeof *tables; ++i) {
        const cleft_io_view view = {.struct_size = sizeof view, .names = written_names(f, tables[i])};
        char* page = page_of(f, mesh, &view);
        assert_non_null(strstr(page, "{\"label\":3,\"name\":\"right lung\","));
        assert_non_null(strstr(page, "{\"label\":-7,\"name\":\"left lung\","));
        free(page);
    }
    cleft_mesh_destroy(mesh);
}

static void numbers_behind_a_word_are_no_part_of_its_name(void** state)
{
    static const struct {
        const char* table;
        const char* name;
    } rows[] = {
        {"0 Unknown 0 0 0 0\n3   Right-Lung   10  20 30   0\n", "\"Right-Lung\""}, /* FreeSurfer */
        {"3 Lung_R 2001\n-7 Lung_L 2002\n", "\"Lung_R\""},                         /* MRIcron */
        {"3 Area 17\n-7 Area 18\n", "\"Area 17\""},                                /* not a table */
        {"3 Area 17\n", "\"Area 17\""},
    };
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        char wanted[64];
        snprintf(wanted, sizeof wanted, "{\"label\":3,\"name\":%s,", rows[i].name);
        const cleft_io_view view = {.struct_size = sizeof view, .names = written_names(f, rows[i].table)};
        char* page = page_of(f, mesh, &view);
        assert_non_null(strstr(page, wanted));
        free(page);
    }
    cleft_mesh_destroy(mesh);
}

static void tables_that_are_none_are_refused(void** state)
{
    static const struct {
        const char* table;
        const char* said;
    } rows[] = {
        {"1 a\nlung 2\n", "line 2: it begins with no label"},
        {"3x lung\n", "line 1: it begins with no label"},
        {"99999999999 a\n", "line 1: it begins with no label"},
        {"3 a\xFF\n", "line 1: the name is not UTF-8"},
        {"", "there are no labels in it"},
    };
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        const cleft_io_view view = {.struct_size = sizeof view, .names = written_names(f, rows[i].table)};
        assert_int_equal(cleft_io_write_view(f->context, mesh, &view, path_of(f, "page.html")), CLEFT_ERROR_FORMAT);
        assert_non_null(strstr(cleft_context_last_error(f->context), rows[i].said));
        assert_non_null(strstr(cleft_context_last_error(f->context), "names.txt'"));
        assert_null(text_of(path_of(f, "page.html")));
    }
    const cleft_io_view view = {.struct_size = sizeof view, .names = "/none.txt"};
    assert_int_equal(cleft_io_write_view(f->context, mesh, &view, path_of(f, "page.html")), CLEFT_ERROR_FILE);
    cleft_mesh_destroy(mesh);
}

static void mistakes_are_refused(void** state)
{
    fixture* f = *state;
    cleft_mesh* mesh = sample(f);
    const cleft_io_view mistakes[] = {{.struct_size = 8},
                                      {.struct_size = sizeof *mistakes, .reserved = 1},
                                      {.struct_size = sizeof *mistakes, .max_tets = -1},
                                      {.struct_size = sizeof *mistakes, .goal = 91},
                                      {.struct_size = sizeof *mistakes, .goal = -1}};
    char path[128];
    strcpy(path, path_of(f, "page.html"));
    for (size_t i = 0; i < sizeof mistakes / sizeof *mistakes; ++i) {
        assert_int_equal(cleft_io_write_view(f->context, mesh, &mistakes[i], path), CLEFT_ERROR_ARGUMENT);
        assert_true(strlen(cleft_context_last_error(f->context)) > 10);
    }
    assert_int_equal(cleft_io_write_view(f->context, NULL, NULL, path), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_io_write_view(f->context, mesh, NULL, NULL), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_io_write_view(NULL, mesh, NULL, path), CLEFT_ERROR_NULL);
    assert_null(text_of(path));
    assert_int_equal(cleft_io_write_view(f->context, mesh, NULL, path_of(f, "none/page.html")), CLEFT_ERROR_FILE);
    cleft_mesh_destroy(mesh);
}

static void meshes_of_impossible_sizes_are_refused(void** state)
{
    static const int32_t corners[] = {0, 1, 2, 3};
    static const double sizes[] = {1e-320, 1e-100, 9e-31, 1e-30, 1, 1e30, 1.1e30, 1e300, 1.7e308};
    fixture* f = *state;
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; ++i) {
        const double s = sizes[i];
        const double points[] = {-s, 0, 0, i == 8 ? s : 0, 0, 0, -s, s, 0, -s, 0, s};
        cleft_mesh* mesh = NULL;
        assert_int_equal(cleft_mesh_create(f->context, 4, points, 1, corners, NULL, 0, &mesh), CLEFT_OK);
        const cleft_status status = cleft_io_write_view(f->context, mesh, NULL, path_of(f, "page.html"));
        assert_int_equal(status, s >= 1e-30 && s <= 1e30 ? CLEFT_OK : CLEFT_ERROR_ARGUMENT);
        if (status)
            assert_non_null(strstr(cleft_context_last_error(f->context), "the longest side of the box"));
        cleft_mesh_destroy(mesh);
    }
}

int main(void)
{
#define CASE(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        CASE(a_page_needs_nothing_else),
        CASE(threads_and_repetitions_change_no_byte),
        CASE(texts_stay_texts),
        CASE(texts_that_are_not_utf8_are_replaced),
        CASE(large_meshes_are_shown_in_part_and_say_so),
        CASE(two_meshes_are_on_one_page),
        CASE(meshes_in_different_places_are_told),
        CASE(names_come_from_tables_of_several_programs),
        CASE(numbers_behind_a_word_are_no_part_of_its_name),
        CASE(tables_that_are_none_are_refused),
        CASE(mistakes_are_refused),
        CASE(meshes_of_impossible_sizes_are_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
