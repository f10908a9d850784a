// CMocka for C++ tests. CMocka fails by longjmp: assert in the test's own frame only, never inside a callback that C++
// code calls, and not while objects that matter are alive below.
#pragma once

#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>
#include <fstream>  // CMocka makes a macro of `fail`, which is the name of a member of streams: they must come first
#include <sstream>

extern "C" {
#include <cmocka.h>
}
