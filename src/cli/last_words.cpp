// What is done instead of aborting, without memory.
#include "last_words.hpp"

#include "exit_code.hpp"
#include "staged_outputs.hpp"

#include <unistd.h>

#include <cstdlib>
#include <exception>
#include <new>

namespace cleft_cli
{
namespace
{

[[noreturn]] void end()
{
    try {
        // std::terminate() is called with the exception that could not leave, if there was one.
        if (const std::exception_ptr unhandled = std::current_exception())
            std::rethrow_exception(unhandled);
    } catch (const std::bad_alloc&) {
        // No destructor runs any more, so unfinished files are removed here.
        StagedOutputs::remove_all();
        // write() and a constant text need no memory; fprintf() may ask for some.
        const char sentence[] = CLEFT_PROGRAM ": out of memory\n";
        [[maybe_unused]] const ssize_t written = write(STDERR_FILENO, sentence, sizeof sentence - 1);
        // exit() would run destructors of globals, which may be what threw.
        _exit(EXIT_OUT_OF_MEMORY);
    } catch (...) {
    }
    // Anything but want of memory is a mistake in the code. abort() leaves a core file to find it
    // by.
    std::abort();
}

}  // namespace

void tell_of_want_of_memory() { std::set_terminate(end); }

}  // namespace cleft_cli
