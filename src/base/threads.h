// Threads, waiting and yielding on this platform.
#pragma once

#include <atomic>
#include <cstdint>

// WebAssembly built without -pthread has no threads, nor the headers for them.
#if defined(__wasm__) && !defined(_REENTRANT)
#define LR_HAS_THREADS 0
#else
#define LR_HAS_THREADS 1
#include <thread>
#endif

// Without a futex, libstdc++ before 13 compares before it locks and notifies without the lock: wake-ups get lost, and both sides wait forever.
#if defined(_WIN32) && defined(__GLIBCXX__)
#define LR_WAITS_ON_ATOMICS 0
#include <condition_variable>
#include <mutex>
#else
#define LR_WAITS_ON_ATOMICS 1
#endif

namespace lr {

#if LR_HAS_THREADS
using ThreadId = std::thread::id;
inline ThreadId nobody() {
    return {};
}
inline ThreadId this_thread() {
    return std::this_thread::get_id();
}
inline unsigned hardware_threads() { // 0 if the system does not say
    return std::thread::hardware_concurrency();
}
#else
using ThreadId = int;
inline ThreadId nobody() {
    return -1;
}
inline ThreadId this_thread() {
    return 0;
}
inline unsigned hardware_threads() {
    return 1;
}
#endif

// A count that threads can wait for; replaces std::atomic's waits if these are unreliable.
#if LR_WAITS_ON_ATOMICS
using WaitedCount = std::atomic<uint32_t>;
#else
class WaitedCount : public std::atomic<uint32_t> {
public:
    using std::atomic<uint32_t>::atomic;

    // Waits until the count differs from `seen`; can also return earlier.
    void wait(uint32_t seen) const {
        std::unique_lock lock(mutex_);
        if (load(std::memory_order_acquire) == seen) changed_.wait(lock);
    }
    // With the lock: a thread that compared the count before it changed is asleep by now, and is woken.
    void notify_one() {
        const std::lock_guard lock(mutex_);
        changed_.notify_one();
    }
    void notify_all() {
        const std::lock_guard lock(mutex_);
        changed_.notify_all();
    }

private:
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
};
#endif
} // namespace lr
