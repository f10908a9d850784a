// Reads words, numbers and binary values from a file, and says where one is wrong.
#include "io/text_scanner.hpp"

#include "base/error.hpp"
#include "io/mesh_data.hpp"
#include "io/path_kind.hpp"
#include "io/system_failure.hpp"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <limits>
#include <memory>
#include <system_error>

namespace cleft::io
{

namespace
{

// Not std::isspace(), which follows the locale of the caller's program.
bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\t' || c == '\r'; }

[[noreturn]] void cannot_read(const std::string& path, int error)
{
    throw_system_failure("cannot read '" + path + "'", error);
}

// from_chars knows no leading '+'.
std::string_view without_plus(std::string_view word)
{
    return word.size() > 1 && word[0] == '+' ? word.substr(1) : word;
}

}  // namespace

std::string read_whole_file(const std::string& path)
{
    // fopen() opens a folder for reading, and only fread() fails.
    if (is_folder(path))
        cannot_read(path, EISDIR);
    const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
    if (!file)
        cannot_read(path, errno);
    std::error_code error;
    const auto size = std::filesystem::file_size(path, error);
    // Files of /proc and pipes have no size, or a size of 0. They are read all the same, as a mesh
    // may come from a pipe.
    std::string text(error ? 0 : size, '\0');
    size_t used = 0;
    for (;;) {
        if (used == text.size())
            text.resize(used + 1);  // one byte more tells the end of the file, and lets one grow that has no size
        const size_t n = std::fread(text.data() + used, 1, text.size() - used, file.get());
        used += n;
        if (n == 0)
            break;
        if (used == text.size() && used > size)
            text.resize(2 * used);
    }
    if (std::ferror(file.get()))
        cannot_read(path, errno);
    text.resize(used);
    return text;
}

TextScanner::TextScanner(const std::string& path, char comment)
    : path_(path), text_(read_whole_file(path)), at_(text_.data()), end_(at_ + text_.size()), comment_(comment)
{
}

std::string TextScanner::place() const
{
    // Lines are counted when a message needs them and not while reading.
    const auto line = 1 + std::count(text_.data(), at_, '\n');
    return "'" + path_ + "', line " + std::to_string(line) + ": ";
}

void TextScanner::fail(const std::string& what) const { throw Error(CLEFT_ERROR_FORMAT, place() + what); }

void TextScanner::unsupported(const std::string& what) const { throw Error(CLEFT_ERROR_UNSUPPORTED, place() + what); }

void TextScanner::skip_blanks()
{
    for (; at_ < end_; ++at_) {
        if (comment_ != '\0' && *at_ == comment_)
            // A comment ends with its line. The loop then passes over the end of the line.
            at_ = std::find(at_, end_, '\n');
        if (at_ == end_ || !is_blank(*at_))
            return;
    }
}

bool TextScanner::at_end()
{
    skip_blanks();
    return at_ == end_;
}

std::string_view TextScanner::peek()
{
    skip_blanks();
    // A word may be a megabyte of binary data; messages shorten it.
    const char* stop = std::find_if(at_, end_, is_blank);
    return {at_, static_cast<size_t>(stop - at_)};
}

std::string_view TextScanner::word()
{
    const std::string_view found = peek();
    if (found.empty())
        fail("the file ends too early");
    at_ += found.size();
    return found;
}

bool TextScanner::more_on_line()
{
    const char* at = at_;
    while (at < end_ && *at != '\n' && is_blank(*at))
        ++at;
    return at < end_ && *at != '\n' && (comment_ == '\0' || *at != comment_);
}

std::string_view TextScanner::rest_of_line()
{
    const char* begin = at_;
    const char* stop = std::find(at_, end_, '\n');
    at_ = stop == end_ ? end_ : stop + 1;
    // Lines of Windows.
    if (stop > begin && stop[-1] == '\r')
        --stop;
    return {begin, static_cast<size_t>(stop - begin)};
}

void TextScanner::skip_past(const std::string& mark)
{
    // Also over binary data: they could contain the mark by chance, but a mark has nine characters
    // and more.
    const char* found = std::search(at_, end_, mark.begin(), mark.end());
    if (found == end_)
        fail(mark.substr(0, 40) + " is missing");
    at_ = found;
    skip_line();
}

double TextScanner::real()
{
    const std::string_view text = word();
    const std::string_view digits = without_plus(text);
    double value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    // A number too small for a double is as good as 0; one too large is not finite.
    if (error == std::errc::result_out_of_range)
        value = std::strtod(std::string(digits).c_str(), nullptr);
    else if (error != std::errc())
        fail("'" + std::string(text.substr(0, 40)) + "' is no number");
    if (stop != digits.data() + digits.size())
        fail("'" + std::string(text.substr(0, 40)) + "' is no number");
    if (!std::isfinite(value))
        fail("'" + std::string(text.substr(0, 40)) + "' is not finite");
    return value;
}

int64_t TextScanner::integer()
{
    const std::string_view text = word();
    const std::string_view digits = without_plus(text);
    int64_t value = 0;
    const auto [stop, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    if (error != std::errc() || stop != digits.data() + digits.size())
        fail("'" + std::string(text.substr(0, 40)) + "' is no whole number");
    return value;
}

int32_t TextScanner::label()
{
    // As a real: TetGen writes the attribute of a region as 3 or 3.0.
    const double value = real();
    if (!is_label(value))
        fail("a material must be a whole number of 32 bits");
    return static_cast<int32_t>(value);
}

void TextScanner::check_count(int64_t count, int64_t least_bytes, const char* what) const
{
    // The last item may lack its blank at the end of the file, hence + 1.
    if (count < 0 || count > (end_ - at_) / least_bytes + 1)
        fail("the file is too short for " + std::to_string(count) + " " + what);
    // The core numbers points and tetrahedra in 32 bits.
    if (count > std::numeric_limits<int32_t>::max())
        throw Error(CLEFT_ERROR_TOO_LARGE, place() + std::to_string(count) + " " + what + " are too many");
}

int64_t TextScanner::count(int64_t least_bytes, const char* what)
{
    const int64_t value = integer();
    check_count(value, least_bytes, what);
    return value;
}

int32_t TextScanner::point(int64_t base, int64_t points)
{
    const int64_t number = integer();
    // Corners are checked where they are read, so that the message has the line.
    if (number < base || number - base >= points)
        fail("there is no point " + std::to_string(number));
    return static_cast<int32_t>(number - base);
}

void TextScanner::binary(void* to, size_t bytes)
{
    if (static_cast<size_t>(end_ - at_) < bytes)
        fail("the file ends too early");
    std::memcpy(to, at_, bytes);
    at_ += bytes;
}

}  // namespace cleft::io
