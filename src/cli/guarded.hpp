// The one place where failures end.
#pragma once

#include "session.hpp"

#include "exit_code.hpp"

#include <functional>
#include <string>

namespace cleft_cli
{

// Runs a command. A failure is reported on stderr and in the JSON file, and becomes the exit code.
// Returns the exit code of `body`, or that of its failure. `command` is the name for messages, such
// as "mesh".
int guarded(const std::string& command, const RunArguments& arguments, const std::function<int()>& body);

// Reports a failure in this way. Returns its exit code.
int tell_failure(const std::string& command, const RunArguments& arguments, const Failure& failure);

}  // namespace cleft_cli
