// A small volume of any kind, meshed with any options of the table, stage by stage or in one call.
#include "fuzz/bytes.hpp"
#include "fuzz/given_volume.hpp"
#include "fuzz/judge.hpp"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace
{

using fuzz::Bytes;
using fuzz::expect;

constexpr double most_tets = 1000;  // so that an execution takes milliseconds

double any_value(Bytes& bytes, const cleft_option_description& about)
{
    if (about.type != CLEFT_OPTION_TYPE_REAL)
        return bytes.one_in(8) ? static_cast<double>(bytes.any<int32_t>()) : bytes.below(16);
    return bytes.one_in(8) ? bytes.any<double>() : bytes.between(0, 4);
}

// Values out of range are refused, which is as well.
void set_option(const fuzz::Options& options, Bytes& bytes)
{
    cleft_option_description about{};
    about.struct_size = sizeof about;
    if (cleft_option_info(bytes.below(cleft_option_count()), &about) != CLEFT_OK)
        fuzz::fault("a row of the table of options is not there");
    const double value = any_value(bytes, about);
    const cleft_status status = about.type == CLEFT_OPTION_TYPE_REAL
                                    ? cleft_options_set_real(options, about.key, value)
                                    : cleft_options_set_integer(options, about.key, static_cast<int64_t>(value));
    const bool in_range = value >= about.least && value <= about.greatest;
    expect((status == CLEFT_OK) == in_range, "an option is refused in its range, or taken out of it");
}

void limit(const fuzz::Options& options, cleft_option key, int64_t most)
{
    int64_t value = 0;
    expect(cleft_options_get_integer(options, key, &value) == CLEFT_OK, "an option has no value");
    if (value > most || (value == 0 && key == CLEFT_OPTION_MAX_TETS))
        expect(cleft_options_set_integer(options, key, most) == CLEFT_OK, "an option is refused in its range");
}

// Answers whether labels may be left out.
bool set_options(const fuzz::Options& options, Bytes& bytes)
{
    for (int count = bytes.below(8); count > 0; --count)
        set_option(options, bytes);
    limit(options, CLEFT_OPTION_MAX_TETS, 1000);
    limit(options, CLEFT_OPTION_TETS, 1000);
    limit(options, CLEFT_OPTION_STEPS, 12);
    // What takes longer than all the rest, now and then only; and never eight times, as a number of tetrahedra asks
    // for.
    int64_t tets = 0;
    expect(cleft_options_get_integer(options, CLEFT_OPTION_TETS, &tets) == CLEFT_OK, "an option has no value");
    if (tets > 0 || !bytes.one_in(4))
        expect(cleft_options_set_integer(options, CLEFT_OPTION_IMPROVE, CLEFT_IMPROVE_OFF) == CLEFT_OK,
               "an option is refused in its range");
    if (bytes.one_in(4))
        static_cast<void>(cleft_options_set_label_size(options, bytes.below(4), bytes.between(0, 3)));
    const int32_t labels[2] = {bytes.below(4), bytes.below(4)};
    const bool strips = bytes.one_in(4);
    const bool keeps = bytes.one_in(8);
    expect(cleft_options_set_strip(options, labels, strips ? 2 : 0) == CLEFT_OK, "the list strip is refused");
    expect(cleft_options_set_only(options, labels, keeps ? 1 : 0) == CLEFT_OK, "the list only is refused");
    return strips || keeps;
}

void judge_report(const fuzz::Context& context, const cleft_volume* volume, const cleft_mesh* mesh)
{
    cleft_report* report = nullptr;
    expect(cleft_report_create(context, volume, mesh, &report) == CLEFT_OK, "there is no report of a mesh");
    int64_t tets = 0;
    for (int64_t row = 0; row < cleft_report_count(report); ++row) {
        cleft_label_report about{};
        about.struct_size = sizeof about;
        expect(cleft_report_label(report, row, &about) == CLEFT_OK, "a row of a report is not there");
        tets += about.tets;
    }
    expect(tets == cleft_mesh_tet_count(mesh), "a report has other tetrahedra than the mesh");
    cleft_report_destroy(report);
}

void mesh_in_one_call(const fuzz::Context& context, const cleft_volume* volume, const cleft_sizing* sizing,
                      const fuzz::Options& options, bool leaves_out)
{
    cleft_mesh* mesh = nullptr;
    if (context.succeeded(cleft_mesh_volume(context, volume, sizing, nullptr, options, &mesh))) {
        fuzz::judge_mesh(context, volume, mesh, !leaves_out);
        if (!leaves_out)
            judge_report(context, volume, mesh);
    }
    cleft_mesh_destroy(mesh);
}

void mesh_by_stages(const fuzz::Context& context, const cleft_volume* volume, const cleft_sizing* sizing,
                    const fuzz::Options& options)
{
    cleft_mesh* background = nullptr;
    cleft_mesh* cleaved = nullptr;
    cleft_mesh* improved = nullptr;
    cleft_mesh* stripped = nullptr;
    if (context.succeeded(cleft_background_create(context, sizing, options, &background)) &&
        context.succeeded(cleft_mesh_cleave(context, volume, background, options, &cleaved))) {
        fuzz::judge_mesh(context, volume, cleaved, true);
        if (context.succeeded(cleft_mesh_improve(context, volume, cleaved, options, &improved))) {
            fuzz::judge_mesh(context, volume, improved, true);
            judge_report(context, volume, improved);
            if (context.succeeded(cleft_mesh_strip(context, improved, options, &stripped)))
                fuzz::judge_mesh(context, volume, stripped, false);
        }
    }
    for (cleft_mesh* mesh : {background, cleaved, improved, stripped})
        cleft_mesh_destroy(mesh);
}

}  // namespace

int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size)
{
    Bytes bytes(data, size);
    const fuzz::Context context;
    const fuzz::Options options;
    const bool leaves_out = set_options(options, bytes);
    const bool by_stages = bytes.one_in(3);
    const bool given_sizing = bytes.one_in(3);
    const double one_size = bytes.between(0.3, 3);
    const fuzz::Grid grid = fuzz::grid_of(bytes);
    const fuzz::Volume volume(context, options, grid, bytes);
    if (!volume)
        return 0;
    cleft_sizing* sizing = nullptr;
    const bool sized = context.succeeded(given_sizing ? cleft_sizing_create_constant(context, volume, one_size, &sizing)
                                                      : cleft_sizing_create(context, volume, options, &sizing));
    // A user-supplied size may ask for more than there is time for.
    if (sized && cleft_sizing_expected_tets(sizing) < most_tets) {
        if (by_stages)
            mesh_by_stages(context, volume, sizing, options);
        else
            mesh_in_one_call(context, volume, given_sizing ? sizing : nullptr, options, leaves_out);
    }
    cleft_sizing_destroy(sizing);
    return 0;
}
