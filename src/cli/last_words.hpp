// The end of the command where memory runs out and no exception can say so.
#pragma once

namespace cleft_cli
{

// From here on: where an exception cannot leave, as in a destructor of a library that asks for memory, want of memory
// ends the command as it always does, with a sentence, its exit code, and no output.
void tell_of_want_of_memory();

}  // namespace cleft_cli
