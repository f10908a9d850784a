// Bytes on disk that the work comes back to.
#pragma once

#include "base/array.hpp"

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

    // Where some bytes lie. A record that is written again stays where it is if there is room.
    struct Record {
        int64_t at = 0, size = 0, room = 0;
    };
    void write(Record& record, const Array<unsigned char>& bytes);
    Array<unsigned char> read(const Record& record) const;

private:
    [[noreturn]] void fail(const char* what) const;

    std::string folder_;
    int file_;
    int64_t end_ = 0;
};

}  // namespace cleft
