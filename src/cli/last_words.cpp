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
        if (const std::exception_ptr unhandled = std::current_exception())
            std::rethrow_exception(unhandled);
    } catch (const std::bad_alloc&) {
        StagedOutputs::remove_all();
        const char sentence[] = "cleft: out of memory\n";
        [[maybe_unused]] const ssize_t told = write(STDERR_FILENO, sentence, sizeof sentence - 1);
        _exit(EXIT_OUT_OF_MEMORY);
    } catch (...) {
    }
    std::abort();
}

}  // namespace

void tell_of_want_of_memory() { std::set_terminate(end); }

}  // namespace cleft_cli
