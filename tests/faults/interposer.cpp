// The C library's functions that allocate, and those that write files, in front of the C library's own (Linux, glibc).
#include "faults/interposer.hpp"

#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <new>

extern "C" {
void* __libc_malloc(size_t);
void* __libc_calloc(size_t, size_t);
void* __libc_realloc(void*, size_t);
void* __libc_memalign(size_t, size_t);
void __libc_free(void*);
}

namespace
{

std::atomic<int32_t> armed{FAULTS_NONE};
std::atomic<int64_t> calls{0};
int64_t fails_at = 0;
bool fails_on = false;
int error_of_files = 0;

bool is_due()
{
    const int64_t call = ++calls;
    return fails_at > 0 && (fails_on ? call >= fails_at : call == fails_at);
}

// ---------------------------------------------------------------------------------------- whose call it is --

struct Range {
    uintptr_t begin, end;
};
// Where code lies in memory.
struct Ranges {
    static constexpr int most = 64;
    Range at[most];
    int count;

    void add(const dl_phdr_info& info)
    {
        for (int i = 0; i < info.dlpi_phnum && count < most; ++i)
            if (info.dlpi_phdr[i].p_type == PT_LOAD && (info.dlpi_phdr[i].p_flags & PF_X)) {
                const uintptr_t begin = info.dlpi_addr + info.dlpi_phdr[i].p_vaddr;
                at[count++] = {begin, begin + info.dlpi_phdr[i].p_memsz};
            }
    }
    bool has(const void* caller) const
    {
        const auto address = reinterpret_cast<uintptr_t>(caller);
        for (int i = 0; i < count; ++i)
            if (address >= at[i].begin && address < at[i].end)
                return true;
        return false;
    }
};
Ranges ours;
// The dynamic loader makes the thread-local memory of each new thread, and the C library keeps it with the stack for
// the next one: how many there are depends on how many threads ran at once. So none of its blocks is called lost.
Ranges loader;

int note_ranges(dl_phdr_info* info, size_t, void*)
{
    const char* slash = std::strrchr(info->dlpi_name, '/');
    const char* name = slash ? slash + 1 : info->dlpi_name;
    if (std::strncmp(name, "libcleft", 8) == 0 || std::strncmp(name, "_native", 7) == 0)
        ours.add(*info);
    if (std::strncmp(name, "ld-linux", 8) == 0)
        loader.add(*info);
    return 0;
}

bool counts(const void* caller)
{
    const int32_t kind = armed.load(std::memory_order_relaxed);
    if (kind != FAULTS_ALLOCATIONS_OF_OURS)
        return kind == FAULTS_ALLOCATIONS;
    return ours.has(caller);
}

// --------------------------------------------------------------------------------------------- live blocks --

// Addresses, each at the first free place from its hash on, with no free place between.
constexpr size_t place_bits = 17;
constexpr size_t place_count = size_t{1} << place_bits;
uintptr_t places[place_count];
const void* askers[place_count];  // who asked for each
std::atomic<int64_t> live{0};
std::atomic_flag busy = ATOMIC_FLAG_INIT;

class Locked
{
public:
    Locked()
    {
        while (busy.test_and_set(std::memory_order_acquire)) {
        }
    }
    ~Locked() { busy.clear(std::memory_order_release); }
    Locked(const Locked&) = delete;
    Locked& operator=(const Locked&) = delete;
};

size_t next_place(size_t place) { return (place + 1) % place_count; }
size_t first_place(uintptr_t block) { return (block >> 4) * 0x9E3779B97F4A7C15u >> (64 - place_bits); }
size_t steps(size_t from, size_t to) { return (to + place_count - from) % place_count; }

void* noted(void* block, const void* caller)
{
    if (!block || loader.has(caller))
        return block;
    const Locked lock;
    if (++live > static_cast<int64_t>(place_count / 2))
        std::abort();  // the table is too small for what is tried
    size_t place = first_place(reinterpret_cast<uintptr_t>(block));
    while (places[place] != 0)
        place = next_place(place);
    places[place] = reinterpret_cast<uintptr_t>(block);
    askers[place] = caller;
    return block;
}

void forget(const void* block)
{
    if (!block || live.load(std::memory_order_relaxed) == 0)
        return;
    const Locked lock;
    size_t hole = first_place(reinterpret_cast<uintptr_t>(block));
    while (places[hole] != 0 && places[hole] != reinterpret_cast<uintptr_t>(block))
        hole = next_place(hole);
    if (places[hole] == 0)
        return;
    --live;
    for (size_t place = next_place(hole); places[place] != 0; place = next_place(place))
        if (steps(first_place(places[place]), place) >= steps(hole, place)) {
            places[hole] = places[place];
            askers[hole] = askers[place];
            hole = place;
        }
    places[hole] = 0;
}

// -------------------------------------------------------------------------------------------- allocations --

template <class Take>
void* allocated(const void* caller, const Take& take)
{
    if (!counts(caller))
        return take();
    if (!is_due())
        return noted(take(), caller);
    errno = ENOMEM;
    return nullptr;
}

void* new_block(const void* caller, size_t size, size_t alignment)
{
    void* block = allocated(
        caller, [&] { return alignment > 16 ? __libc_memalign(alignment, size) : __libc_malloc(size > 0 ? size : 1); });
    if (!block)
        throw std::bad_alloc();
    return block;
}

void release(void* block)
{
    forget(block);
    __libc_free(block);
}

}  // namespace

