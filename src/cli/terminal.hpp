// What standard error and standard output are connected with.
#pragma once

namespace cleft_cli
{

// Is somebody likely to read it?
bool is_terminal(int descriptor);
// Can a line on it be drawn anew? Not on one that calls itself dumb, such as a window of an editor.
bool redraws_lines(int descriptor);
// Columns of the terminal now, as windows change; the variable COLUMNS, or 80, where it does not say.
int terminal_columns(int descriptor);

}  // namespace cleft_cli
