/* dump_volume WORLD KIND SX SY SZ OUT PATH...: reads a volume (WORLD and KIND: numbers of cleft_io.h; S: spacing, 0 for
 * the file's) and writes to OUT: dims (3 int64), affine (12 double), number of labels (int64), labels (int32), and the
 * label that the volume has at the world place of each voxel centre (int32). Prints what the library reports ("warning:
 * "), the names of labels ("name: ", label, name), and the failure, if any. With DISTURBED in the environment, signals
 * interrupt it and its children all the time. */
#include "cleft/cleft_io.h"

#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

static void write_centres(const cleft_volume* volume, const int64_t dims[3], const double affine[12], FILE* file)
{
    for (int64_t k = 0; k < dims[2]; ++k)
        for (int64_t j = 0; j < dims[1]; ++j)
            for (int64_t i = 0; i < dims[0]; ++i) {
                const double index[3] = {(double)i, (double)j, (double)k};
                double point[3];
                int32_t label = INT32_MIN;
                for (int row = 0; row < 3; ++row) {
                    point[row] = affine[4 * row + 3];
                    for (int axis = 0; axis < 3; ++axis)
                        point[row] += affine[4 * row + axis] * index[axis];
                }
                if (cleft_volume_sample(volume, point, 1, &label) != CLEFT_OK)
                    exit(2);
                fwrite(&label, sizeof label, 1, file);
            }
}

static void on_log(int32_t level, const char* sentence, void* user)
{
    (void)user;
    if (level == CLEFT_LOG_WARNING)
        printf("warning: %s\n", sentence);
}

static void on_signal(int signal) { (void)signal; }

/* Sends signals to this process and its children, whose calls to the system then fail with EINTR. */
static pid_t start_disturbing(void)
{
    struct sigaction action = {.sa_handler = on_signal}; /* without SA_RESTART, as Python has it */
    if (setpgid(0, 0) != 0 || sigaction(SIGUSR1, &action, NULL) != 0)
        exit(2);
    const pid_t pest = fork();
    for (const struct timespec pause = {.tv_nsec = 50000}; pest == 0 && getppid() != 1; nanosleep(&pause, NULL))
        kill(0, SIGUSR1);
    return pest;
}

static void stop_disturbing(pid_t pest)
{
    kill(pest, SIGKILL);
    while (waitpid(pest, NULL, 0) < 0)
        ;
}

int main(int argc, char** argv)
{
    cleft_context* context = NULL;
    cleft_volume* volume = NULL;
    const pid_t pest = getenv("DISTURBED") ? start_disturbing() : -1;
    if (argc < 8 || cleft_context_create(&context) != CLEFT_OK ||
        cleft_context_set_log(context, on_log, NULL) != CLEFT_OK)
        return 2;
    cleft_io_reading reading = {.struct_size = sizeof reading, .world = atoi(argv[1]), .kind = atoi(argv[2])};
    for (int axis = 0; axis < 3; ++axis)
        reading.spacing[axis] = atof(argv[3 + axis]);
    const cleft_status status =
        cleft_io_read_volume(context, NULL, (const char* const*)(argv + 7), argc - 7, &reading, &volume);
    if (pest > 0)
        stop_disturbing(pest);
    if (status != CLEFT_OK) {
        printf("%d %s\n", (int)status, cleft_context_last_error(context));
    } else {
        FILE* file = fopen(argv[6], "wb");
        int64_t dims[3];
        double affine[12];
        const int64_t labels = cleft_volume_label_count(volume);
        if (!file || cleft_volume_dims(volume, dims) != CLEFT_OK || cleft_volume_affine(volume, affine) != CLEFT_OK)
            return 2;
        fwrite(dims, sizeof *dims, 3, file);
        fwrite(affine, sizeof *affine, 12, file);
        fwrite(&labels, sizeof labels, 1, file);
        fwrite(cleft_volume_labels(volume), sizeof(int32_t), (size_t)labels, file);
        write_centres(volume, dims, affine, file);
        fclose(file);
        for (int64_t i = 0; i < labels; ++i) {
            const int32_t label = cleft_volume_labels(volume)[i];
            const char* name = cleft_volume_label_name(volume, label);
            if (*name)
                printf("name: %d %s\n", (int)label, name);
        }
    }
    cleft_volume_destroy(volume);
    cleft_context_destroy(context);
    return status == CLEFT_OK ? 0 : 1;
}
