// Which instructions of the library, or of a peer in this program, a step runs, and how often: one at a time under ptrace.
// Works for instruction sets that emulators do not know.
#pragma once

#include "lr_bench/subject.h"

namespace lr_bench {

// Writes `address,count` rows, addresses as objdump shows them. Returns an exit code; 2 where it cannot be done.
int write_trace(const Row& row, const char* path);

} // namespace lr_bench
