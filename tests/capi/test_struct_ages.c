/* Programs that were built before a struct grew, and programs built after it will have grown: today's library serves
 * both. What the structs were is in abi/first_structs.h. */
#include "abi/first_structs.h"
#include "support/capi.h"

#include <string.h>

enum { N = 20, MOST = 1024, LATER = 24 };

#define AT_THE_SAME_PLACE(name, field) assert_int_equal(offsetof(first_##name, field), offsetof(cleft_##name, field))

/* Something that fills a struct, or refuses it. */
typedef cleft_status (*filler)(void* world, void* out);

typedef struct {
    cleft_context* context;
    cleft_volume* volume;
    cleft_mesh* mesh;
    cleft_report* report;
    int64_t row;
} world;

/* A leaning sheet thinner than the tetrahedra around it: it breaks. */
static void make_world(world* w)
{
    static uint8_t voxels[N * N * N];
    const int64_t dims[3] = {N, N, N};
    cleft_options* options = NULL;
    memset(w, 0, sizeof *w);
    for (int v = 0; v < N * N * N; ++v) {
        const int x = v % N, y = v / N % N, z = v / N / N;
        voxels[v] = 3 * z - x - y >= 20 && 3 * z - x - y < 23;
    }
    w->context = new_context();
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, 5), CLEFT_OK);
    assert_int_equal(cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_LATTICE), CLEFT_OK);
    assert_ok(w->context,
              cleft_volume_create_labels(w->context, CLEFT_TYPE_UINT8, voxels, dims, NULL, options, &w->volume));
    assert_ok(w->context, cleft_mesh_volume(w->context, w->volume, NULL, NULL, options, &w->mesh));
    assert_ok(w->context, cleft_report_create(w->context, w->volume, w->mesh, &w->report));
    cleft_options_destroy(options);
}

static void destroy_world(world* w)
{
    cleft_report_destroy(w->report);
    cleft_mesh_destroy(w->mesh);
    cleft_volume_destroy(w->volume);
    cleft_context_destroy(w->context);
}

static cleft_status option(void* w, void* out)
{
    return cleft_option_info((int32_t)((world*)w)->row, (cleft_option_description*)out);
}

static cleft_status quality(void* w, void* out)
{
    return cleft_mesh_quality(((world*)w)->context, ((world*)w)->mesh, (cleft_quality*)out);
}

static cleft_status validation(void* w, void* out)
{
    return cleft_mesh_validate(((world*)w)->context, ((world*)w)->mesh, 1, (cleft_validation*)out);
}

static cleft_status label(void* w, void* out)
{
    return cleft_report_label(((world*)w)->report, ((world*)w)->row, (cleft_label_report*)out);
}

/* Two labels with a face of tetrahedra between them, of which no voxels touch. */
static cleft_status contact(void* unused, void* out)
{
    static const double points[] = {0, 0, 0, 8, 0, 0, 0, 8, 0, 0, 0, 8, 8, 8, 8};
    static const int32_t tets[] = {0, 1, 2, 3, 1, 2, 3, 4}, labels[] = {0, 2};
    const uint8_t voxels[] = {0, 1, 2};
    const int64_t dims[3] = {3, 1, 1};
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    cleft_report* report = NULL;
    (void)unused;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, NULL, &volume));
    assert_ok(context, cleft_mesh_create(context, 5, points, 2, tets, labels, 0, &mesh));
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    const cleft_status status = cleft_report_contact(report, 0, (cleft_contact*)out);
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
    return status;
}

/* What lies between the fields of a description is nobody's. */
static void clear_padding(unsigned char* bytes)
{
    const size_t end = offsetof(cleft_option_description, type) + sizeof(int32_t);
    memset(bytes + end, 0, offsetof(cleft_option_description, name) - end);
}

/* `bytes` of today's struct as a caller with a struct of `size` bytes gets them: no byte beyond is touched. */
static void fill(world* w, filler from, uint32_t size, unsigned char* bytes)
{
    uint32_t reported;
    memset(bytes, 0x55, MOST);
    memcpy(bytes, &size, sizeof size);
    assert_int_equal(from(w, bytes), CLEFT_OK);
    memcpy(&reported, bytes, sizeof reported);
    assert_int_equal(reported, size);
    for (size_t i = size; i < MOST; ++i)
        assert_int_equal(bytes[i], 0x55);
    if (from == option)
        clear_padding(bytes);
}

static void serves_all(world* w, filler from, uint32_t first_size, uint32_t size)
{
    union {
        unsigned char bytes[MOST];
        double aligned;
    } now, older, newer;
    fill(w, from, size, now.bytes);
    fill(w, from, first_size, older.bytes);
    assert_memory_equal(older.bytes + 4, now.bytes + 4, first_size - 4);
    memset(newer.bytes, 0x55, MOST);
    const uint32_t later = size + LATER;
    memcpy(newer.bytes, &later, sizeof later);
    assert_int_equal(from(w, newer.bytes), CLEFT_OK);
    if (from == option)
        clear_padding(newer.bytes);
    assert_memory_equal(newer.bytes + 4, now.bytes + 4, MOST - 4);
    const uint32_t less = first_size - 1;
    memcpy(newer.bytes, &less, sizeof less);
    assert_int_equal(from(w, newer.bytes), CLEFT_ERROR_ARGUMENT);
}

