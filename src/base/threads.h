// Threads, waiting, yielding and the clock of this platform. LR_NO_OS: none of these; workers come only from lr_job_system.
#pragma once

#include <atomic>
#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#elif defined(_M_ARM64)
#include <intrin.h>
#endif

// WebAssembly built without -pthread has no threads, nor the headers for them.
#if defined(LR_NO_OS) || (defined(__wasm__) && !defined(_REENTRANT))
#define LR_HAS_THREADS 0
#else
#define LR_HAS_THREADS 1
#include <thread>
#endif
#if !defined(LR_NO_OS)
#include <chrono>
#endif

// libstdc++ before 13 without a futex compares before it locks, and notifies without the lock: wake-ups get lost, and both sides wait forever.
#if defined(LR_NO_OS) || (defined(_WIN32) && defined(__GLIBCXX__))
#define LR_WAITS_ON_ATOMICS 0
#else
#define LR_WAITS_ON_ATOMICS 1
#endif
#if !LR_WAITS_ON_ATOMICS && !defined(LR_NO_OS)
#include <condition_variable>
#include <mutex>
#endif

#if defined(_MSC_VER) && !defined(__clang__) // a hint, which Microsoft's compiler lacks
#define __builtin_prefetch(address) ((void)(address))
#endif

namespace lr {

inline void pause_processor() {
#if defined(__SSE2__) || defined(_M_X64)
    _mm_pause();
#elif defined(_M_ARM64)
    __yield();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

// The address of a thread-local variable identifies the thread.
using ThreadId = const void*;
inline ThreadId this_thread() {
    static thread_local char here;
    return &here;
}
inline unsigned hardware_threads() { // 0 if the system does not say
#if LR_HAS_THREADS
    return std::thread::hardware_concurrency();
#else
    return 1;
#endif
}
inline double clock_seconds() { // from an arbitrary start; 0 without a system
#if defined(LR_NO_OS)
    return 0.0;
#else
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
#endif
}

// A count that threads can wait for; replaces the waits of std::atomic where these are unreliable.
#if LR_WAITS_ON_ATOMICS
using WaitedCount = std::atomic<uint32_t>;
#elif defined(LR_NO_OS)
class WaitedCount : public std::atomic<uint32_t> {
public:
    using std::atomic<uint32_t>::atomic;

    void wait(uint32_t) const { pause_processor(); }
    void notify_one() {}
    void notify_all() {}
};
#else
class WaitedCount : public std::atomic<uint32_t> {
public:
    using std::atomic<uint32_t>::atomic;

    // Waits until the count differs from `seen`; can also return earlier.
    void wait(uint32_t seen) const {
        std::unique_lock lock(mutex_);
        if (load(std::memory_order_acquire) == seen) changed_.wait(lock);
    }
    // With the lock, so that a thread that compared the count before the change is asleep by now, and is woken.
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
