// Items that are put away under numbers, in memory or on disk.
#pragma once

#include "base/array.hpp"
#include "parts/scratch_file.hpp"

#include <map>
#include <memory>
#include <type_traits>

namespace cleft
{

// Items have no memory of their own, as those of a Parcel.
class KeptBytes
{
public:
    // `scratch`: the folder where they are kept; empty: they are in memory.
    explicit KeptBytes(const std::string& scratch);

    bool is_on_disk() const { return file_ != nullptr; }
    bool has(int64_t number) const { return count_bytes(number) > 0; }

    // In the place of what the number had.
    template <class T>
    void put(int64_t number, const Array<T>& items)
    {
        static_assert(std::is_trivially_destructible_v<T>, "items are kept as bytes");
        put_bytes(number, items.data(), items.count() * int64_t{sizeof(T)});
    }
    // All items of a number.
    template <class T>
    Array<T> get(int64_t number) const
    {
        Array<T> out;
        append(number, 0, count_bytes(number) / int64_t{sizeof(T)}, out);
        return out;
    }
    // `count` items from the item `first` on.
    template <class T>
    void append(int64_t number, int64_t first, int64_t count, Array<T>& out) const
    {
        const size_t before = out.size();
        out.resize(before + to_size(count));
        get_bytes(number, first * int64_t{sizeof(T)}, count * int64_t{sizeof(T)}, out.data() + before);
    }
    // Forgets all. The next items of a number take the room on disk of those before.
    void clear();

private:
    struct Kept {
        int64_t size = 0;
        Array<unsigned char> bytes;  // empty: on disk
        ScratchFile::Place place;
    };
    int64_t count_bytes(int64_t number) const;
    void put_bytes(int64_t number, const void* bytes, int64_t size);
    void get_bytes(int64_t number, int64_t first, int64_t size, void* to) const;

    std::map<int64_t, Kept> kept_;
    std::unique_ptr<ScratchFile> file_;
};

}  // namespace cleft
