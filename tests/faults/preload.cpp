// Preloaded before a program, arms the faults that CLEFT_FAULTS asks for ("KIND AT ON ERRNO FILE") when main() begins,
// and leaves the number of calls in FILE when it ends.
// With CLEFT_FAULTS_WALK ("STEP FILE"), for programs in other languages: from each new context on, one allocation of
// Cleft's own fails, STEP further each time. FILE gets the number of contexts, and of blocks that one of them lost.
#include "faults/interposer.hpp"

#include <dlfcn.h>

#include <cstdio>
#include <cstdlib>

namespace
{

using Main = int (*)(int, char**, char**);
using Start = int (*)(Main, int, char**, void (*)(), void (*)(), void (*)(), void*);

Main real_main = nullptr;
char count_file[4096];

void leave_count()
{
    const int64_t calls = faults_disarm();
    if (FILE* file = std::fopen(count_file, "w")) {
        std::fprintf(file, "%lld\n", static_cast<long long>(calls));
        std::fclose(file);
    }
}

// -------------------------------------------------------------------------------------------------- walking --

int64_t step = 0, contexts = 0, lost = 0;

void end_context()
{
    faults_disarm();
    const int64_t live = faults_live();
    if (live > 0)
        std::fprintf(stderr, "context %lld lost %lld blocks, one of %s\n", static_cast<long long>(contexts),
                     static_cast<long long>(live), faults_owner_of_live());
    lost += live;
}

void leave_walk()
{
    end_context();
    if (FILE* file = std::fopen(count_file, "w")) {
        std::fprintf(file, "%lld %lld\n", static_cast<long long>(contexts), static_cast<long long>(lost));
        std::fclose(file);
    } else
        std::perror(count_file);
}

using Create = int32_t (*)(void**);
Create real_create = nullptr;

void find_real_create()
{
    void* library = dlopen("libcleft.so.0", RTLD_LAZY | RTLD_NOLOAD);
    real_create = library ? reinterpret_cast<Create>(dlsym(library, "cleft_context_create")) : nullptr;
}

int armed_main(int count, char** arguments, char** environment)
{
    int kind = FAULTS_NONE, on = 0, error = 0;
    long long at = 0;
    find_real_create();
    const char* asked = std::getenv("CLEFT_FAULTS");
    if (asked && std::sscanf(asked, "%d %lld %d %d %4095s", &kind, &at, &on, &error, count_file) == 5) {
        std::atexit(leave_count);
        faults_arm(kind, at, on, error);
    }
    long long asked_step = 0;
    const char* walk = std::getenv("CLEFT_FAULTS_WALK");
    if (walk && std::sscanf(walk, "%lld %4095s", &asked_step, count_file) == 2) {
        step = asked_step;
        std::atexit(leave_walk);
    }
    return real_main(count, arguments, environment);
}

}  // namespace

extern "C" int __libc_start_main(Main main, int count, char** arguments, void (*init)(), void (*fini)(), void (*end)(),
                                 void* stack)
{
    real_main = main;
    const auto start = reinterpret_cast<Start>(dlsym(RTLD_NEXT, "__libc_start_main"));
    return start(armed_main, count, arguments, init, fini, end, stack);
}

extern "C" int32_t cleft_context_create(void** out)
{
    if (step > 0)
        end_context();
    // A program of another language loads the library when it pleases. It is looked up while no allocation fails.
    if (!real_create)
        find_real_create();
    if (step > 0)
        faults_arm(FAULTS_ALLOCATIONS_OF_OURS, 1 + step * contexts++, 0, 0);
    return real_create(out);
}
