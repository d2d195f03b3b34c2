// Counts how often a step runs each instruction of the library, or of a peer in this program: single-stepped under ptrace.
// Works for instruction sets that emulators do not know.
#pragma once

#include "lr_bench/subject.h"

namespace lr_bench {

// Writes `address,count` rows, with addresses as in objdump. Returns an exit code; 2 if tracing is impossible.
int write_trace(const Row& row, const char* path);

} // namespace lr_bench
