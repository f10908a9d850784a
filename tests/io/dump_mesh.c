/* dump_mesh MESH FOLDER: reads a mesh and writes it as bare arrays: points.f64, tets.i32, labels.i32. */
#include "cleft/cleft_io.h"

#include <stdio.h>

static int write_array(const char* folder, const char* name, const void* data, size_t bytes)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* file = fopen(path, "wb");
    if (!file)
        return 0;
    const int written = fwrite(data, 1, bytes, file) == bytes;
    return fclose(file) == 0 && written;
}

int main(int argc, char** argv)
{
    cleft_context* context = NULL;
    cleft_mesh* mesh = NULL;
    if (argc != 3 || cleft_context_create(&context) != CLEFT_OK)
        return 2;
    const cleft_status status = cleft_io_read_mesh(context, argv[1], &mesh);
    if (status != CLEFT_OK)
        fprintf(stderr, "%d %s\n", (int)status, cleft_context_last_error(context));
    const size_t points = (size_t)cleft_mesh_point_count(mesh);
    const size_t tets = (size_t)cleft_mesh_tet_count(mesh);
    const int written = mesh &&
                        write_array(argv[2], "points.f64", cleft_mesh_points(mesh), 3 * points * sizeof(double)) &&
                        write_array(argv[2], "tets.i32", cleft_mesh_tets(mesh), 4 * tets * sizeof(int32_t)) &&
                        write_array(argv[2], "labels.i32", cleft_mesh_tet_labels(mesh), tets * sizeof(int32_t));
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
    return written ? 0 : 1;
}
