/* A small mesh made by hand for the tests of files: a box of 4 x 3 x 3 cubes of six tetrahedra each, three materials of
 * awkward labels that meet in lines and points, coordinates that need all their digits. */
#ifndef SAMPLE_MESH_H
#define SAMPLE_MESH_H

#include "cleft/cleft.h"

enum { SAMPLE_X = 4, SAMPLE_Y = 3, SAMPLE_Z = 3 };
enum {
    SAMPLE_POINTS = (SAMPLE_X + 1) * (SAMPLE_Y + 1) * (SAMPLE_Z + 1),
    SAMPLE_TETS = 6 * SAMPLE_X * SAMPLE_Y * SAMPLE_Z
};

/* Its labels, in ascending order. */
#define SAMPLE_LABELS -7, 3, 2000000000

typedef struct sample_mesh {
    double points[3 * SAMPLE_POINTS];
    int32_t tets[4 * SAMPLE_TETS];
    int32_t labels[SAMPLE_TETS];
} sample_mesh;

void sample_mesh_fill(sample_mesh* sample);
/* The same as a handle; NULL on failure. */
cleft_mesh* sample_mesh_create(cleft_context* context);

#endif
