// A reader of volumes on any bytes. FUZZ_FILES are the files that an input becomes, FUZZ_READS what is read.
#include "cleft/cleft_io.h"

#include "fuzz/given_files.hpp"
#include "fuzz/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

struct Grid {
    int64_t dims[3] = {};
    double affine[12] = {};
};

// Each number of the field is looked at: the address sanitizer finds an array that is shorter than its dims say.
bool read_field(const fuzz::Context& context, const char* path, Grid& grid)
{
    double* values = nullptr;
    const bool read = context.succeeded(cleft_io_read_field(context, path, nullptr, grid.dims, grid.affine, &values));
    fuzz::expect(read == (values != nullptr), "there are values after a failure, or none after a success");
    if (read) {
        volatile double last = 0;
        for (int64_t i = 0; i < grid.dims[0] * grid.dims[1] * grid.dims[2]; ++i)
            last = values[i];
        static_cast<void>(last);
    }
    cleft_io_free(values);
    return read;
}

void read_volume(const fuzz::Context& context, const char* path, cleft_io_kind kind, const Grid* field)
{
    cleft_io_reading reading{};
    reading.struct_size = sizeof reading;
    reading.kind = kind;
    cleft_volume* volume = nullptr;
    if (context.succeeded(cleft_io_read_volume(context, nullptr, &path, 1, &reading, &volume))) {
        fuzz::judge_volume(context, volume);
        Grid grid;
        fuzz::expect(cleft_volume_dims(volume, grid.dims) == CLEFT_OK, "a volume has no dims");
        for (int axis = 0; field && axis < 3; ++axis)
            fuzz::expect(grid.dims[axis] == field->dims[axis], "a field and a volume of one file have other dims");
    } else {
        fuzz::expect(volume == nullptr, "there is a volume after a failure");
    }
    cleft_volume_destroy(volume);
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const fuzz::Context context;
    const std::string path = fuzz::give_files(data, size, FUZZ_FILES) + FUZZ_READS;
    Grid grid;
    const bool is_field = read_field(context, path.c_str(), grid);
    for (const cleft_io_kind kind : {CLEFT_IO_KIND_AUTO, CLEFT_IO_KIND_LABELS, CLEFT_IO_KIND_INDICATORS})
        read_volume(context, path.c_str(), kind, is_field ? &grid : nullptr);
    return 0;
}
