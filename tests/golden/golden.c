/* The golden case (README.md) in C: the program that the other languages are compared with. */
#include <inttypes.h>
#include <stdio.h>

#include "cleft/cleft.h"

enum { NX = 16, NY = 14, NZ = 12 };

static int square(int x) { return x * x; }

static uint8_t label_at(int i, int j, int k)
{
    if (square(i - 10) + square(j - 7) + square(k - 6) <= 14)
        return 200;
    if (square(i - 5) + square(j - 6) + square(k - 5) <= 17)
        return 3;
    return 0;
}

static uint64_t fnv1a(uint64_t hash, const void* data, size_t size)
{
    const unsigned char* bytes = data;
    for (size_t i = 0; i < size; ++i)
        hash = (hash ^ bytes[i]) * UINT64_C(0x100000001b3);
    return hash;
}

static uint64_t hash_of(const cleft_mesh* mesh)
{
    const size_t points = (size_t)cleft_mesh_point_count(mesh), tets = (size_t)cleft_mesh_tet_count(mesh);
    uint64_t hash = UINT64_C(0xcbf29ce484222325);
    hash = fnv1a(hash, cleft_mesh_points(mesh), 3 * points * sizeof(double));
    hash = fnv1a(hash, cleft_mesh_tets(mesh), 4 * tets * sizeof(int32_t));
    return fnv1a(hash, cleft_mesh_tet_labels(mesh), tets * sizeof(int32_t));
}

int main(void)
{
    static uint8_t voxels[NZ][NY][NX];
    const int64_t dims[3] = {NX, NY, NZ};
    const double affine[12] = {1, 0, 0, -4.5, 0, 1.25, 0, 2.25, 0, 0, 1.5, 100};
    cleft_context* context = NULL;
    cleft_options* options = NULL;
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;

    for (int k = 0; k < NZ; ++k)
        for (int j = 0; j < NY; ++j)
            for (int i = 0; i < NX; ++i)
                voxels[k][j][i] = label_at(i, j, k);

    cleft_status status = cleft_context_create(&context);
    if (!status)
        status = cleft_context_set_threads(context, 1);
    if (!status)
        status = cleft_options_create(&options);
    if (!status)
        status = cleft_options_set_integer(options, CLEFT_OPTION_BACKGROUND, CLEFT_BACKGROUND_PARTICLES);
    if (!status)
        status = cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, affine, options, &volume);
    if (!status)
        status = cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh);
    if (status)
        fprintf(stderr, "%s: %s\n", cleft_status_string(status), cleft_context_last_error(context));
    else
        printf("%016" PRIx64 "\n", hash_of(mesh));

    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
    return status != 0;
}
