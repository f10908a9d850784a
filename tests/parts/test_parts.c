/* Meshes in parts: put together, they are the mesh of one process, whatever the number of ranks. */
#include "broken_exchange.h"
#include "compare_parts.h"
#include "ranks.h"

#include <stdio.h>

typedef struct {
    const void* voxels;
    int64_t dims[3];
    int fails; /* the read of this rank */
} memory;

static int read_memory(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                       void* user)
{
    const memory* from = (const memory*)user;
    int32_t* out = (int32_t*)voxels;
    if (from->fails) {
        snprintf(sentence, (size_t)room, "the tape is worn at plane %d", (int)first[2]);
        return 1;
    }
    for (int64_t k = 0; k < count[2]; ++k)
        for (int64_t j = 0; j < count[1]; ++j)
            for (int64_t i = 0; i < count[0]; ++i)
                *out++ =
                    ((const int32_t*)
                         from->voxels)[first[0] + i + from->dims[0] * (first[1] + j + from->dims[1] * (first[2] + k))];
    return 0;
}

typedef struct {
    memory voxels;
    const double* affine;
    const cleft_options* options;
    int32_t ghosts;
    int32_t cancels, cancels_late;
    const char* scratch; /* in the place of what the exchange says */
    cleft_status status;
    char sentence[1000];
    cleft_part* part;
} job;

static int cancel_at_once(double fraction, const char* stage, void* user)
{
    (void)fraction, (void)stage, (void)user;
    return 1;
}

static int cancel_at_the_end(double fraction, const char* stage, void* user)
{
    (void)stage, (void)user;
    return fraction >= 1;
}

static void make_part(const cleft_exchange* exchange, void* user)
{
    job* mine = (job*)user;
    cleft_voxels voxels = {sizeof(cleft_voxels), CLEFT_TYPE_INT32, {0, 0, 0}, {0}, NULL, read_memory};
    cleft_context* context = NULL;
    cleft_exchange with_scratch = *exchange;
    if (mine->scratch)
        with_scratch.scratch = mine->scratch;
    memcpy(voxels.dims, mine->voxels.dims, sizeof voxels.dims);
    memcpy(voxels.affine, mine->affine, sizeof voxels.affine);
    voxels.user = &mine->voxels;
    if (cleft_context_create(&context) != CLEFT_OK)
        return;
    if (mine->cancels && cleft_context_set_progress(context, cancel_at_once, NULL) != CLEFT_OK)
        return;
    if (mine->cancels_late && cleft_context_set_progress(context, cancel_at_the_end, NULL) != CLEFT_OK)
        return;
    mine->status = cleft_part_create(context, &voxels, mine->options, &with_scratch, mine->ghosts, &mine->part);
    snprintf(mine->sentence, sizeof mine->sentence, "%s", cleft_context_last_error(context));
    cleft_context_destroy(context);
}

static const double kPlain[12] = {1, 0, 0, 0.5, 0, 1, 0, 0.5, 0, 0, 1, 0.5};
static const double kFlipped[12] = {-1, 0.1, 0, 20, 0, 1.5, 0, -3, 0, 0, 1, 8};

/* By rank: all of the same volume. */
static void set_jobs(job* jobs, int32_t ranks, const int32_t* voxels, const int64_t dims[3], const double* affine,
                     const cleft_options* options, int32_t ghosts)
{
    memset(jobs, 0, sizeof(job) * (size_t)ranks);
    for (int32_t r = 0; r < ranks; ++r) {
        jobs[r].voxels.voxels = voxels;
        for (int a = 0; a < 3; ++a)
            jobs[r].voxels.dims[a] = dims[a];
        jobs[r].affine = affine;
        jobs[r].options = options;
        jobs[r].ghosts = ghosts;
    }
}

static void destroy_parts(job* jobs, int32_t ranks)
{
    for (int32_t r = 0; r < ranks; ++r)
        cleft_part_destroy(jobs[r].part);
}

