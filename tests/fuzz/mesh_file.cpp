// A reader of meshes on any bytes. FUZZ_FILES are the files that an input becomes, FUZZ_READS the one that is read.
#include "cleft/cleft_io.h"

#include "fuzz/given_files.hpp"
#include "fuzz/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const fuzz::Context context;
    const std::string path = fuzz::give_files(data, size, FUZZ_FILES) + FUZZ_READS;
    cleft_mesh* mesh = nullptr;
    if (context.succeeded(cleft_io_read_mesh(context, path.c_str(), &mesh)))
        fuzz::judge_arrays(context, mesh);
    else
        fuzz::expect(mesh == nullptr, "there is a mesh after a failure");
    cleft_mesh_destroy(mesh);
    return 0;
}
