// Bytes on disk that the work comes back to.
#pragma once

#include <cstdint>
#include <string>

namespace cleft
{

// A file without a name: it goes with the process, however that ends.
class ScratchFile
{
public:
    explicit ScratchFile(const std::string& folder);
    ~ScratchFile();
    ScratchFile(const ScratchFile&) = delete;
    ScratchFile& operator=(const ScratchFile&) = delete;

    // Where some bytes lie. It stays where it is if there is room for what is written there next.
    struct Place {
        int64_t at = 0, room = 0;
    };
    void write(Place& place, const void* bytes, int64_t size);
    void read(const Place& place, int64_t first, int64_t size, void* to) const;

private:
    [[noreturn]] void fail(const char* what) const;

    std::string folder_;
    int file_;
    int64_t end_ = 0;
};

}  // namespace cleft
