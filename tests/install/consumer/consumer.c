/* Meshes a cube in a box: does the library that was found work? */
#include <stdio.h>
#include <string.h>

#include <cleft/cleft.h>

int main(void)
{
    static uint8_t voxels[10][10][10];
    const int64_t dims[3] = {10, 10, 10};
    cleft_context* context = NULL;
    cleft_options* options = NULL;
    cleft_volume* volume = NULL;
    cleft_mesh* mesh = NULL;
    for (int k = 3; k < 7; ++k)
        for (int j = 3; j < 7; ++j)
            memset(&voxels[k][j][3], 1, 4);

    if (strcmp(cleft_version(NULL, NULL, NULL), CLEFT_VERSION_STRING) != 0)
        return 1; /* the header of one version and the library of another */
    if (cleft_context_create(&context) || cleft_options_create(&options))
        return 1;
    if (cleft_options_set_text(options, "background", "lattice") ||
        cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, voxels, dims, NULL, options, &volume) ||
        cleft_mesh_volume(context, volume, NULL, NULL, options, &mesh))
        fprintf(stderr, "%s\n", cleft_context_last_error(context));
    else
        printf("%lld tetrahedra, %lld labels\n", (long long)cleft_mesh_tet_count(mesh),
               (long long)cleft_mesh_label_count(mesh));
    const int good = mesh && cleft_mesh_label_count(mesh) == 2;
    cleft_mesh_destroy(mesh);
    cleft_volume_destroy(volume);
    cleft_options_destroy(options);
    cleft_context_destroy(context);
    return !good;
}
