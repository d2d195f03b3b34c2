// Threads that share out the chunks of a step. Which thread runs a chunk never changes its result.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <thread>

namespace lr {

class WorkerPool {
public:
    static constexpr uint32_t max_workers = 64;
    using Task = void (*)(void* context, uint32_t chunk);

    WorkerPool() = default;
    ~WorkerPool() { stop(); }
    WorkerPool(const WorkerPool&) = delete;
    WorkerPool& operator=(const WorkerPool&) = delete;

    // False when the system gives no threads; none are then left running.
    bool start(uint32_t workers);
    void stop();
    uint32_t workers() const { return workers_; }

    // Runs task(context, 0 .. chunks - 1), in the caller too, and returns when all are done. Allocates nothing.
    void run(uint32_t chunks, Task task, void* context);

private:
    void work();
    void take_chunks();

    std::array<std::thread, max_workers> threads_;
    uint32_t workers_ = 0;
    Task task_ = nullptr;
    void* context_ = nullptr;
    uint32_t chunks_ = 0;
    std::atomic<bool> stopping_{false};
    std::atomic<uint32_t> round_{0}; // grows by one for each run
    std::atomic<uint32_t> next_{0};  // the next chunk to take
    std::atomic<uint32_t> busy_{0};  // workers that have not finished the round
};

} // namespace lr
