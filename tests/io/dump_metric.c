/* Prints a metric of a file: dims, affine, and six numbers a voxel; or the refusal. */
#include <stdio.h>
#include <stdlib.h>

#include <cleft/cleft_io.h>

int main(int argc, char** argv)
{
    cleft_context* context = NULL;
    cleft_sizing* sizing = NULL;
    int64_t dims[3];
    double affine[12];
    if (argc != 2 || cleft_context_create(&context))
        return 2;
    const cleft_status status =
        cleft_io_read_metric(context, NULL, argv[1], NULL, CLEFT_IO_ORDER_FILE, 0, NULL, &sizing);
    if (status) {
        fprintf(stderr, "%s\n", cleft_context_last_error(context));
        cleft_context_destroy(context);
        return 1;
    }
    if (cleft_sizing_dims(sizing, dims) || cleft_sizing_affine(sizing, affine))
        return 2;
    const int64_t count = 6 * dims[0] * dims[1] * dims[2];
    float* tensors = malloc(sizeof(float) * (size_t)count);
    if (!tensors || cleft_sizing_copy_metric(sizing, tensors, count))
        return 2;
    for (int i = 0; i < 3; ++i)
        printf("%lld ", (long long)dims[i]);
    for (int i = 0; i < 12; ++i)
        printf("%.9g ", affine[i]);
    for (int64_t i = 0; i < count; ++i)
        printf("%.7g ", (double)tensors[i]);
    free(tensors);
    cleft_sizing_destroy(sizing);
    cleft_context_destroy(context);
    return 0;
}
