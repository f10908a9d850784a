// Reads the options of a picture, and says which of them cannot be.
#include "picture_arguments.hpp"

#include "exit_code.hpp"
#include "number_checks.hpp"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <cmath>

namespace cleft_cli
{
namespace
{

// The names stand in the order of their numbers.
const std::vector<std::string> kColourings = {"label", "angle", "ratio", "size"};
const std::vector<std::string> kBackdrops = {"light", "dark", "none"};
// The greatest that the file component takes.
constexpr double kMostZoom = 50;
constexpr double kMostLineWidth = 100;

int32_t number_of(const std::string& name, const std::vector<std::string>& names)
{
    return static_cast<int32_t>(std::find(names.begin(), names.end(), name) - names.begin());
}

std::vector<std::string> parts_of(const std::string& text, char separator)
{
    std::vector<std::string> parts{""};
    for (const char c : text) {
        if (c == separator)
            parts.emplace_back();
        else
            parts.back() += c;
    }
    return parts;
}

// Finite numbers between commas, as many as there is room for. "" leaves them as they are.
template <std::size_t N>
void read_numbers(const char* option, const char* form, const std::string& text, double (&numbers)[N])
{
    if (text.empty())
        return;
    const std::vector<std::string> parts = parts_of(text, ',');
    bool is_right = parts.size() == N;
    for (std::size_t i = 0; is_right && i < N; ++i)
        is_right = CLI::detail::lexical_cast(parts[i], numbers[i]) && std::isfinite(numbers[i]);
    if (!is_right)
        throw usage_failure(std::string(option) + ": '" + text + "' is not of the form " + form);
}

// "" leaves the default, which the zeros stand for.
void read_direction(const char* option, const std::string& text, double (&direction)[3])
{
    read_numbers(option, "X,Y,Z", text, direction);
    if (!text.empty() && std::all_of(direction, direction + 3, [](double x) { return x == 0; }))
        throw usage_failure(std::string(option) + ": '" + text + "' is no direction; one of the numbers must not be 0");
}

// Of the measure that gives the colour.
void read_range(const std::string& text, const std::string& by, double (&range)[2])
{
    read_numbers("--range", "LOW,HIGH", text, range);
    if (text.empty())
        return;
    if (by == kColourings.front())
        throw usage_failure("--range: colours of labels have no range; it needs --by angle, --by ratio or --by size");
    if (!(range[0] < range[1]))
        throw usage_failure("--range: '" + text + "': LOW must be less than HIGH");
}

// "x=0.5".
void read_cut(const std::string& text, double (&cut)[3])
{
    const std::string axes = "xyz";
    const std::size_t axis = text.empty() ? std::string::npos : axes.find(text[0]);
    double share = 0;
    if (axis == std::string::npos || text.substr(1, 1) != "=" || !CLI::detail::lexical_cast(text.substr(2), share))
        throw usage_failure("--cut: '" + text + "' is not of the form AXIS=SHARE, where AXIS is x, y or z");
    if (!(share >= 0 && share <= 1))
        throw usage_failure("--cut: '" + text + "': the share of the box must be 0 to 1");
    if (cut[axis] != 0)
        throw usage_failure("--cut: " + axes.substr(axis, 1) + " has two cuts");
    cut[axis] = share;
}

// "1200x900".
void read_size(const std::string& text, cleft_io_picture& picture)
{
    constexpr int32_t kGreatest = 8192;
    const std::vector<std::string> parts = parts_of(text, 'x');
    if (parts.size() != 2 || !CLI::detail::lexical_cast(parts[0], picture.width) ||
        !CLI::detail::lexical_cast(parts[1], picture.height) || std::min(picture.width, picture.height) < 1 ||
        std::max(picture.width, picture.height) > kGreatest)
        throw usage_failure("--size: '" + text + "' is not of the form WIDTHxHEIGHT, both 1 to " +
                            std::to_string(kGreatest));
}

}  // namespace

void PictureArguments::add_to(CLI::App& app)
{
    const char* group = "What is shown";
    app.add_option("--cut", cuts_,
                   "Take away whole tetrahedra in front of a plane across an axis, at a\n"
                   "share of the box: --cut x=0.5. Several cuts take a corner away:\n"
                   "--cut x=0.5,y=0.5,z=0.5. The side of the eye is taken")
        ->delimiter(',')
        ->allow_extra_args(false)
        ->type_name("AXIS=SHARE")
        ->group(group);
    const auto add_list = [&](const char* name, std::vector<int32_t>& list, const char* text) {
        app.add_option(name, list, text)->delimiter(',')->allow_extra_args(false)->type_name("LABEL")->group(group);
    };
    add_list("--strip", strip_, "Labels that are not drawn: --strip 0, --strip 0,4 or --strip 0 4");
    add_list("--whole", whole_, "Labels that are not cut");
    app.add_option("--by", by_,
                   "What gives the colour: the label, the least dihedral angle (0 to 70\n"
                   "degrees), the radius ratio (1 to 4) or the mean edge (default label)")
        ->check(CLI::IsMember(kColourings).description(""))
        ->type_name("label|angle|ratio|size")
        ->group(group);
    app.add_option("--range", range_, "Measures at the ends of the colours, instead of those above")
        ->type_name("LOW,HIGH")
        ->group(group);
    add_look_to(app);
}

void PictureArguments::add_look_to(CLI::App& app)
{
    const char* group = "How it looks";
    app.add_option("--view", view_, "Direction from the mesh to the eye (default -0.5,-1,0.6)")
        ->type_name("X,Y,Z")
        ->group(group);
    app.add_option("--up", up_, "Direction that is upwards (default 0,0,1)")->type_name("X,Y,Z")->group(group);
    app.add_option("--zoom", zoom_, "How much larger than to fill the picture (default 1)")
        ->check(number_above_zero(kMostZoom))
        ->type_name("X")
        ->group(group);
    app.add_option("--size", size_, "Width and height in pixels (default 1200x900)")
        ->type_name("WIDTHxHEIGHT")
        ->group(group);
    app.add_option("--line-width", line_width_,
                   "Width of the edges in pixels. Those of small triangles are paler\n"
                   "(default 1)")
        ->check(number_above_zero(kMostLineWidth))
        ->type_name("X")
        ->group(group);
    app.add_flag("--no-edges", no_edges_, "Do not draw the edges of the tetrahedra")->group(group);
    app.add_flag("--legend", legend_, "Explain the colours at the right")->group(group);
    app.add_option("--background", backdrop_, "White, nearly black or transparent (default light)")
        ->check(CLI::IsMember(kBackdrops).description(""))
        ->type_name("light|dark|none")
        ->group(group);
}

cleft_io_picture PictureArguments::make() const
{
    cleft_io_picture picture{};
    picture.struct_size = sizeof picture;
    picture.by = number_of(by_, kColourings);
    picture.backdrop = number_of(backdrop_, kBackdrops);
    picture.no_edges = no_edges_ ? 1 : 0;
    picture.legend = legend_ ? 1 : 0;
    picture.zoom = zoom_;
    picture.line_width = line_width_;
    for (const std::string& cut : cuts_)
        read_cut(cut, picture.cut);
    read_direction("--view", view_, picture.view);
    read_direction("--up", up_, picture.up);
    read_range(range_, by_, picture.range);
    read_size(size_, picture);
    return picture;
}

}  // namespace cleft_cli
