// The handle of options: how values are set, checked and read, and what the stages take of them.
#include "capi/options.hpp"

#include "base/number_text.hpp"
#include "base/struct_size.hpp"
#include "capi/firewall.hpp"
#include "capi/kept_labels.hpp"
#include "sizing/compute.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstring>
#include <type_traits>

template <>
inline constexpr size_t cleft::kFirstSize<cleft_option_description> = CLEFT_END_OF(cleft_option_description, text);

namespace cleft::capi
{

namespace
{

// The choices of an option are handed to its stage by number: a build fails where the stage's enumeration and the words
// of the table drift apart.
template <class Choice>
constexpr bool is(Choice choice, int number)
{
    return static_cast<int>(choice) == number;
}
#define CLEFT_CHOICE(number, choice) static_assert(is(choice, number), #choice " is not " #number);
#include "capi/options.inc"
#undef CLEFT_CHOICE

const OptionRow& checked_row(int row, const std::string& what)
{
    if (row < 0)
        // The name comes from a command line or a script, and may hold anything.
        throw Error(CLEFT_ERROR_OPTION, "there is no option " + what);
    return kOptionTable[row];
}

// The value is checked here, where the caller sets it, so that the sentence comes at the line that is wrong.
void assign(cleft_options& options, const OptionRow& row, double value)
{
    if (!std::isfinite(value))
        throw Error(CLEFT_ERROR_NOT_FINITE, std::string(row.name) + " is NaN or infinite");
    if (row.key == CLEFT_OPTION_SURFACE_ERROR && value < 0 && value != row.least)
        throw Error(CLEFT_ERROR_OPTION, row.name + std::string(" is ") + text_of(value) + "; it must be " +
                                            text_of(row.least) + ", which takes it from the voxels, or at least 0");
    // A NaN was refused above: it would pass both comparisons.
    if (value < row.least || value > row.greatest)
        throw Error(CLEFT_ERROR_OPTION, std::string(row.name) + " is " + text_of(value) + ", which is not within " +
                                            text_of(row.least) + " to " + text_of(row.greatest));
    if (row.key == CLEFT_OPTION_DELAUNAY && static_cast<int>(value) == CLEFT_DELAUNAY_TETGEN && !cleft_has_tetgen())
        throw Error(CLEFT_ERROR_UNSUPPORTED, std::string(row.name) + " is tetgen, and this library has no TetGen");
    const auto at = &row - kOptionTable;
    options.values[at] = value;
    options.given[at] = true;
}

double choice_number(const OptionRow& row, const char* text)
{
    // Bars around both keep "low" from being found within "lowest".
    const std::string wanted = "|" + std::string(text) + "|";
    const std::string all = "|" + std::string(row.choices) + "|";
    const size_t at = all.find(wanted);
    // A bar in the text would match two choices at once.
    if (*text == '\0' || std::strchr(text, '|') || at == std::string::npos)
        throw Error(CLEFT_ERROR_OPTION, std::string(row.name) + " is " + text + ", which is none of " + row.choices);
    double number = 0;
    for (size_t i = 0; i < at; ++i)
        number += all[i] == '|';
    return number;
}

// In C notation whatever the locale of the caller's program, unlike strtod().
bool reads_number(const char* text, double& value)
{
    const char* begin = text + (text[0] == '+' && text[1] != '-' ? 1 : 0);  // from_chars() knows no leading '+'
    const char* end = text + std::strlen(text);
    const auto result = std::from_chars(begin, end, value);
    // All of the text: "1,5" must not become 1.
    return result.ec == std::errc() && result.ptr == end;
}

double parsed(const OptionRow& row, const char* text)
{
    if (row.type == CLEFT_OPTION_TYPE_CHOICE)
        return choice_number(row, text);
    if (row.type == CLEFT_OPTION_TYPE_FLAG && !std::strcmp(text, "true"))
        return 1;
    if (row.type == CLEFT_OPTION_TYPE_FLAG && !std::strcmp(text, "false"))
        return 0;
    double value = 0;
    const bool is_number = reads_number(text, value);
    if (row.type == CLEFT_OPTION_TYPE_FLAG && !is_number)
        throw Error(CLEFT_ERROR_OPTION, std::string(row.name) + " is neither true nor false: " + text);
    if (!is_number)
        throw Error(CLEFT_ERROR_OPTION, std::string(row.name) + " is not a number: " + text);
    if (row.type != CLEFT_OPTION_TYPE_REAL && value != std::floor(value))
        throw Error(CLEFT_ERROR_OPTION, std::string(row.name) + " is not a whole number: " + text);
    return value;
}

// The value of an option into the field of a stage, whose type it has: a number, a flag or a choice.
// One number per option crosses the interface, so the types of the stages are known here alone.
template <class Field>
void take(Field& field, double value)
{
    // The type of the field decides; a new option needs no line here.
    if constexpr (std::is_same_v<Field, bool>)
        field = value != 0;
    else if constexpr (std::is_enum_v<Field>)
        field = static_cast<Field>(static_cast<int>(value));
    else
        field = static_cast<Field>(value);
}

void set_labels(Array<UserLabel>& list, const int32_t* labels, int64_t count)
{
    if (count < 0)
        throw Error(CLEFT_ERROR_ARGUMENT, "count is " + std::to_string(count) + "; it must not be negative");
    if (count > 0)
        required(labels, "labels");
    // A count of 0 takes the list away, whatever the pointer is.
    list = user_labels(labels, count);
}

// In world units. Below 0 there is one value alone, see assign(): the description of the option says what it stands
// for.
double surface_error(double given, const Grid& grid)
{
    constexpr double kShareOfVoxel = 0.5;
    return given < 0 ? kShareOfVoxel * grid.spacing.minCoeff() : given;
}

// By material, as the stages know the labels. A label that the volume does not have is told of by
// warn_of_unknown_sizes().
Array<double> material_sizes(const Array<UserLabel>& labels, const cleft_options* options)
{
    if (!options || options->label_sizes.empty())
        return {};
    Array<double> sizes(labels.size(), 0.0);
    for (const auto& [label, size] : options->label_sizes) {
        check_size("the size of " + name_of(label), size);
        const auto found = std::find(labels.begin(), labels.end(), label);
        if (found != labels.end())
            sizes[found - labels.begin()] = size;
    }
    return sizes;
}

// Shapes are to be good in the world. Where the affine shears, its angles are not those of the frame of the voxels, so
// a metric tells the stages what they are (decision 31).
void measure_in_world(PipelineOptions& out, const Frame& frame)
{
    // The cosine between two axes, at which angles differ by 0.006 degrees: what headers round is no shear.
    constexpr double kSheared = 1e-4;
    // Of lengths in the metric, the greatest over the least. At 37 degrees of shear it is 2; at 45, the work on shapes
    // takes 9 times as long as without shear, and at 60 more than 70 times.
    constexpr double kGreatestStretch = 2;
    const Mat3 products = frame.linear.transpose() * frame.linear;
    if ((products - Mat3::Identity()).cwiseAbs().maxCoeff() < kSheared)
        return;
    const Tensor log_of_world = log(to_tensor(products));
    const Vec3 logs = eigenvalues(log_of_world);
    const double share = std::min(1.0, 2 * std::log(kGreatestStretch) / (logs[2] - logs[0]));
    const Vec3 extent = frame.grid.extent();
    out.of_world = std::make_shared<const MetricField>(constant_metric(log_of_world, extent));
    out.towards_world = std::make_shared<const MetricField>(constant_metric(share * log_of_world, extent));
    out.cleave.metric = out.towards_world.get();
}

}  // namespace

double option_value(const cleft_options* options, cleft_option key)
{
    const int row = option_row(key);
    // NULL stands for all defaults: most first programs set nothing.
    return options ? options->values[row] : kOptionTable[row].value;
}

PipelineOptions pipeline_options(const cleft_options* options)
{
    if (options)
        checked(options, "options");
    PipelineOptions out;
#define CLEFT_OPTION_FIELD(key, field) take(out.field, option_value(options, key));
#include "capi/options.inc"
#undef CLEFT_OPTION_FIELD
    check_size_range(out.sizing);
    // A wanted number is explicit and max_tets a precaution, so the number wins.
    out.sizing.max_tets = out.tets > 0 ? 0 : out.max_tets;
    // A size that was given for all places is meant, and a lattice keeps it. One that features ask for may be raised.
    out.background.lattice = {out.sizing.max_tets, out.sizing.size > 0 || out.sizing.size_min > 0};
    return out;
}

PipelineOptions pipeline_options(const cleft_options* options, const Frame& frame)
{
    PipelineOptions out = pipeline_options(options);
    measure_in_world(out, frame);
    return out;
}

PipelineOptions pipeline_options(const cleft_options* options, const Frame& frame, const Array<UserLabel>& labels)
{
    PipelineOptions out = pipeline_options(options, frame);
    out.kept = kept_labels(labels, options, "volume");
    out.sizing.material_sizes = material_sizes(labels, options);
    out.asks_surface_error =
        options && options->given[option_row(CLEFT_OPTION_SURFACE_ERROR)] && out.sizing.surface_error > 0;
    out.sizing.surface_error = surface_error(out.sizing.surface_error, frame.grid);
    return out;
}

PipelineOptions pipeline_options(const cleft_options* options, const cleft_volume& volume)
{
    return pipeline_options(options, volume.frame, volume.volume.labels());
}

void warn_of_unknown_sizes(const Array<UserLabel>& labels, const cleft_options* options, const Run& run)
{
    if (!options)
        return;
    for (const auto& row : options->label_sizes)
        // A warning, not an error: one list of sizes may serve several volumes.
        if (std::find(labels.begin(), labels.end(), row.first) == labels.end())
            run.warn("a size is given for " + name_of(row.first) + ", which the volume does not have");
}

void warn_of_unused_smooth(const Volume& volume, const cleft_options* options, const Run& run)
{
    // Only what the caller set: the default of an option that is not read is no mistake.
    if (!options || !options->given[option_row(CLEFT_OPTION_SMOOTH)])
        return;
    const int asked = static_cast<int>(option_value(options, CLEFT_OPTION_SMOOTH));
    if (!volume.is_label_map())
        run.warn("smooth has no effect on a volume of indicator functions");
    else if (asked != volume.kernel_width())
        run.warn("smooth is " + std::to_string(asked) + " and has no effect: the volume was made with " +
                 std::to_string(volume.kernel_width()));
}

}  // namespace cleft::capi

