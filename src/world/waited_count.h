// A count that threads wait for: std::atomic's wait() and notify, where those can be relied on.
#pragma once

#include <atomic>
#include <cstdint>

// Where it has no futex, libstdc++ before 13 compares the value before it locks and notifies without the lock: a wake-up between
// the two is lost, and both sides wait for ever.
#if defined(_WIN32) && defined(__GLIBCXX__)
#define LR_WAITS_ON_ATOMICS 0
#else
#define LR_WAITS_ON_ATOMICS 1
#endif

namespace lr {

class WaitedCount {
public:
    uint32_t load(std::memory_order order) const { return count_.load(order); }
    void store(uint32_t count, std::memory_order order) { count_.store(count, order); }
    uint32_t fetch_add(uint32_t count, std::memory_order order) { return count_.fetch_add(count, order); }
    uint32_t fetch_sub(uint32_t count, std::memory_order order) { return count_.fetch_sub(count, order); }

    // Until it is not `seen`, or for no reason.
#if LR_WAITS_ON_ATOMICS
    void wait(uint32_t seen) const {
        count_.wait(seen, std::memory_order_acquire);
    }
    void notify_one() {
        count_.notify_one();
    }
    void notify_all() {
        count_.notify_all();
    }
#else
    void wait(uint32_t seen) const;
    void notify_one();
    void notify_all();
#endif

private:
    std::atomic<uint32_t> count_{0};
#if !LR_WAITS_ON_ATOMICS
    mutable void* lock_ = nullptr; // SRWLOCK and CONDITION_VARIABLE
    mutable void* changed_ = nullptr;
#endif
};

} // namespace lr
