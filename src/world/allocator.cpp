#include "world/allocator.h"

#include <cstdlib>
#include <new>

namespace lr {

void* Allocator::allocate(size_t size, size_t alignment) {
    void* const memory = callbacks_.allocate
                             ? callbacks_.allocate(callbacks_.user, size, alignment)
                             : ::operator new(size, static_cast<std::align_val_t>(alignment), std::nothrow);
    if (memory) bytes_ += size;
    return memory;
}

void Allocator::release(void* memory, size_t size, size_t alignment) {
    if (!memory) return;
    bytes_ -= size;
    if (callbacks_.release)
        callbacks_.release(callbacks_.user, memory, size, alignment);
    else
        ::operator delete(memory, static_cast<std::align_val_t>(alignment));
}

} // namespace lr
