// What is printed: every byte arrives, or the command says that it does not.
#pragma once

#include "exit_code.hpp"

#include <string>
#include <string_view>

namespace cleft_cli
{

// Prints on standard output. Throws a Failure if it is full or closed. A reader that has gone away has read what it
// wanted of a summary: that is none.
void print_summary_text(const std::string& text);
// The same for a report that a program reads, where a reader that has gone away is a failure, too.
void print_report(const std::string& text);

// All of a text to any descriptor. The answer is 0 or the error number: ECANCELED where a signal has arrived, perhaps
// before, and a pipe takes no more.
int write_all(int descriptor, std::string_view text);
// What such a number other than 0 means. `sentence`: what could not be written, without the reason.
Failure failure_of_write(int error, const std::string& sentence);
// Opens a file for writing as open() does: one that is there, or a new one. Where it is a pipe that nobody reads yet,
// it waits for a reader, or for a signal as write_all() does.
int open_for_writing(const std::string& path, bool is_new);

// To be called first: a closed standard stream must not become the next file that is opened, and a write that cannot
// be done is to fail, rather than end the command.
void make_streams_safe();

}  // namespace cleft_cli
