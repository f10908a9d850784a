/* Two voxels of two labels, meshed on all ranks: does the installed component work? */
#include <cleft/cleft_mpi.h>

#include <stdio.h>

static int read_labels(const int64_t first[3], const int64_t count[3], void* voxels, char* sentence, int64_t room,
                       void* user)
{
    uint8_t* out = (uint8_t*)voxels;
    (void)sentence, (void)room, (void)user;
    for (int64_t i = 0; i < count[0] * count[1] * count[2]; ++i)
        out[i] = (uint8_t)(first[0] + i);
    return 0;
}

int main(int argc, char** argv)
{
    const cleft_voxels voxels = {sizeof voxels, CLEFT_TYPE_UINT8, {2, 1, 1}, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                                 NULL,          read_labels};
    cleft_context* context = NULL;
    cleft_part* part = NULL;
    int provided = 0;
    MPI_Init_thread(&argc, &argv, MPI_THREAD_FUNNELED, &provided);
    const int failed = cleft_context_create(&context) != CLEFT_OK ||
                       cleft_mpi_mesh(context, MPI_COMM_WORLD, &voxels, NULL, 0, &part) != CLEFT_OK;
    if (failed)
        fprintf(stderr, "%s\n", cleft_context_last_error(context));
    cleft_part_destroy(part);
    cleft_context_destroy(context);
    MPI_Finalize();
    return failed;
}
