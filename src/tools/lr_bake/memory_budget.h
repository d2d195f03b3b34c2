// So that bakes side by side do not need more memory than there is.
#pragma once

#include <condition_variable>
#include <cstddef>
#include <cstdint>
#include <mutex>

namespace lr::baker {

// What the machine and its container can still give, in bytes; a guess of 4 GiB where nothing says.
uint64_t available_memory();

// Bytes that the added mass of so many faces needs at most, beyond the mesh.
uint64_t solve_memory(std::size_t faces);

class MemoryBudget {
public:
    explicit MemoryBudget(uint64_t bytes) : total_(bytes) {}

    // Waits until the bytes are free. What is more than all of the budget gets it once nobody else has any of it.
    void acquire(uint64_t bytes);
    void release(uint64_t bytes);

private:
    std::mutex mutex_;
    std::condition_variable freed_;
    uint64_t total_, used_ = 0;
};

} // namespace lr::baker
