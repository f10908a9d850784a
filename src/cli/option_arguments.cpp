// Makes arguments of the library's table of options: an option that is added to the table appears
// in the command by itself.
#include "option_arguments.hpp"

#include "text.hpp"

#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <stdexcept>

namespace cleft_cli
{
namespace
{

/* <lists> Made by tools/generate.py from src/capi/options.toml. */
constexpr const char* kLabelSizesText = "Greatest wanted edge lengths inside single labels, in world units";
constexpr const char* kStripText = "Labels whose tetrahedra the finished mesh leaves out";
constexpr const char* kOnlyText = "Labels whose tetrahedra alone the finished mesh keeps. None: all";
/* </lists> */

// "--interface-size NAME" in help: what stands for the value.
std::string value_name(const cleft_option_description& info)
{
    switch (info.type) {
        case CLEFT_OPTION_TYPE_CHOICE:
            return info.choices;
        case CLEFT_OPTION_TYPE_INTEGER:
            return "N";
        default:
            return "X";
    }
}

// Is a name one of "a|b|c"?
bool is_one_of(const std::string& names, const std::string& name)
{
    // The bars keep "lat" from matching "lattice".
    return ("|" + names + "|").find("|" + name + "|") != std::string::npos;
}

// The table of options, in its order.
std::vector<cleft_option_description> table()
{
    std::vector<cleft_option_description> rows(static_cast<std::size_t>(cleft_option_count()));
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i].struct_size = sizeof rows[i];
        if (cleft_option_info(static_cast<int32_t>(i), &rows[i]) != CLEFT_OK)
            // cleft_option_count() and cleft_option_info() would contradict each other.
            throw std::logic_error("the table of options has no row " + std::to_string(i));
    }
    return rows;
}

// The headings of help, in the order in which the table names them.
std::vector<std::string> groups_of(const std::vector<cleft_option_description>& rows)
{
    std::vector<std::string> groups;
    for (const cleft_option_description& info : rows)
        if (std::find(groups.begin(), groups.end(), info.group) == groups.end())
            groups.emplace_back(info.group);
    return groups;
}

const char* group_of(cleft_option key)
{
    for (const cleft_option_description& info : table())
        if (info.key == key)
            return info.group;
    return "";
}

// The name of choice number `index` of "a|b|c".
std::string choice_name(const std::string& choices, int64_t index)
{
    std::size_t begin = 0;
    // A number beyond the list would come back to the first name, as npos + 1 is 0. The library
    // never gives one.
    for (; index > 0 && begin != std::string::npos; --index)
        begin = choices.find('|', begin) + 1;
    return choices.substr(begin, choices.find('|', begin) - begin);
}

std::string range_text(const cleft_option_description& info)
{
    // Beyond it, the bound is there to have one, and tells the user nothing.
    const double huge = 1e15;
    if (info.greatest >= huge)
        return "at least " + significant(info.least);
    return significant(info.least) + " .. " + significant(info.greatest, 10);
}

// Whether the library took a value. The sentence about one that it refuses would be wrong for a want of memory.
bool is_taken(cleft_status status)
{
    if (status == CLEFT_ERROR_OUT_OF_MEMORY)
        throw std::bad_alloc();
    return status == CLEFT_OK;
}

void set_label_size(cleft_options* options, const std::string& assignment)
{
    const std::size_t equals = assignment.find('=');
    int32_t label = 0;
    double size = 0;
    // lexical_cast() takes the whole word or fails, so that "3=0.5x" is a mistake.
    if (equals == std::string::npos || !CLI::detail::lexical_cast(assignment.substr(0, equals), label) ||
        !CLI::detail::lexical_cast(assignment.substr(equals + 1), size))
        throw usage_failure("--label-size: '" + assignment + "' is not of the form LABEL=SIZE");
    // 0 takes a limit back in the library. On the command line there is none to take back; !(size >
    // 0) also catches NaN.
    if (!(size > 0) || !is_taken(cleft_options_set_label_size(options, label, size)))
        throw usage_failure("--label-size: '" + assignment + "': the size must be a positive number");
}

}  // namespace

std::string flag_name(const cleft_option_description& info)
{
    std::string name = info.name;
    // The table has names of C; options of commands have dashes.
    std::replace(name.begin(), name.end(), '_', '-');
    return "--" + name;
}

std::string option_help(const cleft_option_description& info)
{
    std::string help = info.text;
    // The choices themselves stand behind the option as its type.
    if (info.type == CLEFT_OPTION_TYPE_CHOICE)
        help += " (default " + choice_name(info.choices, std::llround(info.value)) + ")";
    else if (info.type != CLEFT_OPTION_TYPE_FLAG)
        help += " (" + range_text(info) + "; default " + significant(info.value, 10) + ")";
    help.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(help.front())));
    // 66 and the 32 columns of names stay below 100.
    return wrapped(help, 66);
}

