// Floating-point mode of a step: IEEE default, round to nearest, gradual underflow, no traps. Flushing denormals could be faster, but processors
// flush differently, and WebAssembly does not (docs/maintainers/numerics.md).
#pragma once

#include <cstdint>

#if defined(__SSE2__) || defined(_M_X64)
#include <xmmintrin.h>
#endif

namespace lr {

// Sets the mode on this thread for its lifetime, then restores the caller's.
class FloatMode {
public:
    // Writes only if needed, because writing is slow; exception flags are no part of the mode.
    FloatMode() : saved_(read()) {
        if ((saved_ & ~flags) != standard) write(standard);
    }
    ~FloatMode() {
        if (read() != saved_) write(saved_);
    }
    FloatMode(const FloatMode&) = delete;
    FloatMode& operator=(const FloatMode&) = delete;

private:
    friend class CallersMode;
#if defined(__SSE2__) || defined(_M_X64)
    using Word = uint32_t;
    static constexpr Word standard = 0x1f80, flags = 0x3f;
    static Word read() {
        return _mm_getcsr();
    }
    static void write(Word w) {
        _mm_setcsr(w);
    }
#elif defined(__aarch64__)
    using Word = uint64_t;
    static constexpr Word standard = 0, flags = 0;
    static Word read() {
        Word w;
        __asm__ volatile("mrs %0, fpcr" : "=r"(w));
        return w;
    }
    static void write(Word w) {
        __asm__ volatile("msr fpcr, %0" : : "r"(w));
    }
#else // WebAssembly has one mode only
    using Word = uint32_t;
    static constexpr Word standard = 0, flags = 0;
    static Word read() {
        return 0;
    }
    static void write(Word) {}
#endif
    Word saved_;
};

// Restores the caller's mode for its lifetime, within that of a FloatMode, while the caller's code runs.
class CallersMode {
public:
    explicit CallersMode(const FloatMode& mode) { FloatMode::write(mode.saved_); }
    ~CallersMode() { FloatMode::write(FloatMode::standard); }
    CallersMode(const CallersMode&) = delete;
    CallersMode& operator=(const CallersMode&) = delete;
};
} // namespace lr
