/* Reports on a mesh in parts: all ranks hear of the whole mesh what one process would, whatever their number. */
#include "broken_exchange.h"
#include "ranks.h"
#include "support/capi.h"

#include <math.h>
#include <stdio.h>

enum { MOST_LABELS = 16 };

typedef struct {
    const int32_t* voxels;
    int64_t dims[3];
} memory;

static int read_memory(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                       void* user)
{
    const memory* from = (const memory*)user;
    int32_t* out = (int32_t*)voxels;
    (void)sentence, (void)room;
    for (int64_t k = first[2]; k < first[2] + count[2]; ++k)
        for (int64_t j = first[1]; j < first[1] + count[1]; ++j)
            for (int64_t i = first[0]; i < first[0] + count[0]; ++i)
                *out++ = from->voxels[i + from->dims[0] * (j + from->dims[1] * k)];
    return 0;
}

static const double kSheared[12] = {-1, 0.1, 0, 20, 0, 1.5, 0, -3, 0, 0.2, 0.7, 8};

/* What a rank does and gets. */
typedef struct {
    memory voxels;
    const cleft_options* options;
    int32_t ghosts;
    cleft_part* part;
    uint32_t size; /* struct_size of the quality */
    cleft_status status;
    char sentence[1000];
    cleft_quality quality;
} job;

static void make_part(const cleft_exchange* exchange, void* user)
{
    job* mine = (job*)user;
    cleft_voxels voxels = {sizeof(cleft_voxels), CLEFT_TYPE_INT32, {0, 0, 0}, {0}, NULL, read_memory};
    cleft_context* context = NULL;
    memcpy(voxels.dims, mine->voxels.dims, sizeof voxels.dims);
    memcpy(voxels.affine, kSheared, sizeof voxels.affine);
    voxels.user = &mine->voxels;
    if (cleft_context_create(&context) != CLEFT_OK)
        return;
    mine->status = cleft_part_create(context, &voxels, mine->options, exchange, mine->ghosts, &mine->part);
    snprintf(mine->sentence, sizeof mine->sentence, "%s", cleft_context_last_error(context));
    cleft_context_destroy(context);
}

static void measure(const cleft_exchange* exchange, void* user)
{
    job* mine = (job*)user;
    cleft_context* context = NULL;
    if (cleft_context_create(&context) != CLEFT_OK)
        return;
    memset(&mine->quality, 0x55, sizeof mine->quality);
    mine->quality.struct_size = mine->size;
    mine->status = cleft_part_quality(context, mine->part, exchange, &mine->quality);
    snprintf(mine->sentence, sizeof mine->sentence, "%s", cleft_context_last_error(context));
    cleft_context_destroy(context);
}

static void make_parts(job* jobs, int32_t ranks, const int32_t* voxels, const int64_t dims[3],
                       const cleft_options* options, int32_t ghosts)
{
    memset(jobs, 0, sizeof(job) * (size_t)ranks);
    for (int32_t r = 0; r < ranks; ++r) {
        jobs[r].voxels.voxels = voxels;
        memcpy(jobs[r].voxels.dims, dims, sizeof jobs[r].voxels.dims);
        jobs[r].options = options;
        jobs[r].ghosts = ghosts;
        jobs[r].size = sizeof(cleft_quality);
    }
    ranks_run(ranks, make_part, jobs, sizeof *jobs);
    for (int32_t r = 0; r < ranks; ++r)
        if (jobs[r].status != CLEFT_OK)
            fail_msg("rank %d of %d: %s", (int)r, (int)ranks, jobs[r].sentence);
}

static void destroy_parts(job* jobs, int32_t ranks)
{
    for (int32_t r = 0; r < ranks; ++r)
        cleft_part_destroy(jobs[r].part);
}

static int is_near(double a, double b) { return fabs(a - b) <= 1e-12 * fabs(b); }

