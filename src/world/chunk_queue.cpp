#include "world/chunk_queue.h"

#include "kernel/float_mode.h"
#include "world/spin.h"

namespace lr {

void ChunkQueue::open(uint32_t chunks, Task task, void* context) {
    task_ = task;
    context_ = context;
    chunks_ = chunks;
    undone_.store(chunks, std::memory_order_relaxed);
    left_.store(chunks, std::memory_order_release);
}

void ChunkQueue::take() {
    uint32_t left = left_.load(std::memory_order_acquire);
    if (left == 0) return;
    const FloatMode mode;
    uint32_t done = 0;
    while (left != 0) {
        // Only a thread that holds a chunk may look at the round: it then lasts until that chunk is done.
        if (!left_.compare_exchange_weak(left, left - 1, std::memory_order_acquire)) continue;
        task_(context_, chunks_ - left);
        ++done;
        left = left_.load(std::memory_order_acquire);
    }
    if (done != 0 && undone_.fetch_sub(done, std::memory_order_acq_rel) == done) undone_.notify_one();
}

void ChunkQueue::wait() {
    const auto done = [this] { return undone_.load(std::memory_order_acquire) == 0; };
    if (spin_until(done)) return;
    for (uint32_t left = undone_.load(std::memory_order_acquire); left != 0;
         left = undone_.load(std::memory_order_acquire))
        undone_.wait(left);
}

} // namespace lr
