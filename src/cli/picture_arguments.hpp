// The options of a picture on the command line.
#pragma once

#include "cleft/cleft_io.h"

#include <string>
#include <vector>

namespace CLI
{
class App;
}

namespace cleft_cli
{

// It must outlive the CLI::App, which writes into it while it parses.
class PictureArguments
{
public:
    void add_to(CLI::App& app);

    // Throws a usage failure that names the option. Width and height are filled in.
    cleft_io_picture make() const;
    const std::vector<int32_t>& strip() const { return strip_; }
    const std::vector<int32_t>& whole() const { return whole_; }

private:
    void add_look_to(CLI::App& app);

    std::vector<std::string> cuts_;
    std::vector<int32_t> strip_, whole_;
    std::string by_ = "label";
    std::string backdrop_ = "light";
    std::string view_, up_, range_;
    std::string size_ = "1200x900";
    double zoom_ = 1;
    double line_width_ = 1;
    bool no_edges_ = false;
    bool legend_ = false;
};

}  // namespace cleft_cli
