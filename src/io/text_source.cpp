// Headers of text with data behind them, read in one pass.
#include "io/text_source.hpp"

#include "base/error.hpp"

#include <algorithm>
#include <cstring>

namespace cleft::io
{

namespace
{

constexpr size_t kTextBufferBytes = size_t{1} << 16;  // pieces that fit the cache of a core
// 16 MB: NRRD may have all sizes, names of files or comments in one line. A binary file may have no line end at all.
constexpr size_t kLongestLine = size_t{1} << 24;
// Keywords and numbers have some tens of characters.
constexpr size_t kLongestWord = 1024;

// An int, as -1 stands for the end of the file. Not std::isspace(), which follows the locale.
bool is_blank(int c) { return c == ' ' || (c >= '\t' && c <= '\r'); }

}  // namespace

TextSource::TextSource(const std::string& path) : source_(path, Coding::plain), buffer_(kTextBufferBytes)
{
    // position_ counts the mark, too: it is a place in the file.
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    peek_byte();
    if (filled_ >= kMark.size() && std::string_view(buffer_.data(), kMark.size()) == kMark)
        position_ = at_ = kMark.size();
}

int TextSource::peek_byte()
{
    if (at_ == filled_) {
        filled_ = source_.read_some(buffer_.data(), buffer_.size());
        at_ = 0;
    }
    return at_ < filled_ ? static_cast<unsigned char>(buffer_[at_]) : -1;
}

int TextSource::next_byte()
{
    const int byte = peek_byte();
    if (byte >= 0) {
        ++at_;
        ++position_;
    }
    return byte;
}

bool TextSource::next_line(std::string& line)
{
    line.clear();
    int byte = next_byte();
    if (byte < 0)
        return false;
    for (; byte >= 0 && byte != '\n'; byte = next_byte()) {
        // push_back() would otherwise fill the memory with a binary file.
        if (line.size() == kLongestLine)
            throw Error(CLEFT_ERROR_FORMAT, "a line of its header has no end");
        line.push_back(static_cast<char>(byte));
    }
    if (!line.empty() && line.back() == '\r')
        line.pop_back();
    return true;
}

void TextSource::skip_blanks()
{
    while (is_blank(peek_byte()))
        next_byte();
}

std::string_view TextSource::peek()
{
    // A peeked word is taken from the bytes already, so position_ is behind it.
    if (!peeked_) {
        skip_blanks();
        word_.clear();
        for (int byte = peek_byte(); byte >= 0 && !is_blank(byte); byte = peek_byte()) {
            if (word_.size() == kLongestWord)
                throw Error(CLEFT_ERROR_FORMAT, "there is no end to '" + word_.substr(0, 20) + "...'");
            word_.push_back(static_cast<char>(next_byte()));
        }
        peeked_ = true;
    }
    return word_;
}

std::string_view TextSource::word()
{
    peek();
    peeked_ = false;
    return word_;
}

bool TextSource::next_is(std::string_view text)
{
    if (filled_ - at_ < text.size()) {
        // The text may lie over the end of the buffer.
        std::memmove(buffer_.data(), buffer_.data() + at_, filled_ - at_);
        filled_ -= at_;
        at_ = 0;
        filled_ += source_.read_some(buffer_.data() + filled_, buffer_.size() - filled_);
    }
    return std::string_view(buffer_.data() + at_, filled_ - at_).substr(0, text.size()) == text;
}

bool TextSource::rest_is_blank()
{
    int byte = next_byte();
    bool blank = true;
    for (; byte >= 0 && byte != '\n'; byte = next_byte())
        blank = blank && is_blank(byte);
    return blank;
}

void TextSource::read(void* to, size_t bytes)
{
    // What the buffer holds comes first; the rest goes straight to its place, without a second
    // copy.
    const size_t held = std::min(bytes, filled_ - at_);
    std::memcpy(to, buffer_.data() + at_, held);
    at_ += held;
    source_.read(static_cast<char*>(to) + held, bytes - held);
    position_ += bytes;
}

void TextSource::skip(uintmax_t bytes)
{
    const auto held = static_cast<size_t>(std::min<uintmax_t>(bytes, filled_ - at_));
    at_ += held;
    source_.skip(bytes - held);
    position_ += bytes;
}

void TextSource::expect(uintmax_t bytes) const
{
    const uintmax_t held = filled_ - at_;
    if (bytes > held)
        source_.expect(bytes - held);
}

}  // namespace cleft::io