#define CALLER __builtin_return_address(0)

extern "C" {
void* malloc(size_t size)
{
    return allocated(CALLER, [&] { return __libc_malloc(size); });
}
void* calloc(size_t count, size_t size)
{
    return allocated(CALLER, [&] { return __libc_calloc(count, size); });
}
void* realloc(void* block, size_t size)
{
    return allocated(CALLER, [&] {
        void* moved = __libc_realloc(block, size);
        if (moved || size == 0)
            forget(block);
        return moved;
    });
}
void* memalign(size_t alignment, size_t size)
{
    return allocated(CALLER, [&] { return __libc_memalign(alignment, size); });
}
void* aligned_alloc(size_t alignment, size_t size)
{
    return allocated(CALLER, [&] { return __libc_memalign(alignment, size); });
}
int posix_memalign(void** out, size_t alignment, size_t size)
{
    void* block = allocated(CALLER, [&] { return __libc_memalign(alignment, size); });
    if (!block)
        return ENOMEM;
    *out = block;
    return 0;
}
void free(void* block) { release(block); }
}

void* operator new(size_t size) { return new_block(CALLER, size, 0); }
void* operator new[](size_t size) { return new_block(CALLER, size, 0); }
void* operator new(size_t size, std::align_val_t alignment)
{
    return new_block(CALLER, size, static_cast<size_t>(alignment));
}
void* operator new[](size_t size, std::align_val_t alignment)
{
    return new_block(CALLER, size, static_cast<size_t>(alignment));
}
void* operator new(size_t size, const std::nothrow_t&) noexcept
{
    return allocated(CALLER, [&] { return __libc_malloc(size > 0 ? size : 1); });
}
void* operator new[](size_t size, const std::nothrow_t&) noexcept
{
    return allocated(CALLER, [&] { return __libc_malloc(size > 0 ? size : 1); });
}
void operator delete(void* block) noexcept { release(block); }
void operator delete[](void* block) noexcept { release(block); }
void operator delete(void* block, size_t) noexcept { release(block); }
void operator delete[](void* block, size_t) noexcept { release(block); }
void operator delete(void* block, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, size_t, std::align_val_t) noexcept { release(block); }
void operator delete[](void* block, size_t, std::align_val_t) noexcept { release(block); }
void operator delete(void* block, const std::nothrow_t&) noexcept { release(block); }
void operator delete[](void* block, const std::nothrow_t&) noexcept { release(block); }

// -------------------------------------------------------------------------------------------------- files --

