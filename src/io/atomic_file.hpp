// A file that appears under its name complete or not at all: written under a temporary name in the same folder, flushed
// to the disk, then renamed. Unless it is committed, the destructor removes the temporary and the old file stays. The
// folder is held open, so that nothing asks for memory once a file has its name.
#pragma once

#include <charconv>
#include <cstdint>
#include <initializer_list>
#include <memory>
#include <string>
#include <string_view>
#include <type_traits>

namespace cleft::io
{

class AtomicFile
{
public:
    // Throws Error(CLEFT_ERROR_FILE) if the temporary cannot be made.
    explicit AtomicFile(const std::string& path);
    ~AtomicFile();
    AtomicFile(const AtomicFile&) = delete;
    AtomicFile& operator=(const AtomicFile&) = delete;

    // Appends `bytes` bytes. Throws Error(CLEFT_ERROR_FILE) where the system cannot write, which
    // may be later than the call, as the file is buffered.
    void write(const void* data, size_t bytes);

    // The value as it lies in memory. Formats of fixed byte order may use it, since the writers
    // require a little-endian machine.
    template <class T>
    void binary(const T& value)
    {
        static_assert(std::is_trivially_copyable_v<T>);
        write(&value, sizeof value);
    }

    // Text: numbers are written with the fewest digits that give the same number back.
    template <class... Parts>
    void print(const Parts&... parts)
    {
        (put(parts), ...);
    }

    // Flushes to the disk and takes the final name. Nothing may be written afterwards. Throws
    // Error(CLEFT_ERROR_FILE); the old file is then unchanged.
    void commit() { commit_all({this}); }
    // All or none: if one cannot take its name, the others get their old contents back.
    static void commit_all(const std::initializer_list<AtomicFile*>& files);

private:
    // 1 MiB: few enough calls to the system for files of gigabytes, and little beside the mesh.
    static constexpr size_t kCapacity = size_t{1} << 20;
    // The shortest form of a double has at most 24 characters ("-2.2250738585072014e-308"), and an
    // int64 20.
    static constexpr size_t kLongestNumber = 32;

    void put(char c)
    {
        if (used_ == kCapacity)
            flush();
        buffer_[used_++] = c;
    }
    void put(std::string_view text) { write(text.data(), text.size()); }
    void put(const char* text) { put(std::string_view(text)); }
    void put(const std::string& text) { put(std::string_view(text)); }
    template <class T, class = std::enable_if_t<std::is_arithmetic_v<T>>>
    void put(T number)
    {
        if (kCapacity - used_ < kLongestNumber)
            flush();
        char* begin = buffer_.get() + used_;
        used_ += static_cast<size_t>(std::to_chars(begin, begin + kLongestNumber, number).ptr - begin);
    }

    void flush();
    // finish() writes and closes the temporary; take_name() renames it. They are apart so that
    // commit_all() can finish all files first.
    void finish();
    void take_name();
    [[noreturn]] void fail(int error) const;

    std::string path_;       // as the caller says it
    std::string name_;       // of the target in its folder
    std::string temporary_;  // likewise; empty if there is none
    std::unique_ptr<char[]> buffer_;
    size_t used_ = 0;
    int folder_ = -1;
    int descriptor_ = -1;
};

}  // namespace cleft::io
