// Counts allocations, remembers each block's size and alignment, and fails on demand.
#pragma once

#include "langevin_rigid.h"
#include "support/quick.h"

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <cstring>

namespace test {

// Windows has no aligned_alloc().
inline void* aligned_memory(size_t alignment, size_t size) {
#ifdef _WIN32
    return _aligned_malloc(size, alignment);
#else
    return std::aligned_alloc(alignment, size);
#endif
}
inline void free_aligned(void* memory) {
#ifdef _WIN32
    _aligned_free(memory);
#else
    std::free(memory);
#endif
}

class CountingAllocator {
public:
    static constexpr uint64_t never = UINT64_MAX;

    lr_allocator callbacks() { return {this, &allocate, &release}; }

    uint64_t calls = 0;       // number of calls of allocate
    uint64_t fail_at = never; // number of the call that returns null, from 0
    bool fail_after = false;  // and all later calls
    uint64_t bytes = 0;       // in use
    bool mismatch = false;    // a block came back with another size or alignment, or from elsewhere
    size_t live() const { return blocks_; }

private:
    // Each request is stored in front of its block, so that counting does not use operator new.
    struct Block {
        CountingAllocator* owner;
        uint64_t size, alignment;
    };
    static constexpr uint64_t front = 128;

    static void* allocate(void* user, uint64_t size, uint64_t alignment) {
        auto& self = *static_cast<CountingAllocator*>(user);
        const uint64_t call = self.calls++;
        if (call == self.fail_at || (self.fail_after && call > self.fail_at)) return nullptr;
        if (size == 0 || alignment == 0 || alignment > front || (alignment & (alignment - 1)) != 0) {
            self.mismatch = true;
            return nullptr;
        }
        auto* const whole = static_cast<unsigned char*>(aligned_memory(front, (front + size + 127) / 128 * 128));
        if (!whole) return nullptr;
        std::memset(whole, 0xa5, front + size); // fresh memory, never zero
        const Block block{&self, size, alignment};
        std::memcpy(whole, &block, sizeof block);
        ++self.blocks_;
        self.bytes += size;
        return whole + front;
    }
    static void release(void* user, void* memory, uint64_t size, uint64_t alignment) {
        auto& self = *static_cast<CountingAllocator*>(user);
        unsigned char* const whole = static_cast<unsigned char*>(memory) - front;
        Block block;
        std::memcpy(&block, whole, sizeof block);
        if (block.owner != &self || block.size != size || block.alignment != alignment) {
            self.mismatch = true;
            return;
        }
        std::memset(whole, 0x5a, front); // so that a second release is a mismatch
        --self.blocks_;
        self.bytes -= size;
        free_aligned(whole);
    }

    size_t blocks_ = 0;
};

// Calls of the global operator new in this process, including the library's: support/counting_new.cpp. Sanitizers keep their own operator new, and a
// DLL of Windows has its own.
#ifdef _WIN32
inline constexpr bool counts_global = false;
#else
inline const bool counts_global = !quick();
#endif
extern std::atomic<uint64_t> global_allocations;
extern std::atomic<uint64_t> global_live;
// Counts down to the call of operator new that throws; 0: none.
extern std::atomic<uint64_t> global_fail_in;

} // namespace test
