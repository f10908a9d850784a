// Turns what a command throws into a sentence on standard error, a report, and an exit code. No
// exception passes this place.
#include "guarded.hpp"

#include "json_report.hpp"
#include "program.hpp"

#include <cstdio>
#include <new>
#include <stdexcept>

namespace cleft_cli
{

int tell_failure(const std::string& command, const RunArguments& arguments, const Failure& failure)
{
    const auto tell = [&](const char* sentence) {
        std::fprintf(stderr, "%s %s: %s\n", kProgram, command.c_str(), sentence);
    };
    tell(failure.what());
    // is_reported is false where the report itself is in the way, or could not be written.
    if (arguments.json.empty() || !failure.is_reported)
        return failure.exit_code;
    nlohmann::ordered_json report = report_head(command);
    // Scripts find the failure under "error" whatever the command is. Fields of a success are
    // absent then.
    report["error"] = {{"exit_code", failure.exit_code},
                       {"status", failure.status},
                       {"kind", cleft_status_string(failure.status)},
                       {"message", failure.what()}};
    try {
        write_json(report, arguments.json);
        // The first failure keeps the exit code; the second is reported as well.
    } catch (const Failure& second) {
        tell(second.what());
    }
    return failure.exit_code;
}

int guarded(const std::string& command, const RunArguments& arguments, const std::function<int()>& body)
{
    try {
        return body();
    } catch (const Failure& failure) {
        return tell_failure(command, arguments, failure);
        // Also from the command's own code: the summary of a large mesh takes memory, too.
    } catch (const std::bad_alloc&) {
        return tell_failure(command, arguments, {EXIT_OUT_OF_MEMORY, CLEFT_ERROR_OUT_OF_MEMORY, "out of memory"});
    } catch (const std::length_error&) {  // a container asked for more than the address space
        return tell_failure(command, arguments, {EXIT_OUT_OF_MEMORY, CLEFT_ERROR_OUT_OF_MEMORY, "out of memory"});
        // Everything else is a mistake in the command or the library, so it is never called a mistake
        // of the user's.
    } catch (const std::exception& other) {
        return tell_failure(command, arguments, {EXIT_MESHING_FAILED, CLEFT_ERROR_INTERNAL, other.what()});
    }
}

}  // namespace cleft_cli
