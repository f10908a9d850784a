// A TIFF file as libtiff opens it; what libtiff has to say is kept, not printed.
#pragma once

#include <tiffio.h>
#include <cstdint>
#include <memory>
#include <string>

namespace cleft::io
{

// What libtiff said of one file, the first of each kind.
struct TiffMessages {
    std::string error;
    std::string warning;
    bool out_of_memory = false;
};

class TiffFile
{
public:
    // `most_bytes`: what libtiff may ask for at once. Errors do not name the file.
    TiffFile(const std::string& path, uint64_t most_bytes);

    // Owned by this object; it stays open as long as that lives.
    ::TIFF* handle() const { return handle_.get(); }
    // What was said since the last call.
    TiffMessages take_messages();
    // Goes to the next page, or back to the first one.
    void next_page(const std::string& page);
    void first_page();
    // Throws what libtiff failed for: want of memory, or a sentence of `what` and its words.
    [[noreturn]] void fail(const std::string& what) const;

private:
    struct Close {
        void operator()(::TIFF* handle) const { TIFFClose(handle); }
    };
    std::unique_ptr<TiffMessages> messages_;  // its place is known to libtiff
    std::unique_ptr<::TIFF, Close> handle_;
};

}  // namespace cleft::io
