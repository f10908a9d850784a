// How the command ends, and the exception that ends it.
#pragma once

#include "cleft/cleft.h"

#include <stdexcept>
#include <string>

namespace cleft_cli
{

// Part of the command's interface: scripts rely on the numbers. 128 + n: ended by signal n.
enum ExitCode {
    // Numbers are documented in --help, in the manual pages and in docs/guide.md. They are never
    // given another meaning.
    EXIT_OK = 0,
    EXIT_CHECK_FAILED = 1,
    EXIT_USAGE = 2,
    EXIT_CANNOT_READ = 3,
    EXIT_CANNOT_WRITE = 4,
    EXIT_MESHING_FAILED = 5,
    EXIT_LABEL_LOST = 6,
    EXIT_OUT_OF_MEMORY = 7,
    EXIT_INTERRUPTED = 130
};

// The list of exit codes as --help prints it.
inline const char* exit_code_help()
{
    return "Exit codes: 0 done; 1 the mesh is not valid; 2 usage; 3 an input cannot be read; 4 an output cannot\n"
           "be written; 5 meshing failed; 6 a label or a large piece of one was lost, or labels met that do not in\n"
           "the voxels (--strict); 7 out of memory; 130 stopped by Ctrl-C (128 + the number of the signal). A failed\n"
           "or stopped run leaves no output and no part of one.";
}

// what() is the sentence for the user, without the name of the command.
struct Failure : std::runtime_error {
    Failure(int code, cleft_status why, const std::string& sentence)
        : std::runtime_error(sentence), exit_code(code), status(why)
    {
    }
    int exit_code;
    cleft_status status;
    bool is_reported = true;  // in the JSON file, too
};

// For values that CLI11 cannot judge. It names the option.
inline Failure usage_failure(const std::string& sentence) { return {EXIT_USAGE, CLEFT_ERROR_OPTION, sentence}; }

}  // namespace cleft_cli
