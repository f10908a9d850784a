// Allocations and calls on files that fail when asked to, in a program that has interposer.cpp among its
// sources, or is run with it preloaded.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {

enum faults_kind : int32_t {
    FAULTS_NONE = 0,
    FAULTS_ALLOCATIONS = 1,          // of the whole process
    FAULTS_ALLOCATIONS_OF_OURS = 2,  // those that code of the libraries and shims of Cleft asks for itself
    FAULTS_FILES = 3                 // calls that make, write, name or close files for output
};

// From here on, call number `at` (1 ...; 0: none) of that kind fails, and all after it if `on` is not 0: an allocation
// for want of memory, a call on a file with `error` as errno.
void faults_arm(int32_t kind, int64_t at, int32_t on, int32_t error);
// No call fails any more. The number of calls of that kind since faults_arm().
int64_t faults_disarm(void);
// Blocks that were taken while armed, by whom the kind says, and not given back.
int64_t faults_live(void);
// The library (or program) that asked for one of these, "" if there is none.
const char* faults_owner_of_live(void);
}
