// A world's memory: counted, bounded, with checked releases, and failing on request.
#pragma once

#include "fuzz/api/expect.h"

#include <map>

namespace fuzz {

class Memory {
public:
    static constexpr uint64_t most = uint64_t{1} << 22;

    lr_allocator hooks() { return {this, &allocate, &release}; }
    uint64_t live() const { return live_; }
    // The n-th allocation from now on fails; 0: none.
    void fail_after(uint32_t n) { countdown_ = n; }
    void begin() { refused_ = false; }
    bool refused() const { return refused_; }
    bool armed() const { return countdown_ != 0; }

private:
    static void* allocate(void* user, uint64_t size, uint64_t alignment) {
        Memory& m = *static_cast<Memory*>(user);
        if (alignment == 0 || alignment > 128 || (alignment & (alignment - 1)) != 0)
            defect("the allocator", "alignment", static_cast<int64_t>(alignment));
        if ((m.countdown_ != 0 && --m.countdown_ == 0) || size > most || m.live_ + size > most) {
            m.refused_ = true;
            return nullptr;
        }
        void* memory = nullptr;
        if (posix_memalign(&memory, alignment < sizeof(void*) ? sizeof(void*) : alignment, size == 0 ? 1 : size) != 0)
            return nullptr;
        std::memset(memory, 0xa5, size);
        m.blocks_[memory] = {size, alignment};
        m.live_ += size;
        return memory;
    }
    static void release(void* user, void* memory, uint64_t size, uint64_t alignment) {
        Memory& m = *static_cast<Memory*>(user);
        const auto block = m.blocks_.find(memory);
        if (block == m.blocks_.end()) defect("the allocator", "released what was not allocated");
        if (block->second != std::pair(size, alignment)) defect("the allocator", "released with another size");
        m.live_ -= size;
        m.blocks_.erase(block);
        std::free(memory);
    }

    std::map<void*, std::pair<uint64_t, uint64_t>> blocks_;
    uint64_t live_ = 0;
    uint32_t countdown_ = 0;
    bool refused_ = false;
};

} // namespace fuzz
