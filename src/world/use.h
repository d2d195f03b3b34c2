// Who is inside a call on a world: misuse across threads and from callbacks, found where it was asked for.
#pragma once

#include "langevin_rigid.h"
#include "world/threads.h"

#include <atomic>
#include <cstdint>

struct lr_world;

namespace lr {

class Use {
public:
    // Before the world is anyone's.
    void check(uint32_t checks) { checked_ = (checks & LR_CHECK_THREADS) != 0; }
    bool checked() const { return checked_; }

    // LR_OK: the calling thread has it until leave(). Else who has: LR_ERROR_CONCURRENT_USE, LR_ERROR_REENTRANT.
    lr_status enter(const char* function) {
        ThreadId owner = nobody();
        const ThreadId self = this_thread();
        if (!owner_.compare_exchange_strong(owner, self, std::memory_order_acquire, std::memory_order_relaxed))
            return owner == self ? LR_ERROR_REENTRANT : LR_ERROR_CONCURRENT_USE;
        function_.store(function, std::memory_order_relaxed);
        return LR_OK;
    }
    void leave() {
        function_.store(nullptr, std::memory_order_relaxed);
        owner_.store(nobody(), std::memory_order_release);
    }
    const char* function() const { return function_.load(std::memory_order_relaxed); } // null: just between two

    // Whoever logs a refusal may be called again from the log's own callback: once is enough.
    bool begin_telling() { return !telling_.exchange(true, std::memory_order_relaxed); }
    void end_telling() { telling_.store(false, std::memory_order_relaxed); }

private:
    bool checked_ = false;
    std::atomic<ThreadId> owner_{nobody()};
    std::atomic<const char*> function_{nullptr};
    std::atomic<bool> telling_{false};
};

// Of a world that is checked: as Use::enter, and a refusal is logged.
lr_status enter(const lr_world& world, const char* function);

} // namespace lr