void OptionArguments::add_to(CLI::App& app, const std::vector<std::string>& calls)
{
    const auto is_read = [&](const cleft_option_description& info) {
        return std::any_of(calls.begin(), calls.end(),
                           [&](const std::string& call) { return is_one_of(info.calls, call); });
    };
    const std::vector<cleft_option_description> rows = table();
    for (const std::string& group : groups_of(rows))
        for (const cleft_option_description& info : rows) {
            // An option that no call of this command reads would be accepted and ignored, so it is
            // not offered.
            if (info.group != group || !is_read(info))
                continue;
            // Text and not a number: the library reads it, with its own rules and messages for all
            // languages.
            Row& row = rows_.emplace_back(Row{info, nullptr, {}, false});
            if (info.type == CLEFT_OPTION_TYPE_FLAG)
                row.option = app.add_flag(flag_name(info), row.flag, option_help(info));
            else
                row.option = app.add_option(flag_name(info), row.text, option_help(info))->type_name(value_name(info));
            row.option->group(group);
        }
}

void OptionArguments::add_label_sizes_to(CLI::App& app)
{
    app.add_option("--label-size", label_sizes_,
                   std::string(kLabelSizesText) + ":\n--label-size 3=0.5 --label-size 7=0.8")
        // One value for each --label-size: without it CLI11 would take the inputs behind it for
        // more values.
        ->allow_extra_args(false)
        ->type_name("L=H")
        ->group(group_of(CLEFT_OPTION_SIZE));
}

void OptionArguments::add_label_lists_to(CLI::App& app)
{
    const char* group = "Labels";
    app.add_option("--strip", strip_, std::string(kStripText) + ":\n--strip 0, --strip 0,4 or --strip 0 4")
        ->delimiter(',')
        // join_label_lists() has put the words of a list together before.
        ->allow_extra_args(false)
        ->type_name("LABEL")
        ->group(group);
    app.add_option("--only", only_, kOnlyText)
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("LABEL")
        ->group(group);
}

std::string OptionArguments::take_background_file()
{
    for (Row& row : rows_)
        if (row.info.key == CLEFT_OPTION_BACKGROUND && row.given() && !is_one_of(row.info.choices, row.text)) {
            const std::string path = row.text;
            // The row goes back to its default, so that make() does not see the path.
            row.text = choice_name(row.info.choices, std::llround(row.info.value));
            if (!CLI::ExistingFile(path).empty())
                throw usage_failure("--background: '" + path + "' is none of " + row.info.choices +
                                    ", and there is no such file");
            return path;
        }
    return {};
}

Options OptionArguments::make() const
{
    cleft_options* handle = nullptr;
    if (cleft_options_create(&handle) != CLEFT_OK)
        throw std::bad_alloc();
    Options options(handle);
    for (const Row& row : rows_) {
        // A flag has no text of its own: that it was given is its value.
        const std::string value = row.info.type == CLEFT_OPTION_TYPE_FLAG ? "true" : row.text;
        // What is not given keeps the default of the library.
        if (row.given() && !is_taken(cleft_options_set_text(handle, row.info.name, value.c_str())))
            throw usage_failure(flag_name(row.info) + ": '" + row.text + "' is not " +
                                (row.info.type == CLEFT_OPTION_TYPE_CHOICE
                                     ? "one of " + std::string(row.info.choices)
                                     : "a number in its range (" + range_text(row.info) + ")"));
    }
    for (const std::string& assignment : label_sizes_)
        set_label_size(handle, assignment);
    const auto list = [](const std::vector<int32_t>& labels) { return static_cast<int64_t>(labels.size()); };
    if (cleft_options_set_strip(handle, strip_.data(), list(strip_)) != CLEFT_OK ||
        cleft_options_set_only(handle, only_.data(), list(only_)) != CLEFT_OK)
        throw std::bad_alloc();
    return options;
}

nlohmann::json OptionArguments::as_json(const cleft_options* options) const
{
    // All options with the values that the run used, so that a report is enough to repeat it.
    nlohmann::json json = nlohmann::json::object();
    for (const Row& row : rows_) {
        int64_t integer = 0;
        double real = 0;
        if (row.info.type == CLEFT_OPTION_TYPE_REAL) {
            if (cleft_options_get_real(options, row.info.key, &real) == CLEFT_OK)
                json[row.info.name] = real;
        } else if (cleft_options_get_integer(options, row.info.key, &integer) == CLEFT_OK) {
            if (row.info.type == CLEFT_OPTION_TYPE_CHOICE)
                json[row.info.name] = choice_name(row.info.choices, integer);
            else if (row.info.type == CLEFT_OPTION_TYPE_FLAG)
                json[row.info.name] = integer != 0;
            else
                json[row.info.name] = integer;
        }
    }
    json["label_sizes"] = label_sizes_;
    json["strip"] = strip_;
    json["only"] = only_;
    return json;
}

bool OptionArguments::Row::given() const { return option->count() > 0; }

bool OptionArguments::has(cleft_option key) const
{
    return std::any_of(rows_.begin(), rows_.end(), [&](const Row& row) { return row.info.key == key && row.given(); });
}

bool OptionArguments::leaves_out(int32_t label) const
{
    const auto holds = [label](const std::vector<int32_t>& list) {
        return std::find(list.begin(), list.end(), label) != list.end();
    };
    // An empty list of --only keeps everything.
    return holds(strip_) || (!only_.empty() && !holds(only_));
}

}  // namespace cleft_cli