/* Each part is measured by itself. All together are the whole. */
static void assert_own_are_shares(const job* jobs, int32_t ranks, const cleft_quality* whole)
{
    int64_t tets = 0;
    double least = 180;
    cleft_context* context = new_context();
    for (int32_t r = 0; r < ranks; ++r) {
        cleft_quality own;
        own.struct_size = sizeof own;
        assert_ok(context, cleft_part_own_quality(context, jobs[r].part, &own));
        assert_true(own.radius_ratio_95 <= whole->radius_ratio_max);
        tets += own.tet_count;
        if (own.tet_count > 0 && own.min_dihedral < least)
            least = own.min_dihedral;
    }
    assert_int_equal(tets, whole->tet_count);
    assert_true(least == whole->min_dihedral);
    cleft_context_destroy(context);
}

/* Equal but for the last digits of the sums. */
static void assert_same_quality(cleft_quality found, const cleft_quality* expected)
{
    assert_true(is_near(found.mean_edge, expected->mean_edge));
    assert_true(is_near(found.total_volume, expected->total_volume));
    found.mean_edge = expected->mean_edge;
    found.total_volume = expected->total_volume;
    assert_memory_equal(&found, expected, sizeof found);
}

/* What one process finds. */
typedef struct {
    cleft_quality quality;
    int64_t labels;
    cleft_label_report label[MOST_LABELS];
} findings;

/* The report needs all labels, so they are taken out after it. */
static findings look_at_whole(const int32_t* voxels, const int64_t dims[3], const cleft_options* options,
                              const int32_t* strip)
{
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    cleft_report* report = NULL;
    findings out;
    memset(&out, 0, sizeof out);
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, voxels, dims, kSheared, options, &volume));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh));
    assert_ok(context, cleft_report_create(context, volume, mesh, &report));
    out.labels = cleft_report_count(report);
    assert_true(out.labels <= MOST_LABELS);
    for (int64_t i = 0; i < out.labels; ++i) {
        cleft_label_report* row = &out.label[i];
        row->struct_size = sizeof *row;
        assert_int_equal(cleft_report_label(report, i, row), CLEFT_OK);
        row->voxel_components = row->mesh_components = row->large_components = row->large_components_lost = -1;
        row->reserved = -1;
        row->large_components_broken = row->large_components_joined = -1;
        if (strip && row->label == *strip) {
            row->tets = row->lost = 0;
            row->mesh_volume = 0;
        }
    }
    if (strip) {
        cleft_options* stripped = NULL;
        cleft_mesh* kept = NULL;
        assert_int_equal(cleft_options_create(&stripped), CLEFT_OK);
        assert_int_equal(cleft_options_set_strip(stripped, strip, 1), CLEFT_OK);
        assert_ok(context, cleft_mesh_strip(context, mesh, stripped, &kept));
        cleft_options_destroy(stripped);
        cleft_mesh_destroy(mesh);
        mesh = kept;
    }
    out.quality.struct_size = sizeof out.quality;
    assert_ok(context, cleft_mesh_quality(context, mesh, &out.quality));
    cleft_report_destroy(report);
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
    return out;
}

static void assert_same_labels(const cleft_part* part, const findings* expected)
{
    assert_int_equal(cleft_part_label_count(part), expected->labels);
    for (int64_t i = 0; i < expected->labels; ++i) {
        cleft_label_report row;
        memset(&row, 0, sizeof row);
        row.struct_size = sizeof row;
        assert_int_equal(cleft_part_label(part, i, &row), CLEFT_OK);
        assert_true(is_near(row.mesh_volume, expected->label[i].mesh_volume));
        row.mesh_volume = expected->label[i].mesh_volume;
        assert_memory_equal(&row, &expected->label[i], sizeof row);
    }
}

static cleft_options* options_of(const char* background, const char* block, const char* size)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", background), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "block", block), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "size", size), CLEFT_OK);
    return options;
}