using namespace cleft::capi;

int32_t cleft_option_count(void) noexcept { return static_cast<int32_t>(kOptionCount); }

cleft_status cleft_option_info(int32_t index, cleft_option_description* out) noexcept
{
    return guarded(nullptr, [&] {
        cleft::check_struct_size(*required(out, "out"), "cleft_option_description");
        if (index < 0 || index >= cleft_option_count())
            throw cleft::Error(CLEFT_ERROR_ARGUMENT, "there is no such row");
        const OptionRow& row = kOptionTable[index];
        cleft::copy_out({0, row.key, row.type, row.name, row.value, row.least, row.greatest, row.choices, row.text,
                         row.group, row.calls},
                        *out);
    });
}

cleft_status cleft_options_create(cleft_options** out) noexcept
{
    return guarded(nullptr, [&] {
        required(out, "out");
        *out = new cleft_options;
        for (size_t i = 0; i < kOptionCount; ++i)
            // All values are set from the beginning, so that reading one never depends on what was set before.
            (*out)->values[i] = kOptionTable[i].value;
    });
}

void cleft_options_destroy(cleft_options* options) noexcept { destroy(options); }

const char* cleft_options_last_error(const cleft_options* options) noexcept
{
    return is_sound(options) ? options->message.data() : "";
}

