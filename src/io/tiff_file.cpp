// Opens TIFF files by libtiff with handlers of their own, so that nothing is printed and no other user of libtiff in
// the process is disturbed.
#include "io/tiff_file.hpp"

#include "io/system_failure.hpp"

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
    // Longer sentences are cut. libtiff quotes names and values of the file in some.
    std::array<char, 400> text{};
    std::vsnprintf(text.data(), text.size(), format, arguments);
    std::string sentence = text.data();
    // It becomes a part of another sentence.
    return sentence.substr(0, sentence.find_last_not_of(". \n") + 1);
}

// libtiff tells of want of memory as of any other fault, by one of many sentences.
template <class Keep>
void keep(TiffMessages& messages, const Keep& keep)
{
    // Looked at first: making the text below may fail for want of memory itself.
    messages.out_of_memory = messages.out_of_memory || errno == ENOMEM;
    try {
        keep(messages);
    } catch (const std::bad_alloc&) {
        messages.out_of_memory = true;
    }
}

// Called from C, so that no exception may leave. The answer 1: the message is dealt with.
int keep_error(::TIFF*, void* messages, const char*, const char* format, std::va_list arguments) noexcept
{
    keep(*static_cast<TiffMessages*>(messages), [&](TiffMessages& kept) {
        // The first error is the cause; later ones follow from it.
        if (kept.error.empty())
            kept.error = formatted(format, arguments);
    });
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
    keep(*static_cast<TiffMessages*>(messages), [&](TiffMessages& kept) {
        const std::string text = formatted(format, arguments);
        if (kept.warning.empty() && !is_harmless(text))
            kept.warning = text;
    });
    return 1;
}

}  // namespace

TiffFile::TiffFile(const std::string& path, uint64_t most_bytes) : messages_(std::make_unique<TiffMessages>())
{
    forget_want_of_memory();
    const std::unique_ptr<TIFFOpenOptions, void (*)(TIFFOpenOptions*)> options(TIFFOpenOptionsAlloc(),
                                                                               TIFFOpenOptionsFree);
    if (!options)
        throw std::bad_alloc();
    // A damaged page may claim a strip of gigabytes. libtiff then fails instead of asking for it.
    TIFFOpenOptionsSetMaxSingleMemAlloc(options.get(), static_cast<tmsize_t>(most_bytes));
    TIFFOpenOptionsSetErrorHandlerExtR(options.get(), keep_error, messages_.get());
    TIFFOpenOptionsSetWarningHandlerExtR(options.get(), keep_warning, messages_.get());
    // m: not mapped into memory, where a file that shrinks ends the process. c: strips as the file has them.
    handle_.reset(TIFFOpenExt(path.c_str(), "rmc", options.get()));
    if (!handle_)
        fail("it cannot be opened");
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
        fail(page + " cannot be read");
}

void TiffFile::first_page()
{
    if (!TIFFSetDirectory(handle(), 0))
        fail("the 1st page cannot be read");
}

void TiffFile::fail(const std::string& what) const
{
    if (messages_->out_of_memory)
        throw std::bad_alloc();
    check_for_want_of_memory();
    throw Error(CLEFT_ERROR_FORMAT, what + ": " + messages_->error);
}

}  // namespace cleft::io
