// Opens TIFF files by libtiff with handlers of their own, so that nothing is printed and no other user of libtiff in
// the process is disturbed.
#include "io/tiff_file.hpp"

#include "base/error.hpp"

#include <array>
#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace cleft::io
{

namespace
{

std::string formatted(const char* format, std::va_list arguments)
{
    std::array<char, 400> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    std::string sentence = text.data();
    return sentence.substr(0, sentence.find_last_not_of(". \n") + 1);
}

// Called from C, so that no exception may leave. The answer 1: the message is dealt with.
int keep_error(::TIFF*, void* messages, const char*, const char* format, std::va_list arguments) noexcept
{
    std::string& kept = static_cast<TiffMessages*>(messages)->error;
    if (kept.empty())
        kept = formatted(format, arguments);
    return 1;
}

// Tags that libtiff does not know, and their order, say nothing of the voxels. Old LZW is read as it should be.
bool is_harmless(const std::string& warning)
{
    for (const char* words : {"Unknown field with tag", "not sorted in ascending order", "Old-style LZW"})
        if (warning.find(words) != std::string::npos)
            return true;
    return false;
}

int keep_warning(::TIFF*, void* messages, const char*, const char* format, std::va_list arguments) noexcept
{
    std::string& kept = static_cast<TiffMessages*>(messages)->warning;
    const std::string text = formatted(format, arguments);
    if (kept.empty() && !is_harmless(text))
        kept = text;
    return 1;
}

}  // namespace

TiffFile::TiffFile(const std::string& path, uint64_t most_bytes) : messages_(std::make_unique<TiffMessages>())
{
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    if (!options)
        throw std::bad_alloc();
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(most_bytes));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_error, messages_.get());
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_warning, messages_.get());
    // m: not mapped into memory, where a file that shrinks ends the process. c: strips as the file has them.
    handle_.reset(TIFFOpenExt(path.c_str(), "rmc", options.get()));
    if (!handle_)
        throw Error(CLEFT_ERROR_FORMAT, "it cannot be opened: " + messages_->error);
}

TiffMessages TiffFile::take_messages()
{
    TiffMessages taken = *messages_;
    *messages_ = {};
    return taken;
}

void TiffFile::next_page(const std::string& page)
{
    if (!TIFFReadDirectory(handle()))
        throw Error(CLEFT_ERROR_FORMAT, page + " cannot be read: " + messages_->error);
}

void TiffFile::first_page()
{
    if (!TIFFSetDirectory(handle(), 0))
        throw Error(CLEFT_ERROR_FORMAT, "the 1st page cannot be read: " + messages_->error);
}

}  // namespace cleft::io
