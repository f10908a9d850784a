#include "guarded.hpp"

#include "json_report.hpp"

#include <cstdio>
#include <new>

namespace cleft_cli
{
namespace
{

int tell_failure(const std::string& command, const RunArguments& arguments, const Failure& failure)
{
    std::fprintf(stderr, "cleft %s: %s\n", command.c_str(), failure.what());
    if (arguments.json.empty() || !failure.is_reported)
        return failure.exit_code;
    nlohmann::ordered_json report = report_head(command);
    report["error"] = {{"exit_code", failure.exit_code},
                       {"status", failure.status},
                       {"kind", cleft_status_string(failure.status)},
                       {"message", failure.what()}};
    try {
        write_json(report, arguments.json);
    } catch (const Failure& second) {
        std::fprintf(stderr, "cleft %s: %s\n", command.c_str(), second.what());
    }
    return failure.exit_code;
}

}  // namespace

int guarded(const std::string& command, const RunArguments& arguments, const std::function<int()>& body)
{
    try {
        return body();
    } catch (const Failure& failure) {
        return tell_failure(command, arguments, failure);
    } catch (const std::bad_alloc&) {
        return tell_failure(command, arguments, {EXIT_OUT_OF_MEMORY, CLEFT_ERROR_OUT_OF_MEMORY, "out of memory"});
    } catch (const std::exception& other) {
        return tell_failure(command, arguments, {EXIT_MESHING_FAILED, CLEFT_ERROR_INTERNAL, other.what()});
    }
}

}  // namespace cleft_cli
