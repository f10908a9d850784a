// The library's options as arguments: names, ranges, defaults and texts come from its table.
#pragma once

#include "exit_code.hpp"
#include "handles.hpp"

#include <nlohmann/json_fwd.hpp>

#include <deque>
#include <string>
#include <vector>

namespace CLI
{
class App;
class Option;
}  // namespace CLI

namespace cleft_cli
{

// It must outlive the CLI::App, which writes into it while it parses.
class OptionArguments
{
public:
    // The options that any of these calls reads: see cleft_option_description.
    void add_to(CLI::App& app, const std::vector<std::string>& calls);
    // --label-size L=H, which the table cannot hold, as it belongs to a label.
    void add_label_sizes_to(CLI::App& app);
    // --strip and --only.
    void add_label_lists_to(CLI::App& app);

    // If the value of --background is no choice of the table, it is the path of a mesh: it is taken out and returned.
    std::string take_background_file();

    // Throws a usage failure that names the option.
    Options make() const;
    // Does the option stand on the command line?
    bool has(cleft_option key) const;
    // The value of each option as `options` has it, with choices by name.
    nlohmann::json as_json(const cleft_options* options) const;

    // Do the strip and only lists leave this label out?
    bool leaves_out(int32_t label) const;

private:
    struct Row {
        cleft_option_description info;
        CLI::Option* option;
        std::string text;
        bool flag;
        // Does it stand on the command line?
        bool given() const;
    };
    std::deque<Row> rows_;  // a deque: CLI11 keeps the addresses of the values
    std::vector<std::string> label_sizes_;
    std::vector<int32_t> strip_, only_;
};

// The table's row as the text of --help.
std::string option_help(const cleft_option_description& info);
// "feature_scale" as "--feature-scale".
std::string flag_name(const cleft_option_description& info);

}  // namespace cleft_cli
