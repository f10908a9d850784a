#include "io/sample_mesh.h"

static int32_t number_of(int i, int j, int k) { return i + (SAMPLE_X + 1) * (j + (SAMPLE_Y + 1) * k); }

static int32_t label_of(int i, int j, int k)
{
    static const int32_t labels[] = {SAMPLE_LABELS};
    if (i < 2)
        return labels[k < 1 ? 0 : 1];
    return labels[j < 2 ? 2 : 1];
}

void sample_mesh_fill(sample_mesh* sample)
{
    /* The six ways from corner 0 to corner 7 of a cube, all of positive volume. */
    static const int paths[6][4] = {{0, 1, 3, 7}, {0, 3, 2, 7}, {0, 2, 6, 7}, {0, 6, 4, 7}, {0, 4, 5, 7}, {0, 5, 1, 7}};
    int32_t tet = 0;
    for (int k = 0; k <= SAMPLE_Z; ++k)
        for (int j = 0; j <= SAMPLE_Y; ++j)
            for (int i = 0; i <= SAMPLE_X; ++i) {
                double* p = sample->points + 3 * number_of(i, j, k);
                const int inner = i > 0 && i < SAMPLE_X && j > 0 && j < SAMPLE_Y && k > 0 && k < SAMPLE_Z;
                p[0] = -1.0 / 3 + i * 0.7 + (inner ? 0.01 * j : 0);
                p[1] = 1e-7 + j / 7.0;
                p[2] = 12345.678901234567 + k * 0.3 + (inner ? 0.02 / (i + 1) : 0);
            }
    for (int k = 0; k < SAMPLE_Z; ++k)
        for (int j = 0; j < SAMPLE_Y; ++j)
            for (int i = 0; i < SAMPLE_X; ++i)
                for (int t = 0; t < 6; ++t, ++tet) {
                    for (int c = 0; c < 4; ++c) {
                        const int corner = paths[t][c];
                        sample->tets[4 * tet + c] =
                            number_of(i + (corner & 1), j + (corner >> 1 & 1), k + (corner >> 2));
                    }
                    sample->labels[tet] = label_of(i, j, k);
                }
}

cleft_mesh* sample_mesh_create(cleft_context* context)
{
    sample_mesh sample;
    cleft_mesh* mesh = NULL;
    sample_mesh_fill(&sample);
    if (cleft_mesh_create(context, SAMPLE_POINTS, sample.points, SAMPLE_TETS, sample.tets, sample.labels, 0, &mesh) !=
        CLEFT_OK)
        return NULL;
    return mesh;
}
