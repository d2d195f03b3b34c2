// Replaces C++ exceptions, which this module lacks: a call that runs out of memory or finds a defect ends by an exception of the
// host. Memory that only this call owned leaks. The called object stays unchanged, because the library allocates all memory
// before it changes anything.
//
// SPDX-License-Identifier: MIT
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <new>

extern "C" {
[[noreturn, clang::import_module("langevin_rigid"), clang::import_name("out_of_memory")]] void host_out_of_memory();
[[noreturn, clang::import_module("langevin_rigid"), clang::import_name("defect")]] void host_defect();

// The C library's abort would end the whole module.
void abort() {
    host_defect();
}
}

namespace {

void* take(std::size_t size) {
    return std::malloc(size != 0 ? size : 1);
}

void* take(std::size_t size, std::align_val_t alignment) {
    const auto to = static_cast<std::size_t>(alignment);
    if (size > SIZE_MAX - to) return nullptr;
    return std::aligned_alloc(to, (size + to - 1) / to * to + (size == 0 ? to : 0));
}

void* needed(void* memory) {
    if (!memory) host_out_of_memory();
    return memory;
}

} // namespace

void* operator new(std::size_t size) {
    return needed(take(size));
}
void* operator new[](std::size_t size) {
    return needed(take(size));
}
void* operator new(std::size_t size, std::align_val_t alignment) {
    return needed(take(size, alignment));
}
void* operator new[](std::size_t size, std::align_val_t alignment) {
    return needed(take(size, alignment));
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    return take(size);
}
void* operator new[](std::size_t size, const std::nothrow_t&) noexcept {
    return take(size);
}
void* operator new(std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return take(size, alignment);
}
void* operator new[](std::size_t size, std::align_val_t alignment, const std::nothrow_t&) noexcept {
    return take(size, alignment);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t, std::align_val_t) noexcept {
    std::free(memory);
}