/* Returns what one process finds, and compares it with what ranks find. `strip` may be NULL. */
static findings compare(const int32_t* voxels, const int64_t dims[3], const char* background, const char* block,
                        const char* size, const int32_t* strip)
{
    static const int32_t kRanks[] = {1, 2, 3, 7};
    cleft_options* options = options_of(background, block, size);
    const findings expected = look_at_whole(voxels, dims, options, strip);
    if (strip)
        assert_int_equal(cleft_options_set_strip(options, strip, 1), CLEFT_OK);
    for (size_t i = 0; i < sizeof kRanks / sizeof *kRanks; ++i) {
        job jobs[MOST_RANKS];
        make_parts(jobs, kRanks[i], voxels, dims, options, (int32_t)(i % 2));
        ranks_run(kRanks[i], measure, jobs, sizeof *jobs);
        for (int32_t r = 0; r < kRanks[i]; ++r) {
            if (jobs[r].status != CLEFT_OK)
                fail_msg("rank %d of %d: %s", (int)r, (int)kRanks[i], jobs[r].sentence);
            assert_same_quality(jobs[r].quality, &expected.quality);
            assert_memory_equal(&jobs[r].quality, &jobs[0].quality, sizeof jobs[r].quality);
            assert_same_labels(jobs[r].part, &expected);
        }
        assert_own_are_shares(jobs, kRanks[i], &expected.quality);
        destroy_parts(jobs, kRanks[i]);
    }
    cleft_options_destroy(options);
    return expected;
}

/* Balls of some labels, negative ones too, in an order that is not theirs. */
static int32_t* some_labels(const int64_t dims[3])
{
    int32_t* voxels = (int32_t*)malloc(sizeof(int32_t) * (size_t)(dims[0] * dims[1] * dims[2]));
    int64_t v = 0;
    assert_non_null(voxels);
    for (int64_t k = 0; k < dims[2]; ++k)
        for (int64_t j = 0; j < dims[1]; ++j)
            for (int64_t i = 0; i < dims[0]; ++i) {
                const int64_t x = i - 5, y = j - 4, z = k % 12 - 6;
                voxels[v++] = x * x + y * y + z * z < 14 ? (int32_t)(7 - 9 * (k / 12)) : j < 3 ? 90000 : 1;
            }
    return voxels;
}

static void ranks_hear_of_the_whole(void** state)
{
    static const int64_t kDims[3] = {11, 9, 36};
    static const int32_t kLeftOut = 1;
    int32_t* voxels = some_labels(kDims);
    (void)state;
    const findings all = compare(voxels, kDims, "octree", "12", "0", NULL);
    assert_int_equal(all.labels, 5);
    assert_int_equal(all.label[0].label, -11);
    assert_true(all.quality.radius_ratio_median < all.quality.radius_ratio_95);
    compare(voxels, kDims, "octree", "9", "0", &kLeftOut);
    compare(voxels, kDims, "lattice", "12", "2", NULL);
    /* The first rank makes the whole mesh. */
    compare(voxels, kDims, "octree", "0", "0", NULL);
    compare(voxels, kDims, "particles", "0", "2", &kLeftOut);
    free(voxels);
}

static void some_ranks_have_nothing(void** state)
{
    static const int64_t kDims[3] = {1, 1, 1};
    static const int32_t kVoxel = -3;
    (void)state;
    assert_int_equal(compare(&kVoxel, kDims, "lattice", "0", "0", NULL).labels, 1);
}

/* Single voxels in a coarse mesh. */
static void labels_can_be_lost(void** state)
{
    static const int64_t kDims[3] = {8, 8, 24};
    int32_t voxels[8 * 8 * 24];
    int64_t lost = 0;
    (void)state;
    for (int v = 0; v < 8 * 8 * 24; ++v)
        voxels[v] = 0;
    for (int32_t label = 1; label < 6; ++label)
        voxels[3 + 8 * 3 + 64 * (4 * label - 1)] = label;
    const findings all = compare(voxels, kDims, "lattice", "8", "9", NULL);
    for (int64_t i = 0; i < all.labels; ++i)
        lost += all.label[i].lost;
    assert_true(lost > 0);
    const int32_t kLost = 2;
    compare(voxels, kDims, "lattice", "8", "9", &kLost);
}

static void assert_all(const job* jobs, int32_t ranks, cleft_status status, const char* sentence)
{
    for (int32_t r = 0; r < ranks; ++r) {
        const uint32_t untouched = 0x55555555;
        assert_int_equal(jobs[r].status, status);
        assert_string_equal(jobs[r].sentence, sentence);
        assert_memory_equal(&jobs[r].quality.reserved, &untouched, sizeof untouched);
    }
}