/* Makes the mesh in one call, and in parts by several numbers of ranks. */
static void compare_with_whole(const int32_t* voxels, const int64_t dims[3], const double* affine,
                               const cleft_options* options)
{
    static const int32_t kRanks[] = {1, 2, 3, 4, 7, 8};
    cleft_context* context = new_context();
    cleft_volume* volume = NULL;
    cleft_mesh* whole = NULL;
    assert_ok(context, cleft_volume_create_labels(context, CLEFT_TYPE_INT32, voxels, dims, affine, options, &volume));
    assert_ok(context, cleft_mesh_volume(context, volume, NULL, NULL, options, &whole));
    for (size_t i = 0; i < sizeof kRanks / sizeof *kRanks; ++i) {
        const int32_t ghosts = (int32_t)(i % 2);
        job jobs[MOST_RANKS];
        set_jobs(jobs, kRanks[i], voxels, dims, affine, options, ghosts);
        ranks_run(kRanks[i], make_part, jobs, sizeof *jobs);
        for (int32_t r = 0; r < kRanks[i]; ++r)
            if (jobs[r].status != CLEFT_OK)
                fail_msg("rank %d of %d: %s", (int)r, (int)kRanks[i], jobs[r].sentence);
        const cleft_part* parts[MOST_RANKS];
        for (int32_t r = 0; r < kRanks[i]; ++r)
            parts[r] = jobs[r].part;
        assert_parts_of(context, parts, kRanks[i], ghosts, whole);
        destroy_parts(jobs, kRanks[i]);
    }
    cleft_mesh_destroy(whole);
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
}

static cleft_options* options_of(const char* background, const char* improve, const char* block)
{
    cleft_options* options = NULL;
    assert_int_equal(cleft_options_create(&options), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "background", background), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "improve", improve), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(options, "block", block), CLEFT_OK);
    return options;
}

static void compare_ball(int n, const double* affine, const char* background, const char* improve, const int32_t* strip)
{
    const int64_t dims[3] = {n, n, n};
    int32_t* voxels = ball_labels(n);
    cleft_options* options = options_of(background, improve, "0");
    if (strip)
        assert_int_equal(cleft_options_set_strip(options, strip, 1), CLEFT_OK);
    compare_with_whole(voxels, dims, affine, options);
    cleft_options_destroy(options);
    free(voxels);
}

static void parts_are_the_whole(void** state)
{
    static const int32_t kOutside = 1000;
    (void)state;
    compare_ball(12, kPlain, "particles", "fast", NULL);
    compare_ball(12, kPlain, "octree", "off", NULL);
    compare_ball(10, kFlipped, "lattice", "fast", NULL);
    compare_ball(10, kPlain, "octree", "fast", &kOutside);
}

static void more_ranks_than_points(void** state)
{
    (void)state;
    compare_ball(1, kPlain, "lattice", "fast", NULL);
}

/* Volumes of blocks that several ranks make: each voxel from its place. */
typedef int32_t (*labelling)(const int64_t at[3]);

static uint32_t hash_of(int64_t i, int64_t j, int64_t k)
{
    uint32_t h = (uint32_t)(i * 73856093 ^ j * 19349663 ^ k * 83492791);
    h = (h ^ h >> 15) * 2246822519u;
    return (h ^ h >> 13) * 3266489917u >> 16;
}
static int32_t noise(const int64_t at[3]) { return (int32_t)(hash_of(at[0], at[1], at[2]) % 3); }
static int32_t grains(const int64_t at[3])
{
    /* The nearest of some seeds, one in each cube of six voxels. */
    int64_t least = INT64_MAX;
    int32_t label = 0;
    for (int c = 0; c < 27; ++c) {
        const int64_t cell[3] = {at[0] / 6 + c % 3 - 1, at[1] / 6 + c / 3 % 3 - 1, at[2] / 6 + c / 9 - 1};
        int64_t square = 0;
        for (int a = 0; a < 3; ++a) {
            const int64_t d = 6 * cell[a] + hash_of(cell[0], cell[1] + a, cell[2]) % 6 - at[a];
            square += d * d;
        }
        if (square < least) {
            least = square;
            label = (int32_t)hash_of(cell[0], cell[1], cell[2]) % 40 - 7;
        }
    }
    return label;
}
static int32_t upright_sheet(const int64_t at[3]) { return at[0] + (at[2] > 20) == 5 ? 3 : at[0] > 5 ? 5 : 4; }
static int32_t sheet_on_a_seam(const int64_t at[3]) { return at[2] == 11 || at[2] == 24 ? 9 : at[2] > 24 ? 2 : 1; }
static int32_t slanted_sheet(const int64_t at[3]) { return (at[0] + at[1] + at[2]) % 13 < 2 ? 1 : 0; }
static int32_t scattered(const int64_t at[3])
{
    return at[0] % 5 < 2 && at[1] % 6 < 2 && at[2] % 7 < 3 ? 2 : at[1] < 8 ? 1 : 0;
}
static int32_t single_voxels(const int64_t at[3])
{
    return at[0] % 8 == 4 && at[1] % 8 == 4 && (at[2] == 11 || at[2] == 12 || at[2] == 25) ? (int32_t)at[2] : 0;
}
static int32_t one_label(const int64_t at[3]) { return at[0] < 0 ? 1 : 70000; }
static int32_t new_label_a_plane(const int64_t at[3]) { return (int32_t)(at[2] / 2) * (at[0] > 7 ? -1 : 1); }
static int32_t ball(const int64_t at[3])
{
    int64_t square = 0;
    for (int a = 0; a < 3; ++a)
        square += (2 * at[a] - 15 * (a == 2 ? 3 : 1)) * (2 * at[a] - 15 * (a == 2 ? 3 : 1));
    return square < 14 * 14;
}

