// Chunks of work that any number of threads take from, and one waits for. Which thread runs a chunk never changes its
// result.
#pragma once

#include "world/waited_count.h"

#include <atomic>
#include <cstdint>

namespace lr {

class ChunkQueue {
public:
    using Task = void (*)(void* context, uint32_t chunk);

    // A new round of task(context, 0 .. chunks - 1). The one before is done.
    void open(uint32_t chunks, Task task, void* context);
    // Runs chunks until none are left. From any thread at any time: one that comes late finds none and reads nothing.
    void take();
    bool any() const { return left_.load(std::memory_order_relaxed) != 0; }
    // Until all chunks are done, also those that others have taken.
    void wait();

private:
    // Two lines that every chunk changes; with the first goes what is read along with it.
    alignas(64) std::atomic<uint32_t> left_{0}; // chunks that nobody has taken
    uint32_t chunks_ = 0;
    Task task_ = nullptr;
    void* context_ = nullptr;
    alignas(64) WaitedCount undone_; // chunks that are not done
};

} // namespace lr
