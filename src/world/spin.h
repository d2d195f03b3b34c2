// Waiting for what comes within microseconds, where a sleep would cost more than that.
#pragma once

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <emmintrin.h>
#endif

namespace lr {

inline void pause_processor() {
#if defined(__SSE2__) || defined(_M_X64)
    _mm_pause();
#elif defined(__aarch64__)
    __asm__ volatile("yield");
#endif
}

// Some tens of microseconds: the length of a chunk, and what waking a thread costs. A pause is 40 to 140 cycles on x86.
inline constexpr uint32_t spins = 1000;

// False when it has not come in that time.
template <class Ready> bool spin_until(const Ready& ready) {
    for (uint32_t i = 0; i < spins; ++i) {
        if (ready()) return true;
        pause_processor();
    }
    return ready();
}

} // namespace lr