static void compare_labelling(labelling label, const int64_t dims[3], const double* affine, cleft_options* options)
{
    int32_t* voxels = (int32_t*)malloc(sizeof(int32_t) * (size_t)(dims[0] * dims[1] * dims[2]));
    int64_t at[3], v = 0;
    assert_non_null(voxels);
    for (at[2] = 0; at[2] < dims[2]; ++at[2])
        for (at[1] = 0; at[1] < dims[1]; ++at[1])
            for (at[0] = 0; at[0] < dims[0]; ++at[0])
                voxels[v++] = label(at);
    compare_with_whole(voxels, dims, affine, options);
    free(voxels);
}

static void compare_blocks(labelling label, const int64_t dims[3], const double* affine, const char* block,
                           const char* background)
{
    cleft_options* options = options_of(background, "fast", block);
    compare_labelling(label, dims, affine, options);
    cleft_options_destroy(options);
}

static void ranks_share_blocks(void** state)
{
    /* A spacing without a short binary number: places that are computed from another plane would differ. */
    static const double kThirds[12] = {0.7, 0, 0, 0.5, 0, 0.9, 0, -4, 0, 0, 0.3333, 17};
    static const int64_t kTall[3] = {16, 16, 48}, kThin[3] = {9, 10, 48}, kFlat[3] = {8, 7, 9}, kLong[3] = {3, 2, 130};
    (void)state;
    compare_blocks(ball, kTall, kPlain, "12", "octree");
    compare_blocks(noise, kFlat, kThirds, "3", "octree");
    compare_blocks(noise, kLong, kPlain, "40", "octree");
    compare_blocks(grains, kThin, kThirds, "9", "octree");
    compare_blocks(ball, kTall, kFlipped, "13", "octree");
    compare_blocks(upright_sheet, kThin, kThirds, "12", "octree");
    compare_blocks(sheet_on_a_seam, kTall, kPlain, "12", "octree");
    compare_blocks(slanted_sheet, kTall, kPlain, "12", "octree");
    compare_blocks(scattered, kThin, kThirds, "7", "octree");
    compare_blocks(single_voxels, kTall, kPlain, "12", "octree");
    compare_blocks(one_label, kTall, kThirds, "12", "octree");
    compare_blocks(ball, kTall, kFlipped, "12", "lattice");
    compare_blocks(slanted_sheet, kThin, kThirds, "7", "lattice");
    compare_blocks(new_label_a_plane, kTall, kPlain, "12", "octree");
    compare_blocks(grains, kThin, kThirds, "9", "particles");
    compare_blocks(slanted_sheet, kTall, kFlipped, "12", "particles");
    compare_blocks(scattered, kThin, kThirds, "12", "particles");
    compare_blocks(noise, kLong, kPlain, "20", "particles");
    compare_blocks(noise, kFlat, kThirds, "3", "particles");
    compare_blocks(ball, kTall, kFlipped, "13", "particles");
    compare_blocks(sheet_on_a_seam, kTall, kPlain, "12", "particles");
    compare_blocks(single_voxels, kTall, kPlain, "12", "particles");
    compare_blocks(one_label, kTall, kThirds, "12", "particles");
}

static int32_t flat_interface(const int64_t at[3]) { return at[2] < 218; }

