// Memory for the large temporaries of a step, which would take half a megabyte of stack. Threads of macOS have 512 KB, task threads of some
// engines 384 KB.
#pragma once

#include "base/allocator.h"
#include "base/threads.h"

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

namespace lr {

// Memory of one thread at a time: what is taken last is given back first.
class Scratch {
public:
    static constexpr size_t bytes = size_t{640} * 1024; // the deepest nest takes 634 (tests/base/test_scratch.cpp)

    // Of this thread; null outside a lease.
    static Scratch*& here() {
        // Null. With `= nullptr` the static library for Windows has a global symbol for it.
        static thread_local Scratch* scratch;
        return scratch;
    }
    void* take(size_t size) {
        void* const at = memory + used;
        used += size;
        return at;
    }
    void give(size_t size) { used -= size; }

    unsigned char* memory = nullptr;
    size_t used = 0;
    std::atomic<bool> leased{false};
};

// Scratch for each thread of a world.
class ScratchPool {
public:
    static constexpr uint32_t most = 65;

    // For so many threads, once. False when out of memory.
    bool reserve(Allocator& allocator, uint32_t threads) {
        if (count_ != 0) return true;
        if (!memory_.allocate(allocator, uint64_t{threads} * Scratch::bytes)) return false;
        count_ = threads;
        for (uint32_t i = 0; i < threads; ++i) each_[i].memory = memory_.data() + i * Scratch::bytes;
        return true;
    }
    void reset() {
        count_ = 0;
        memory_.reset();
    }
    // Its own if it is free: a job system may run an index twice. Null if none was allocated, for tasks that need none.
    Scratch* lease(uint32_t thread) {
        for (; count_ != 0; pause_processor())
            for (uint32_t i = 0; i < count_; ++i)
                if (Scratch& one = each_[(thread + i) % count_]; !one.leased.exchange(true, std::memory_order_acquire))
                    return &one;
        return nullptr;
    }

private:
    Buffer<unsigned char> memory_;
    uint32_t count_ = 0;
    std::array<Scratch, most> each_;
};

// Gives this thread scratch. The lease before, of another world whose callback steps this one, comes back afterwards.
class ScratchLease {
public:
    ScratchLease(ScratchPool& pool, uint32_t thread) : before_(std::exchange(Scratch::here(), pool.lease(thread))) {}
    ~ScratchLease() {
        Scratch* const own = std::exchange(Scratch::here(), before_);
        if (own) own->leased.store(false, std::memory_order_release);
    }
    ScratchLease(const ScratchLease&) = delete;
    ScratchLease& operator=(const ScratchLease&) = delete;

private:
    Scratch* before_;
};

// A large temporary in this thread's scratch.
template <class T> class InScratch {
public:
    static constexpr size_t size = (sizeof(T) + block_alignment - 1) / block_alignment * block_alignment;

    template <class... A> explicit InScratch(A&&... arguments) {
        void* const at = Scratch::here()->take(size);
        if constexpr (sizeof...(A) == 0)
            one_ = new (at) T; // not cleared
        else
            one_ = new (at) T(std::forward<A>(arguments)...);
    }
    ~InScratch() {
        one_->~T();
        Scratch::here()->give(size);
    }
    InScratch(const InScratch&) = delete;
    InScratch& operator=(const InScratch&) = delete;
    T& operator*() const { return *one_; }
    T* operator->() const { return one_; }

private:
    T* one_;
};
} // namespace lr
