// System calls that fail on demand: those of the library and the baker go through this program's own.
#pragma once

#if defined(__linux__)

#include <cstddef>
#include <cstdint>

namespace test {

struct SystemFaults {
    // Calls that make, write, name or rename files, counted from 0 since the last reset.
    int calls = 0;
    int fail_at = -1;              // this one does nothing,
    int reason = 0;                // and returns so, as in errno; 0: the process dies in it by SIGKILL
    bool fail_after = false;       // and all that follow fail alike
    bool short_writes = false;     // writes take one byte of two, and every other one is interrupted
    bool without_nameless = false; // file systems that have no O_TMPFILE

    // read(): at most so many bytes at a time, interrupted before each, and after so many in all the file ends or breaks.
    size_t most = SIZE_MAX;
    bool interrupted = false;
    size_t ends_after = SIZE_MAX;
    int broken_by = 0; // instead of the end, as in errno
    int reads = 0;

    int threads_allowed = -1; // more cannot be started; -1: no limit
};
// Null but while a test asks for faults, in its own thread.
extern SystemFaults* system_faults;

class WithFaults {
public:
    explicit WithFaults(SystemFaults& faults) { system_faults = &faults; }
    ~WithFaults() { system_faults = nullptr; }
    WithFaults(const WithFaults&) = delete;
    WithFaults& operator=(const WithFaults&) = delete;
};

} // namespace test

#endif
