// System calls that fail on demand: library and baker call this program's versions.
#pragma once

#if defined(__linux__)

#include <cstddef>
#include <cstdint>

namespace test {

struct SystemFaults {
    // Number of calls that create, write, link or rename files since the last reset.
    int calls = 0;
    int fail_at = -1;              // number of the call that does nothing, from 0,
    int reason = 0;                // and fails with this errno; 0: the process dies in it by SIGKILL
    bool fail_after = false;       // and so do all later calls
    bool short_writes = false;     // writes take half of the bytes, and every second write is interrupted
    bool without_nameless = false; // a file system without O_TMPFILE

    // read(): at most this many bytes at a time, interrupted before each; after `ends_after` bytes the file ends or fails.
    size_t most = SIZE_MAX;
    bool interrupted = false;
    size_t ends_after = SIZE_MAX;
    int broken_by = 0; // errno; 0: the file ends
    int reads = 0;

    int threads_allowed = -1; // number of threads that can be started; -1: no limit
};
// Null unless a test asks for faults, in its own thread.
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
