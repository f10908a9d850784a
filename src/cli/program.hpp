// The name of the command for which the files of this folder are compiled: its sentences begin with it.
#pragma once

namespace cleft_cli
{

inline constexpr char kProgram[] = CLEFT_PROGRAM;

}  // namespace cleft_cli
