// A reader of metrics on any bytes. FUZZ_FILES are the files that an input becomes, FUZZ_READS what is read.
#include "cleft/cleft_io.h"

#include "fuzz/given_files.hpp"
#include "fuzz/judge.hpp"

#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

void judge_metric(const cleft_sizing* sizing)
{
    int64_t dims[3] = {};
    fuzz::expect(cleft_sizing_dims(sizing, dims) == CLEFT_OK, "a field has no dims");
    fuzz::expect(cleft_sizing_has_metric(sizing) == 1, "a metric that was read is none");
    std::vector<float> tensors(static_cast<size_t>(6 * dims[0] * dims[1] * dims[2]));
    fuzz::expect(cleft_sizing_copy_metric(sizing, tensors.data(), static_cast<int64_t>(tensors.size())) == CLEFT_OK,
                 "a metric cannot be copied");
    for (size_t i = 0; i < tensors.size(); i += 6)
        // Single precision ends long before the sizes that a field may have.
        fuzz::expect(tensors[i] >= 0 && tensors[i + 3] >= 0 && tensors[i + 5] >= 0, "a square of a length is negative");
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const fuzz::Context context;
    const std::string path = fuzz::give_files(data, size, FUZZ_FILES) + FUZZ_READS;
    for (const cleft_io_tensor_order order : {CLEFT_IO_ORDER_FILE, CLEFT_IO_ORDER_NIFTI}) {
        cleft_sizing* sizing = nullptr;
        if (context.succeeded(
                cleft_io_read_metric(context, nullptr, path.c_str(), nullptr, order, 0, nullptr, &sizing)))
            judge_metric(sizing);
        else
            fuzz::expect(sizing == nullptr, "there is a field after a failure");
        cleft_sizing_destroy(sizing);
    }
    return 0;
}
