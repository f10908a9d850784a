// Asks the system about a terminal.
#include "terminal.hpp"

#include <sys/ioctl.h>
#include <unistd.h>

#include <charconv>
#include <cstdlib>
#include <string_view>

namespace cleft_cli
{

bool is_terminal(int descriptor) { return isatty(descriptor) == 1; }

bool redraws_lines(int descriptor)
{
    const char* const kind = std::getenv("TERM");
    return is_terminal(descriptor) && kind && *kind && std::string_view(kind) != "dumb";
}

int terminal_columns(int descriptor)
{
    winsize size{};
    // A serial line answers 0.
    if (ioctl(descriptor, TIOCGWINSZ, &size) == 0 && size.ws_col > 0)
        return size.ws_col;
    // The system before the variable: the latter stays as it was when the window changes.
    const char* const variable = std::getenv("COLUMNS");
    const std::string_view text = variable ? variable : "";
    int columns = 0;
    std::from_chars(text.data(), text.data() + text.size(), columns);
    constexpr int kUsual = 80;
    return columns > 0 ? columns : kUsual;
}

}  // namespace cleft_cli