/* Vertices snap by planes of voxels, beyond the tetrahedra of their block. */
static void long_edges_leave_a_block(void** state)
{
    static const double kPlates[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 0.2, 0};
    static const int64_t kDims[3] = {20, 20, 400};
    cleft_options* options = options_of("octree", "fast", "200");
    (void)state;
    assert_int_equal(cleft_options_set_text(options, "size", "9"), CLEFT_OK);
    compare_labelling(flat_interface, kDims, kPlates, options);
    cleft_options_destroy(options);
}

/* Whoever fails, all get the status and the sentence, and the number of the rank. */
static void one_fails_all_fail(void** state)
{
    static const int64_t kDims[3] = {8, 8, 8};
    int32_t* voxels = ball_labels(8);
    cleft_options* other = NULL;
    job jobs[4];
    (void)state;
    set_jobs(jobs, 4, voxels, kDims, kPlain, NULL, 0);
    jobs[0].voxels.fails = 1;
    ranks_run(4, make_part, jobs, sizeof *jobs);
    for (int r = 0; r < 4; ++r) {
        assert_int_equal(jobs[r].status, CLEFT_ERROR_FILE);
        assert_string_equal(jobs[r].sentence, "rank 0: the tape is worn at plane 0");
        assert_null(jobs[r].part);
    }
    set_jobs(jobs, 4, voxels, kDims, kPlain, NULL, 0);
    jobs[2].cancels = 1;
    ranks_run(4, make_part, jobs, sizeof *jobs);
    for (int r = 0; r < 4; ++r) {
        assert_int_equal(jobs[r].status, CLEFT_ERROR_CANCELLED);
        assert_string_equal(jobs[r].sentence, "rank 2: the run was cancelled");
    }
    set_jobs(jobs, 4, voxels, kDims, kPlain, NULL, 0);
    jobs[3].cancels_late = 1;
    ranks_run(4, make_part, jobs, sizeof *jobs);
    for (int r = 0; r < 4; ++r) {
        assert_int_equal(jobs[r].status, CLEFT_ERROR_CANCELLED);
        assert_null(jobs[r].part);
    }
    assert_int_equal(cleft_options_create(&other), CLEFT_OK);
    assert_int_equal(cleft_options_set_text(other, "size", "3"), CLEFT_OK);
    set_jobs(jobs, 4, voxels, kDims, kPlain, NULL, 0);
    jobs[3].options = other;
    ranks_run(4, make_part, jobs, sizeof *jobs);
    for (int r = 0; r < 4; ++r) {
        assert_int_equal(jobs[r].status, CLEFT_ERROR_ARGUMENT);
        assert_string_equal(jobs[r].sentence, "the ranks do not give the same volume, options and ghosts");
    }
    cleft_options_destroy(other);
    free(voxels);
}

/* One call and the ranks say the same of a volume of this affine: the status, which is returned, and how the sentence
 * begins. Labels meet in the upper half only. */
static cleft_status assert_same_status(const double* affine, const char* block, double size)
{
    static const int64_t kDims[3] = {4, 4, 6};
    static const int32_t kRanks[] = {1, 2, 3}, kLeftOut = 2;
    int32_t voxels[4 * 4 * 6];
    cleft_context* context = new_context();
    cleft_options* options = options_of("octree", "off", block);
    cleft_volume* volume = NULL;
    cleft_mesh* whole = NULL;
    for (int v = 0; v < 4 * 4 * 6; ++v)
        voxels[v] = 1 + (v >= 48) * (int32_t)(hash_of(v, 0, 0) % 3);
    assert_int_equal(cleft_options_set_strip(options, &kLeftOut, 1), CLEFT_OK);
    assert_int_equal(cleft_options_set_real(options, CLEFT_OPTION_SIZE, size), CLEFT_OK);
    cleft_status status =
        cleft_volume_create_labels(context, CLEFT_TYPE_INT32, voxels, kDims, affine, options, &volume);
    if (status == CLEFT_OK)
        status = cleft_mesh_volume(context, volume, NULL, NULL, options, &whole);
    char sentence[1000];
    snprintf(sentence, sizeof sentence, "%.50s", cleft_context_last_error(context));
    for (size_t i = 0; i < sizeof kRanks / sizeof *kRanks; ++i) {
        job jobs[3];
        set_jobs(jobs, kRanks[i], voxels, kDims, affine, options, 0);
        ranks_run(kRanks[i], make_part, jobs, sizeof *jobs);
        for (int32_t r = 0; r < kRanks[i]; ++r) {
            if (jobs[r].status != status)
                fail_msg("rank %d of %d has status %d in the place of %d: %s", (int)r, (int)kRanks[i],
                         (int)jobs[r].status, (int)status, jobs[r].sentence);
            assert_string_equal(jobs[r].sentence, jobs[0].sentence);
            assert_true((jobs[r].part != NULL) == (status == CLEFT_OK));
            if (status != CLEFT_OK)
                assert_non_null(strstr(jobs[r].sentence, sentence));
        }
        destroy_parts(jobs, kRanks[i]);
    }
    cleft_mesh_destroy(whole);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
    return status;
}