static void what_one_gives_wrong_all_hear(void** state)
{
    static const int64_t kDims[3] = {6, 6, 6}, kOther[3] = {6, 6, 5};
    int32_t* voxels = some_labels(kDims);
    cleft_options* options = options_of("octree", "0", "0");
    char sentence[200];
    job jobs[3], others[3], alone;
    (void)state;
    make_parts(jobs, 3, voxels, kDims, options, 0);
    make_parts(others, 3, voxels, kOther, options, 0);
    jobs[2].size = 8;
    ranks_run(3, measure, jobs, sizeof *jobs);
    snprintf(sentence, sizeof sentence,
             "rank 2: struct_size of the cleft_quality is 8; set it to sizeof(cleft_quality), which is %d",
             (int)sizeof(cleft_quality));
    assert_all(jobs, 3, CLEFT_ERROR_ARGUMENT, sentence);
    jobs[2].size = sizeof(cleft_quality);

    /* The parts of other ranks, of another number of ranks, of another mesh, and none. */
    cleft_part* own = jobs[1].part;
    jobs[1].part = jobs[2].part;
    ranks_run(3, measure, jobs, sizeof *jobs);
    assert_all(jobs, 3, CLEFT_ERROR_ARGUMENT, "rank 1: the part is that of rank 2 of 3, and is given by rank 1 of 3");
    jobs[1].part = others[1].part;
    ranks_run(3, measure, jobs, sizeof *jobs);
    assert_all(jobs, 3, CLEFT_ERROR_ARGUMENT, "the parts are not those of one mesh");
    jobs[1].part = NULL;
    ranks_run(3, measure, jobs, sizeof *jobs);
    assert_all(jobs, 3, CLEFT_ERROR_NULL, "rank 1: part is NULL");
    jobs[1].part = own;
    alone = jobs[0];
    ranks_run(1, measure, &alone, sizeof alone);
    assert_all(&alone, 1, CLEFT_ERROR_ARGUMENT, "the part is that of rank 0 of 3, and is given by rank 0 of 1");
    destroy_parts(jobs, 3);
    destroy_parts(others, 3);
    cleft_options_destroy(options);
    free(voxels);
}

static void arguments_are_looked_at(void** state)
{
    static const int64_t kDims[3] = {2, 2, 2};
    static const int32_t kVoxels[8] = {4, 4, 4, 4, 1, 1, 1, 1};
    const cleft_exchange broken = {sizeof broken, 0, 1, NULL, send_nothing, send_no_bytes, NULL};
    const cleft_exchange outside = {sizeof outside, 1, 1, NULL, send_nothing, send_no_bytes, NULL};
    cleft_label_report row;
    job one;
    (void)state;
    make_parts(&one, 1, kVoxels, kDims, NULL, 0);
    measure(&broken, &one);
    assert_int_equal(one.status, CLEFT_ERROR_EXCHANGE);
    measure(&outside, &one);
    assert_int_equal(one.status, CLEFT_ERROR_ARGUMENT);
    measure(NULL, &one);
    assert_int_equal(one.status, CLEFT_ERROR_NULL);
    memset(&row, 0, sizeof row);
    assert_int_equal(cleft_part_label(one.part, 0, &row), CLEFT_ERROR_ARGUMENT);
    row.struct_size = sizeof row;
    assert_int_equal(cleft_part_label(one.part, -1, &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_part_label(one.part, 2, &row), CLEFT_ERROR_ARGUMENT);
    assert_int_equal(cleft_part_label(NULL, 0, &row), CLEFT_ERROR_NULL);
    assert_int_equal(cleft_part_label(one.part, 0, NULL), CLEFT_ERROR_NULL);
    assert_int_equal(row.label, 0);
    assert_int_equal(cleft_part_label(one.part, 1, &row), CLEFT_OK);
    assert_int_equal(row.label, 4);
    assert_int_equal(cleft_part_label_count(NULL), 0);
    cleft_part_destroy(one.part);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranks_hear_of_the_whole), cmocka_unit_test(some_ranks_have_nothing),
        cmocka_unit_test(labels_can_be_lost),      cmocka_unit_test(what_one_gives_wrong_all_hear),
        cmocka_unit_test(arguments_are_looked_at),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
