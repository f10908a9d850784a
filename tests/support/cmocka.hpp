// CMocka for C++ tests. CMocka fails by longjmp: assert in the test's own frame only, never inside a callback that C++
// code calls, and not while objects that matter are alive below.
#pragma once

#include <csetjmp>
#include <cstdarg>
#include <cstddef>
#include <cstdint>

extern "C" {
#include <cmocka.h>
}