/* The numbers of the world may be too coarse for a mesh that is sound in its own frame. */
static void a_coarse_world_is_refused_alike(void** state)
{
    static const struct {
        double spacing, distance, size; /* the latter two in spacings; size 0: those of the labels */
        const char* block;
        cleft_status status;
    } kCases[] = {
        {1e-16, 0, 0, "3", CLEFT_ERROR_ARGUMENT},
        {1e-15, 1e13, 0, "3", CLEFT_OK},
        {1e15, 1e13, 0, "3", CLEFT_OK},
        {1e15, 1e13, 0, "0", CLEFT_OK},
        {2e15, 0, 0, "3", CLEFT_ERROR_ARGUMENT},
        {0.3, 2e14, 0, "3", CLEFT_ERROR_ARGUMENT},
        {1e15, 1e300, 0, "0", CLEFT_ERROR_NOT_FINITE},
        {1.43, 9.85e13, 0.2, "3", CLEFT_ERROR_ARGUMENT},
    };
    (void)state;
    for (size_t c = 0; c < sizeof kCases / sizeof *kCases; ++c) {
        const double h = kCases[c].spacing, far = h * kCases[c].distance;
        const double affine[12] = {c % 2 ? -h : h, 0, 0, far, 0, h, 0, -far, 0, 0, h, far};
        assert_int_equal(assert_same_status(affine, kCases[c].block, h * kCases[c].size), kCases[c].status);
    }
}

static void scratch_needs_a_folder(void** state)
{
    static const int64_t kDims[3] = {8, 8, 8};
    int32_t* voxels = ball_labels(8);
    cleft_options* options = options_of("octree", "fast", "2");
    job jobs[3];
    (void)state;
    set_jobs(jobs, 3, voxels, kDims, kPlain, options, 0);
    jobs[1].scratch = "no/such/folder";
    ranks_run(3, make_part, jobs, sizeof *jobs);
    for (int r = 0; r < 3; ++r) {
        assert_int_equal(jobs[r].status, CLEFT_ERROR_FILE);
        assert_string_equal(jobs[r].sentence,
                            "rank 1: cannot make a scratch file in 'no/such/folder': No such file or "
                            "directory");
        assert_null(jobs[r].part);
    }
    cleft_options_destroy(options);
    free(voxels);
}

static void an_exchange_can_break(void** state)
{
    static const int64_t kDims[3] = {4, 4, 4};
    int32_t* voxels = ball_labels(4);
    const cleft_exchange broken = {sizeof broken, 0, 2, NULL, send_nothing, send_no_bytes, NULL};
    const cleft_exchange outside = {sizeof outside, 2, 2, NULL, send_nothing, send_no_bytes, NULL};
    job one;
    (void)state;
    set_jobs(&one, 1, voxels, kDims, kPlain, NULL, 0);
    make_part(&broken, &one);
    assert_int_equal(one.status, CLEFT_ERROR_EXCHANGE);
    make_part(&outside, &one);
    assert_int_equal(one.status, CLEFT_ERROR_ARGUMENT);
    assert_string_equal(one.sentence, "the exchange has rank 2 of 2 ranks; ranks count from 0");
    assert_null(one.part);
    assert_null(cleft_part_points(NULL));
    assert_null(cleft_part_tet_numbers(NULL));
    assert_null(cleft_part_tet_owners(NULL));
    cleft_part_destroy(NULL);
    free(voxels);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(parts_are_the_whole),    cmocka_unit_test(more_ranks_than_points),
        cmocka_unit_test(ranks_share_blocks),     cmocka_unit_test(long_edges_leave_a_block),
        cmocka_unit_test(one_fails_all_fail),     cmocka_unit_test(a_coarse_world_is_refused_alike),
        cmocka_unit_test(scratch_needs_a_folder), cmocka_unit_test(an_exchange_can_break),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
