#include "world/worker_pool.h"

#include "world/spin.h"

namespace lr {

#if LR_HAS_THREADS
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
#else
bool WorkerPool::start(uint32_t workers) {
    return workers == 0;
}

void WorkerPool::stop() {}
#endif

void WorkerPool::wake(uint32_t helpers) {
    round_.fetch_add(1, std::memory_order_release);
    if (helpers >= workers_)
        round_.notify_all();
    else
        for (; helpers != 0; --helpers) round_.notify_one();
}

void WorkerPool::work() {
    uint32_t seen = 0;
    for (;;) {
        // Rounds of one step follow each other within microseconds; those of different frames do not.
        const auto called = [&] { return round_.load(std::memory_order_acquire) != seen; };
        if (!spin_until(called)) round_.wait(seen);
        seen = round_.load(std::memory_order_acquire);
        if (stopping_.load(std::memory_order_relaxed)) return;
        queue_->take();
    }
}

} // namespace lr
