/* The problem that the solvers of meshes in parts solve: a ball in a box conducts ten times better than what is around
 * it, and the field far away is one along z. Its exact solution is known, and has a kink at the ball's surface.
 *
 * The voxels are computed where a rank asks for them. A program of yours reads them from a file instead, by
 * cleft_mpi_voxels_open() or cleft_io_voxels_open().
 */
#ifndef BALL_IN_FIELD_H
#define BALL_IN_FIELD_H

#include <cleft/cleft_mpi.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#define BALL_RADIUS 0.55
enum { AROUND = 1, BALL = 2, BALL_LABELS = 2 };
enum { BALL_VOXELS = 56 }; /* along each side of the box from (-1, -1, -1) to (1, 1, 1) */

static inline double ball_conductivity(int label) { return label == BALL ? 10 : 1; }

/* The potential, which the sides of the box are held at. */
static inline double ball_exact(const double x[3])
{
    const double k = ball_conductivity(BALL), r = sqrt(x[0] * x[0] + x[1] * x[1] + x[2] * x[2]);
    return r < BALL_RADIUS ? 3 / (k + 2) * x[2] : x[2] * (1 - (k - 1) / (k + 2) * pow(BALL_RADIUS / r, 3));
}

static inline int ball_read(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                            void* user)
{
    const double h = 2.0 / BALL_VOXELS;
    uint8_t* out = (uint8_t*)voxels;
    (void)sentence, (void)room, (void)user;
    for (int64_t k = first[2]; k < first[2] + count[2]; ++k)
        for (int64_t j = first[1]; j < first[1] + count[1]; ++j)
            for (int64_t i = first[0]; i < first[0] + count[0]; ++i) {
                const double x = h * ((double)i + 0.5) - 1, y = h * ((double)j + 0.5) - 1,
                             z = h * ((double)k + 0.5) - 1;
                *out++ = x * x + y * y + z * z < BALL_RADIUS * BALL_RADIUS ? BALL : AROUND;
            }
    return 0;
}

/* This rank's part of a mesh of edges of this length. NULL after a failure, which rank 0 has told. */
static inline cleft_part* ball_part(MPI_Comm comm, double size, int32_t ghosts)
{
    const double h = 2.0 / BALL_VOXELS;
    cleft_voxels voxels = {
        sizeof(cleft_voxels), CLEFT_TYPE_UINT8, {BALL_VOXELS, BALL_VOXELS, BALL_VOXELS}, {0}, NULL, ball_read};
    cleft_context* context = NULL;
    cleft_options* options = NULL;
    cleft_part* part = NULL;
    int rank = 0;
    for (int a = 0; a < 3; ++a) {
        voxels.affine[5 * a] = h;
        voxels.affine[4 * a + 3] = 0.5 * h - 1;
    }
    MPI_Comm_rank(comm, &rank);
    if (cleft_context_create(&context) || cleft_options_create(&options) ||
        cleft_options_set_real(options, CLEFT_OPTION_SIZE, size) ||
        cleft_mpi_mesh(context, comm, &voxels, options, ghosts, &part)) {
        if (rank == 0)
            fprintf(stderr, "%s\n", context ? cleft_context_last_error(context) : "no memory");
    }
    cleft_options_destroy(options);
    cleft_context_destroy(context);
    return part;
}

/* The volume of each label in the whole mesh, summed over the ranks. */
static inline void ball_volumes(MPI_Comm comm, const cleft_part* part, double volumes[BALL_LABELS + 1])
{
    const double* points = cleft_part_points(part);
    double mine[BALL_LABELS + 1] = {0};
    cleft_part_counts n;
    memset(&n, 0, sizeof n);
    n.struct_size = sizeof n;
    if (cleft_part_count(part, &n))
        return;
    for (int64_t t = 0; t < n.owned_tets; ++t) {
        const int32_t* corners = cleft_part_tets(part) + 4 * t;
        double e[3][3]; /* edges from the first corner */
        for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 3; ++d)
                e[c][d] = points[3 * corners[c + 1] + d] - points[3 * corners[0] + d];
        for (int d = 0; d < 3; ++d)
            mine[cleft_part_tet_labels(part)[t]] +=
                e[0][d] * (e[1][(d + 1) % 3] * e[2][(d + 2) % 3] - e[1][(d + 2) % 3] * e[2][(d + 1) % 3]) / 6;
    }
    MPI_Allreduce(mine, volumes, BALL_LABELS + 1, MPI_DOUBLE, MPI_SUM, comm);
}

#endif
