// A file whose header is text, and whose data may be binary: lines, words and bytes of it in order.
#pragma once

#include "io/byte_source.hpp"

#include <string>
#include <string_view>
#include <vector>

namespace cleft::io
{

// Lines and words are read through a buffer. read() and skip() continue where the last line or word
// ended.
class TextSource
{
public:
    // A mark of UTF-8 at the beginning is passed over.
    explicit TextSource(const std::string& path);

    // The next line without its end (of Unix or Windows); false at the end of the file.
    bool next_line(std::string& line);
    // The next word, over ends of lines; "" at the end. It lives until the next call.
    std::string_view word();
    // The next word without taking it.
    std::string_view peek();
    // Are these the next bytes? They are not taken.
    bool next_is(std::string_view text);
    // Passes over the rest of the line, which must be blank.
    bool rest_is_blank();
    // All bytes or an Error. A word that was peeked at counts as taken.
    void read(void* to, size_t bytes);
    void skip(uintmax_t bytes);
    // Throws if so many bytes are not left.
    void expect(uintmax_t bytes) const;
    // How far the file was read, and how much of it is left.
    uintmax_t position() const { return position_; }
    uintmax_t left() const { return source_.left() + (filled_ - at_); }

private:
    int peek_byte();
    int next_byte();
    void skip_blanks();

    ByteSource source_;
    std::vector<char> buffer_;
    size_t at_ = 0;
    size_t filled_ = 0;
    uintmax_t position_ = 0;
    std::string word_;
    bool peeked_ = false;
};

}  // namespace cleft::io