static void each_age_gets_what_it_knows(void** state)
{
    world w;
    (void)state;
    make_world(&w);
    for (w.row = 0; w.row < cleft_option_count(); ++w.row)
        serves_all(&w, option, sizeof(first_option_description), sizeof(cleft_option_description));
    serves_all(&w, quality, sizeof(first_quality), sizeof(cleft_quality));
    serves_all(&w, validation, sizeof(first_validation), sizeof(cleft_validation));
    for (w.row = 0; w.row < cleft_report_count(w.report); ++w.row)
        serves_all(&w, label, sizeof(first_label_report), sizeof(cleft_label_report));
    serves_all(&w, contact, sizeof(first_contact), sizeof(cleft_contact));
    destroy_world(&w);
}

/* By the names of then. */
static void an_early_program_reads_what_is_true(void** state)
{
    first_option_description o = {.struct_size = sizeof o};
    first_quality q = {.struct_size = sizeof q};
    first_validation v = {.struct_size = sizeof v};
    first_label_report r = {.struct_size = sizeof r};
    first_contact c = {.struct_size = sizeof c};
    cleft_label_report now = {.struct_size = sizeof now};
    int64_t in_bins = 0;
    world w;
    (void)state;
    make_world(&w);
    w.row = 0;
    assert_int_equal(option(&w, &o), CLEFT_OK);
    assert_int_equal(o.key, CLEFT_OPTION_BACKGROUND);
    assert_int_equal(o.type, CLEFT_OPTION_TYPE_CHOICE);
    assert_string_equal(o.name, "background");
    assert_true(o.value == 0 && o.least == 0 && o.greatest >= 2);
    assert_memory_equal(o.choices, "particles|lattice|octree", strlen("particles|lattice|octree"));
    assert_true(strlen(o.text) > 0);
    assert_int_equal(quality(&w, &q), CLEFT_OK);
    assert_int_equal(q.tet_count, cleft_mesh_tet_count(w.mesh));
    assert_true(q.min_dihedral > 0 && q.max_dihedral < 180 && q.min_edge <= q.mean_edge && q.mean_edge <= q.max_edge);
    assert_true(q.total_volume > N * N * N - 1e-3 && q.total_volume < N * N * N + 1e-3);
    for (int bin = 0; bin < 36; ++bin)
        in_bins += q.dihedral_histogram[bin];
    assert_int_equal(in_bins, 6 * q.tet_count);
    assert_int_equal(validation(&w, &v), CLEFT_OK);
    assert_int_equal(v.valid, 1);
    assert_true(v.box_volume == N * N * N && v.box_area == 6 * N * N);
    w.row = 1;
    assert_int_equal(label(&w, &r), CLEFT_OK);
    assert_int_equal(label(&w, &now), CLEFT_OK);
    assert_int_equal(r.label, 1);
    assert_int_equal(r.lost, 0);
    assert_true(r.large_components_broken > 0);
    assert_int_equal(r.large_components_broken, now.large_components_broken);
    assert_int_equal(contact(&w, &c), CLEFT_OK);
    assert_int_equal(c.first, 0);
    assert_int_equal(c.second, 2);
    assert_int_equal(c.triangles, 1);
    destroy_world(&w);
}

static void fields_stay_where_they_were(void** state)
{
    (void)state;
    AT_THE_SAME_PLACE(option_description, type);
    AT_THE_SAME_PLACE(option_description, choices);
    AT_THE_SAME_PLACE(option_description, text);
    AT_THE_SAME_PLACE(quality, tet_count);
    AT_THE_SAME_PLACE(quality, tets_above_165);
    AT_THE_SAME_PLACE(quality, total_volume);
    AT_THE_SAME_PLACE(quality, dihedral_histogram);
    AT_THE_SAME_PLACE(validation, valid);
    AT_THE_SAME_PLACE(validation, repeated_points);
    AT_THE_SAME_PLACE(validation, box_area);
    AT_THE_SAME_PLACE(label_report, label);
    AT_THE_SAME_PLACE(label_report, mesh_volume);
    AT_THE_SAME_PLACE(label_report, large_components_lost);
    AT_THE_SAME_PLACE(label_report, lost);
    assert_int_equal(offsetof(first_label_report, large_components_broken), offsetof(cleft_label_report, reserved));
    AT_THE_SAME_PLACE(contact, second);
    AT_THE_SAME_PLACE(contact, triangles);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_age_gets_what_it_knows),
        cmocka_unit_test(an_early_program_reads_what_is_true),
        cmocka_unit_test(fields_stay_where_they_were),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
