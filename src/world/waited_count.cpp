#include "world/waited_count.h"

#if !LR_WAITS_ON_ATOMICS
#define WIN32_LEAN_AND_MEAN
#include <windows.h>

namespace lr {
namespace {

static_assert(sizeof(SRWLOCK) == sizeof(void*) && sizeof(CONDITION_VARIABLE) == sizeof(void*));
SRWLOCK* lock_in(void*& memory) {
    return reinterpret_cast<SRWLOCK*>(&memory); // both begin as null
}
CONDITION_VARIABLE* change_in(void*& memory) {
    return reinterpret_cast<CONDITION_VARIABLE*>(&memory);
}

} // namespace

void WaitedCount::wait(uint32_t seen) const {
    AcquireSRWLockExclusive(lock_in(lock_));
    if (count_.load(std::memory_order_acquire) == seen)
        SleepConditionVariableSRW(change_in(changed_), lock_in(lock_), INFINITE, 0);
    ReleaseSRWLockExclusive(lock_in(lock_));
}

// The lock, held for a moment after the count has changed: who has compared it before is asleep by then, and is woken.
void WaitedCount::notify_one() {
    AcquireSRWLockExclusive(lock_in(lock_));
    ReleaseSRWLockExclusive(lock_in(lock_));
    WakeConditionVariable(change_in(changed_));
}

void WaitedCount::notify_all() {
    AcquireSRWLockExclusive(lock_in(lock_));
    ReleaseSRWLockExclusive(lock_in(lock_));
    WakeAllConditionVariable(change_in(changed_));
}

} // namespace lr
#endif
