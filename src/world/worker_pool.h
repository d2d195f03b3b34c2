// The world's own threads.
#pragma once

#include "world/chunk_queue.h"
#include "world/threads.h"
#include "world/waited_count.h"

#include <array>
#include <atomic>
#include <cstdint>

namespace lr {

class WorkerPool {
public:
    static constexpr uint32_t max_workers = 64;

    explicit WorkerPool(ChunkQueue& queue) : queue_(&queue) {}
    ~WorkerPool() { stop(); }
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    // False when the system gives no threads; none are then left running.
    bool start(uint32_t workers);
    void stop();
    uint32_t workers() const { return workers_; }

    // Lets up to `helpers` workers take from the queue, which is open. Returns at once.
    void wake(uint32_t helpers);

private:
    void work();

    ChunkQueue* queue_;
#if LR_HAS_THREADS
    std::array<std::thread, max_workers> threads_;
#endif
    uint32_t workers_ = 0;
    std::atomic<bool> stopping_{false};
    WaitedCount round_; // grows by one for each call of wake()
};

} // namespace lr