namespace
{

template <class Function>
Function next(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

bool fails_on_file()
{
    if (armed.load(std::memory_order_relaxed) != FAULTS_FILES || !is_due())
        return false;
    errno = error_of_files;
    return true;
}

// Not the standard streams, pipes and terminals.
bool is_output(int descriptor)
{
    struct stat status = {};
    return armed.load(std::memory_order_relaxed) == FAULTS_FILES && descriptor > STDERR_FILENO &&
           fstat(descriptor, &status) == 0 && S_ISREG(status.st_mode) &&
           (fcntl(descriptor, F_GETFL) & O_ACCMODE) != O_RDONLY;
}

bool writes(int flags) { return (flags & O_ACCMODE) != O_RDONLY; }

mode_t mode_of(int flags, va_list& arguments)
{
    return flags & (O_CREAT | O_TMPFILE) ? static_cast<mode_t>(va_arg(arguments, int)) : 0;
}

}  // namespace

extern "C" {
int open(const char* path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return writes(flags) && fails_on_file() ? -1 : next<int (*)(const char*, int, ...)>("open")(path, flags, mode);
}
int open64(const char* path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return writes(flags) && fails_on_file() ? -1 : next<int (*)(const char*, int, ...)>("open64")(path, flags, mode);
}
int openat(int folder, const char* path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return writes(flags) && fails_on_file()
               ? -1
               : next<int (*)(int, const char*, int, ...)>("openat")(folder, path, flags, mode);
}
int openat64(int folder, const char* path, int flags, ...)
{
    va_list arguments;
    va_start(arguments, flags);
    const mode_t mode = mode_of(flags, arguments);
    va_end(arguments);
    return writes(flags) && fails_on_file()
               ? -1
               : next<int (*)(int, const char*, int, ...)>("openat64")(folder, path, flags, mode);
}
FILE* fopen(const char* path, const char* mode)
{
    return mode[0] != 'r' && fails_on_file() ? nullptr : next<FILE* (*)(const char*, const char*)>("fopen")(path, mode);
}
FILE* fopen64(const char* path, const char* mode)
{
    return mode[0] != 'r' && fails_on_file() ? nullptr
                                             : next<FILE* (*)(const char*, const char*)>("fopen64")(path, mode);
}
ssize_t write(int descriptor, const void* bytes, size_t count)
{
    return is_output(descriptor) && fails_on_file()
               ? -1
               : next<ssize_t (*)(int, const void*, size_t)>("write")(descriptor, bytes, count);
}
int fsync(int descriptor)
{
    return is_output(descriptor) && fails_on_file() ? -1 : next<int (*)(int)>("fsync")(descriptor);
}
int close(int descriptor)
{
    const bool fails = is_output(descriptor) && fails_on_file();
    const int error = errno;
    const int closed = next<int (*)(int)>("close")(descriptor);
    if (fails)
        errno = error;
    return fails ? -1 : closed;
}
int rename(const char* from, const char* to)
{
    return fails_on_file() ? -1 : next<int (*)(const char*, const char*)>("rename")(from, to);
}
int renameat(int folder, const char* from, int to_folder, const char* to)
{
    return fails_on_file() ? -1
                           : next<int (*)(int, const char*, int, const char*)>("renameat")(folder, from, to_folder, to);
}
int link(const char* from, const char* to)
{
    return fails_on_file() ? -1 : next<int (*)(const char*, const char*)>("link")(from, to);
}
int linkat(int folder, const char* from, int to_folder, const char* to, int flags)
{
    return fails_on_file()
               ? -1
               : next<int (*)(int, const char*, int, const char*, int)>("linkat")(folder, from, to_folder, to, flags);
}
char* mkdtemp(char* name) { return fails_on_file() ? nullptr : next<char* (*)(char*)>("mkdtemp")(name); }
int mkdir(const char* path, mode_t mode)
{
    return fails_on_file() ? -1 : next<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

// ------------------------------------------------------------------------------------------- the switches --

void faults_arm(int32_t kind, int64_t at, int32_t on, int32_t error)
{
    ours.count = 0;
    loader.count = 0;
    dl_iterate_phdr(note_ranges, nullptr);
    std::memset(places, 0, sizeof places);
    live = 0;
    calls = 0;
    fails_at = at;
    fails_on = on != 0;
    error_of_files = error;
    armed = kind;
}

int64_t faults_disarm(void)
{
    armed = FAULTS_NONE;
    return calls;
}

int64_t faults_live(void) { return live; }

const char* faults_owner_of_live(void)
{
    for (size_t place = 0; place < place_count; ++place) {
        Dl_info info = {};
        if (places[place] != 0 && dladdr(askers[place], &info) != 0)
            return info.dli_fname;
    }
    return "";
}
}
