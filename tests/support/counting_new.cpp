#include "support/counting_memory.h"

#include <new>

namespace test {
std::atomic<uint64_t> global_allocations{0};
std::atomic<uint64_t> global_live{0};
std::atomic<uint64_t> global_fail_in{0};
} // namespace test

#if !defined(LR_SLOW_LIBRARY) && !defined(_WIN32)
namespace {

void* counted(size_t size, size_t alignment) {
    test::global_allocations.fetch_add(1);
    if (test::global_fail_in.load() != 0 && test::global_fail_in.fetch_sub(1) == 1) throw std::bad_alloc();
    const size_t whole = (size + alignment - 1) / alignment * alignment;
    void* const memory = std::aligned_alloc(alignment, whole == 0 ? alignment : whole);
    if (!memory) throw std::bad_alloc();
    test::global_live.fetch_add(1);
    return memory;
}
void discounted(void* memory) {
    if (memory) test::global_live.fetch_sub(1);
    std::free(memory);
}

} // namespace

// The standard library's nothrow and array forms call these.
void* operator new(size_t size) {
    return counted(size, alignof(std::max_align_t));
}
void* operator new(size_t size, std::align_val_t alignment) {
    return counted(size, static_cast<size_t>(alignment));
}
void operator delete(void* memory) noexcept {
    discounted(memory);
}
void operator delete(void* memory, size_t) noexcept {
    discounted(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    discounted(memory);
}
void operator delete(void* memory, size_t, std::align_val_t) noexcept {
    discounted(memory);
}
#endif
