// Reads words and numbers from a file held in memory. Every failure is an Error that names the file and the line.
#pragma once

#include "base/error.hpp"

#include <cstdint>
#include <string>
#include <string_view>

namespace cleft::io
{

// The bytes of a file; throws Error(CLEFT_ERROR_FILE).
std::string read_whole_file(const std::string& path);

// Runs `body`, whose Errors do not name the file, and names it.
// Only Errors get the name; std::bad_alloc passes through as it is.
template <class Body>
auto naming_file(const std::string& path, const Body& body)
{
    try {
        return body();
    } catch (const Error& error) {
        throw Error(error.status(), "'" + path + "': " + error.what());
    }
}

// The whole file is in memory, so that words are views of it and cost no copy.
class TextScanner
{
public:
    // Comments run from `comment` to the end of the line; '\0': there are none.
    explicit TextScanner(const std::string& path, char comment = '\0');

    // Is there nothing but blanks (and comments) left?
    bool at_end();
    // The next word, which must be there.
    std::string_view word();
    // The next word without taking it; "" at the end.
    std::string_view peek();
    // Is the next word on the line of the last one?
    bool more_on_line();
    // The rest of the line, without its end.
    std::string_view rest_of_line();
    void skip_line() { rest_of_line(); }
    // Goes to the line behind the one that begins with `mark`, which must be there.
    void skip_past(const std::string& mark);

    // A finite number in decimal digits, whatever the locale. Fails for everything else.
    double real();
    // The whole word must be a number of 64 bits.
    int64_t integer();
    // A whole number that an int32 holds.
    int32_t label();
    // A count of things of which each takes at least `least_bytes` bytes of what is left of the file: so that no
    // damaged count makes us ask for memory that the file could never fill.
    int64_t count(int64_t least_bytes, const char* what);
    // The number of a point, in [base, base + points): from 0.
    int32_t point(int64_t base, int64_t points);

    // Copies `bytes` bytes as they are.
    void binary(void* to, size_t bytes);
    template <class T>
    T binary()
    {
        T value;
        binary(&value, sizeof value);
        return value;
    }
    // Like count(), for a count that was read by other means.
    void check_count(int64_t count, int64_t least_bytes, const char* what) const;

    [[noreturn]] void fail(const std::string& what) const;
    [[noreturn]] void unsupported(const std::string& what) const;

private:
    void skip_blanks();
    std::string place() const;

    std::string path_;
    std::string text_;
    const char* at_;
    const char* end_;
    char comment_;
};

}  // namespace cleft::io
