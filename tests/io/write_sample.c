/* write_sample FOLDER [LABEL LABEL LABEL]: writes the sample mesh (with other labels, if given, in the place of its own
 * in ascending order) in every format, and as bare arrays for the programs that compare: points.f64, tets.i32,
 * labels.i32, interface.i32 (three corners, two labels), hull.i32 (three corners, label, side).
 */
#include "cleft/cleft_io.h"
#include "io/sample_mesh.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define NAME_OF_SECOND                 \
    "Right lung, \"gr\xc3\xb6\xc3\x9f" \
    "er\" & <b> '"

static const char* folder;

static FILE* open_array(const char* name)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    FILE* file = fopen(path, "wb");
    if (!file) {
        perror(path);
        exit(1);
    }
    return file;
}

static void write_array(const char* name, const void* data, size_t bytes)
{
    FILE* file = open_array(name);
    fwrite(data, 1, bytes, file);
    fclose(file);
}

static void write_surface(const cleft_surface* surface)
{
    FILE* file = open_array("interface.i32");
    for (int64_t t = 0; t < cleft_surface_interface_count(surface); ++t) {
        fwrite(cleft_surface_interface_triangles(surface) + 3 * t, sizeof(int32_t), 3, file);
        fwrite(cleft_surface_interface_labels(surface) + 2 * t, sizeof(int32_t), 2, file);
    }
    fclose(file);
    file = open_array("hull.i32");
    for (int64_t t = 0; t < cleft_surface_hull_count(surface); ++t) {
        fwrite(cleft_surface_hull_triangles(surface) + 3 * t, sizeof(int32_t), 3, file);
        fwrite(cleft_surface_hull_labels(surface) + t, sizeof(int32_t), 1, file);
        fwrite(cleft_surface_hull_sides(surface) + t, sizeof(int32_t), 1, file);
    }
    fclose(file);
}

static cleft_mesh* make_mesh(cleft_context* context, char** labels)
{
    static const int32_t own[] = {SAMPLE_LABELS};
    sample_mesh sample;
    cleft_mesh* mesh = NULL;
    sample_mesh_fill(&sample);
    for (int t = 0; labels && t < SAMPLE_TETS; ++t)
        for (int i = 0; i < 3; ++i)
            if (sample.labels[t] == own[i]) {
                sample.labels[t] = (int32_t)strtol(labels[i], NULL, 10);
                break;
            }
    if (cleft_mesh_create(context, SAMPLE_POINTS, sample.points, SAMPLE_TETS, sample.tets, sample.labels, 0, &mesh) !=
            CLEFT_OK ||
        cleft_mesh_set_label_name(mesh, labels ? (int32_t)strtol(labels[1], NULL, 10) : own[1], NAME_OF_SECOND) !=
            CLEFT_OK)
        return NULL;
    return mesh;
}

int main(int argc, char** argv)
{
    if (argc != 2 && argc != 5)
        return 2;
    folder = argv[1];
    cleft_context* context = NULL;
    cleft_surface* surface = NULL;
    if (cleft_context_create(&context) != CLEFT_OK)
        return 1;
    cleft_mesh* mesh = make_mesh(context, argc == 5 ? argv + 2 : NULL);
    if (!mesh || cleft_surface_create(context, mesh, &surface) != CLEFT_OK) {
        fprintf(stderr, "%s\n", cleft_context_last_error(context));
        return 1;
    }
    write_array("points.f64", cleft_mesh_points(mesh), sizeof(double) * 3 * (size_t)cleft_mesh_point_count(mesh));
    write_array("tets.i32", cleft_mesh_tets(mesh), sizeof(int32_t) * 4 * (size_t)cleft_mesh_tet_count(mesh));
    write_array("labels.i32", cleft_mesh_tet_labels(mesh), sizeof(int32_t) * (size_t)cleft_mesh_tet_count(mesh));
    write_surface(surface);

    int failures = 0;
    for (int32_t i = 0; i < cleft_io_format_count(); ++i) {
        cleft_io_format_description row = {.struct_size = sizeof row};
        if (cleft_io_format_info(i, &row) != CLEFT_OK || !(row.directions & CLEFT_IO_WRITES_MESH))
            continue;
        char path[4096];
        snprintf(path, sizeof path, "%s/%s%.*s", folder, row.name, (int)strcspn(row.extensions, " "), row.extensions);
        if (cleft_io_write_mesh(context, mesh, path, row.format) != CLEFT_OK) {
            fprintf(stderr, "%s: %s\n", row.name, cleft_context_last_error(context));
            ++failures;
        }
    }
    cleft_surface_destroy(surface);
    cleft_mesh_destroy(mesh);
    cleft_context_destroy(context);
    return failures != 0;
}
