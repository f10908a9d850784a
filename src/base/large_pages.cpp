// Asks Linux for large pages; other systems do what they do anyway.
#include "base/large_pages.hpp"

#ifdef __linux__
#include <sys/mman.h>
#include <unistd.h>
#include <cstdint>
#endif

namespace cleft
{

#ifdef __linux__

void allow_large_pages(void* data, size_t bytes)
{
    // Two of them: a shorter array may hold no whole one, for it begins anywhere.
    constexpr size_t kWorthIt = size_t{4} << 20;  // a large page is 2 MiB on most machines
    if (bytes < kWorthIt)
        return;
    const auto page = static_cast<uintptr_t>(sysconf(_SC_PAGESIZE));
    // Only whole pages: the bytes beside them belong to others.
    const uintptr_t begin = (reinterpret_cast<uintptr_t>(data) + page - 1) / page * page;
    const uintptr_t end = (reinterpret_cast<uintptr_t>(data) + bytes) / page * page;
    madvise(reinterpret_cast<void*>(begin), end - begin, MADV_HUGEPAGE);  // a system without them says so: no matter
}

#else

void allow_large_pages(void*, size_t) {}

#endif

}  // namespace cleft
