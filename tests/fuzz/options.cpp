// Texts of options, a line "name=value" each, and the same lines as names of labels.
#include "fuzz/bytes.hpp"
#include "fuzz/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

using fuzz::expect;

// Whatever texts were given: each value is in its range.
void judge_values(const fuzz::Options& options)
{
    for (int32_t row = 0; row < cleft_option_count(); ++row) {
        cleft_option_description about{};
        about.struct_size = sizeof about;
        expect(cleft_option_info(row, &about) == CLEFT_OK, "a row of the table of options is not there");
        double real = 0;
        int64_t whole = 0;
        if (about.type == CLEFT_OPTION_TYPE_REAL) {
            expect(cleft_options_get_real(options, about.key, &real) == CLEFT_OK, "a real option has no real value");
        } else {
            expect(cleft_options_get_integer(options, about.key, &whole) == CLEFT_OK, "an option has no whole value");
            real = static_cast<double>(whole);
        }
        expect(real >= about.least && real <= about.greatest, "an option has a value out of its range");
    }
}

void set_option(const fuzz::Options& options, const std::string& line)
{
    const size_t end = std::min(line.find('='), line.size());
    const std::string name = line.substr(0, end);
    const std::string value = line.substr(std::min(end + 1, line.size()));
    const cleft_status status = cleft_options_set_text(options, name.c_str(), value.c_str());
    expect(status == CLEFT_OK || status == CLEFT_ERROR_OPTION || status == CLEFT_ERROR_NOT_FINITE,
           "the status is not one of an option");
    const std::string sentence = cleft_options_last_error(options);
    expect(status == CLEFT_OK || (!sentence.empty() && fuzz::is_line(sentence)),
           "there is no sentence about an option that is refused");
}

void name_label(const fuzz::Context& context, const std::string& line)
{
    const int64_t dims[3] = {1, 1, 1};
    const uint8_t voxel = 7;
    cleft_volume* volume = nullptr;
    expect(cleft_volume_create_labels(context, CLEFT_TYPE_UINT8, &voxel, dims, nullptr, nullptr, &volume) == CLEFT_OK,
           "a volume of one voxel cannot be made");
    const std::string text = line.c_str();  // to the first 0
    const bool named = cleft_volume_set_label_name(volume, voxel, text.c_str()) == CLEFT_OK;
    expect(!named || fuzz::is_line(text), "a name that is no line of text is taken");
    expect(cleft_volume_label_name(volume, voxel) == (named ? text : ""), "a label has another name than it was given");
    cleft_volume_destroy(volume);
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    const fuzz::Context context;
    const fuzz::Options options;
    for (fuzz::Bytes bytes(data, size); bytes.are_left();) {
        const std::string line = bytes.line();
        set_option(options, line);
        name_label(context, line);
    }
    judge_values(options);
    return 0;
}