cleft_status cleft_options_set_integer(cleft_options* options, cleft_option key, int64_t value) noexcept
{
    return guarded(message_of(options), [&] {
        const OptionRow& row = checked_row(option_row(key), std::to_string(key));
        if (row.type == CLEFT_OPTION_TYPE_REAL)
            throw cleft::Error(CLEFT_ERROR_OPTION,
                               std::string(row.name) + " is a real option, not an integer, choice or flag");
        assign(checked(options, "options"), row, static_cast<double>(value));
    });
}

cleft_status cleft_options_set_real(cleft_options* options, cleft_option key, double value) noexcept
{
    return guarded(message_of(options), [&] {
        const OptionRow& row = checked_row(option_row(key), std::to_string(key));
        if (row.type != CLEFT_OPTION_TYPE_REAL)
            throw cleft::Error(CLEFT_ERROR_OPTION,
                               std::string(row.name) + " is an integer, choice or flag, not a real option");
        assign(checked(options, "options"), row, value);
    });
}

cleft_status cleft_options_set_text(cleft_options* options, const char* name, const char* value) noexcept
{
    return guarded(message_of(options), [&] {
        required(name, "name");
        const OptionRow& row = checked_row(option_row(name), name);
        assign(checked(options, "options"), row, parsed(row, required(value, "value")));
    });
}

cleft_status cleft_options_get_integer(const cleft_options* options, cleft_option key, int64_t* value) noexcept
{
    return guarded(nullptr, [&] {
        // Throws for keys of a newer header, of which this library has no value.
        checked_row(option_row(key), std::to_string(key));
        *required(value, "value") = static_cast<int64_t>(option_value(&checked(options, "options"), key));
    });
}

cleft_status cleft_options_get_real(const cleft_options* options, cleft_option key, double* value) noexcept
{
    return guarded(nullptr, [&] {
        checked_row(option_row(key), std::to_string(key));
        // The value of any type, so that a caller can show all options in one loop.
        *required(value, "value") = option_value(&checked(options, "options"), key);
    });
}

cleft_status cleft_options_set_label_size(cleft_options* options, int32_t label, double size) noexcept
{
    return guarded(message_of(options), [&] {
        auto& sizes = checked(options, "options").label_sizes;
        if (!std::isfinite(size))
            throw cleft::Error(CLEFT_ERROR_NOT_FINITE,
                               "the size of label " + std::to_string(label) + " is NaN or infinite");
        if (size < 0)
            throw cleft::Error(CLEFT_ERROR_OPTION, "the size of label " + std::to_string(label) + " is " +
                                                       cleft::text_of(size) + "; it must not be negative");
        // One entry per label, the last one set; 0 takes it away.
        const cleft::UserLabel of{label};
        sizes.erase(std::remove_if(sizes.begin(), sizes.end(), [&](const auto& row) { return row.first == of; }),
                    sizes.end());
        if (size > 0)
            sizes.emplace_back(of, size);
    });
}

cleft_status cleft_options_set_strip(cleft_options* options, const int32_t* labels, int64_t count) noexcept
{
    return guarded(message_of(options), [&] { set_labels(checked(options, "options").strip, labels, count); });
}

cleft_status cleft_options_set_only(cleft_options* options, const int32_t* labels, int64_t count) noexcept
{
    return guarded(message_of(options), [&] { set_labels(checked(options, "options").only, labels, count); });
}
