#include "world/worker_pool.h"

#include "kernel/float_mode.h"

namespace lr {

bool WorkerPool::start(uint32_t workers) {
    try {
        for (; workers_ < workers; ++workers_) threads_[workers_] = std::thread([this] { work(); });
    } catch (...) { // std::system_error, or std::bad_alloc from the thread's own state
        stop();
        return false;
    }
    return true;
}

void WorkerPool::stop() {
    if (workers_ == 0) return;
    stopping_.store(true, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    for (uint32_t i = 0; i < workers_; ++i) threads_[i].join();
    workers_ = 0;
}

void WorkerPool::run(uint32_t chunks, Task task, void* context) {
    task_ = task;
    context_ = context;
    chunks_ = chunks;
    next_.store(0, std::memory_order_relaxed);
    // Waking threads costs microseconds: one chunk is quicker done here.
    if (workers_ == 0 || chunks < 2) {
        take_chunks();
        return;
    }
    busy_.store(workers_, std::memory_order_relaxed);
    round_.fetch_add(1, std::memory_order_release);
    round_.notify_all();
    take_chunks();
    for (uint32_t left = busy_.load(std::memory_order_acquire); left != 0; left = busy_.load(std::memory_order_acquire))
        busy_.wait(left, std::memory_order_acquire);
}

void WorkerPool::take_chunks() {
    const FloatMode mode;
    for (;;) {
        const uint32_t chunk = next_.fetch_add(1, std::memory_order_relaxed);
        if (chunk >= chunks_) return;
        task_(context_, chunk);
    }
}

void WorkerPool::work() {
    uint32_t seen = 0;
    for (;;) {
        round_.wait(seen, std::memory_order_acquire);
        // Rounds never overlap: run() waits for every worker, so that none can miss one.
        ++seen;
        if (stopping_.load(std::memory_order_relaxed)) return;
        take_chunks();
        if (busy_.fetch_sub(1, std::memory_order_acq_rel) == 1) busy_.notify_one();
    }
}

} // namespace lr
