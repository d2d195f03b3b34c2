// Keeps concurrent bakes within the available memory.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace lr::baker {

// Bytes available in the machine and its container; 4 GiB if unknown.
uint64_t available_memory();

// Upper bound of the bytes that the added-mass solver needs for this many faces, beyond the mesh.
uint64_t solve_memory(std::size_t faces);

class MemoryBudget {
public:
    explicit MemoryBudget(uint64_t bytes) : total_(bytes) {}

    // Waits until the bytes are free. A request above the whole budget waits until all of it is free.
    void acquire(uint64_t bytes);
    void release(uint64_t bytes);

private:
    std::mutex mutex_;
    std::condition_variable freed_;
    uint64_t total_, used_ = 0;
};
} // namespace lr::baker
