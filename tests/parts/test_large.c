/* Volumes of more than 2^31 voxels, which no process holds as a whole: what is read of them, and what is refused.
 * Reading ends with the first window, since a mesh of such a volume takes minutes. */
#include "support/capi.h"

#include "ranks.h"

#include <stdio.h>

enum { RANKS = 5 };

typedef struct {
    int64_t dims[3];
    const char* background;
    const char* block;
    int64_t first[3], count[3]; /* the first window that is asked for */
    int32_t windows;
    cleft_status status;
    char sentence[1000];
} job;

static int note_window(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                       void* user)
{
    job* mine = (job*)user;
    (void)voxels;
    memcpy(mine->first, first, sizeof mine->first);
    memcpy(mine->count, count, sizeof mine->count);
    ++mine->windows;
    snprintf(sentence, (size_t)room, "that is enough");
    return 1;
}

static void make_part(const cleft_exchange* exchange, void* user)
{
    job* mine = (job*)user;
    cleft_voxels voxels = {sizeof(cleft_voxels), CLEFT_TYPE_UINT8, {0, 0, 0}, {0}, mine, note_window};
    cleft_context* context = NULL;
    cleft_options* options = NULL;
    cleft_part* part = NULL;
    memcpy(voxels.dims, mine->dims, sizeof voxels.dims);
    voxels.affine[0] = voxels.affine[5] = voxels.affine[10] = 1;
    if (cleft_context_create(&context) || cleft_options_create(&options) ||
        cleft_options_set_text(options, "background", mine->background) ||
        cleft_options_set_text(options, "block", mine->block))
        return;
    mine->status = cleft_part_create(context, &voxels, options, exchange, 0, &part);
    snprintf(mine->sentence, sizeof mine->sentence, "%s", cleft_context_last_error(context));
    cleft_part_destroy(part);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
}

static void run_jobs(job* jobs, const int64_t dims[3], const char* background, const char* block)
{
    memset(jobs, 0, RANKS * sizeof *jobs);
    for (int r = 0; r < RANKS; ++r) {
        memcpy(jobs[r].dims, dims, sizeof jobs[r].dims);
        jobs[r].background = background;
        jobs[r].block = block;
    }
    ranks_run(RANKS, make_part, jobs, sizeof *jobs);
}

/* Each rank begins with its own planes, the last ones far beyond 2^31 voxels. */
static void ranks_read_their_planes(void** state)
{
    static const int64_t kLong[3] = {64, 64, 600000}, kCube[3] = {2000, 2000, 2000};
    job jobs[RANKS];
    (void)state;
    for (int kind = 0; kind < 2; ++kind) {
        run_jobs(jobs, kLong, kind == 0 ? "octree" : "particles", "4000");
        for (int r = 0; r < RANKS; ++r) {
            assert_int_equal(jobs[r].status, CLEFT_ERROR_FILE);
            assert_string_equal(jobs[r].sentence, "that is enough");
            assert_int_equal(jobs[r].windows, 1);
            assert_int_equal(jobs[r].first[2], 120000 * r);
            assert_int_equal(jobs[r].count[0], 64);
            assert_int_equal(jobs[r].count[2], 4000);
        }
    }
    run_jobs(jobs, kCube, "octree", "10");
    assert_string_equal(jobs[RANKS - 1].sentence, "that is enough");
    assert_int_equal(jobs[RANKS - 1].first[2], 1600);
    assert_int_equal(jobs[RANKS - 1].count[1], 2000);
}

static void assert_refused(const job* jobs, const char* sentence)
{
    for (int r = 0; r < RANKS; ++r) {
        assert_int_equal(jobs[r].status, CLEFT_ERROR_TOO_LARGE);
        assert_string_equal(jobs[r].sentence, sentence);
        assert_int_equal(jobs[r].windows, 0);
    }
}

static void what_one_process_would_hold_is_refused(void** state)
{
    static const int64_t kCube[3] = {2000, 2000, 2000}, kWide[3] = {30000, 30000, 40}, kLong[3] = {1, 1, 600000000};
    job jobs[RANKS];
    (void)state;
    run_jobs(jobs, kCube, "octree", "0");
    assert_refused(jobs,
                   "the volume has more than 2147483647 voxels, too many to mesh in one piece, which is needed "
                   "since block is 0 or more than half of the planes");
    run_jobs(jobs, kWide, "octree", "8");
    assert_refused(jobs,
                   "rank 0: 7200000000 voxels are needed at once, from plane 0 to plane 7, more than 2147483647: "
                   "set a smaller block");
    run_jobs(jobs, kLong, "octree", "8");
    assert_refused(jobs, "the number of voxels along z is 600000000, too many for 32-bit numbering");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(ranks_read_their_planes),
        cmocka_unit_test(what_one_process_would_hold_is_refused),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
