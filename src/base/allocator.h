// The world's memory: the caller's allocator or the C library's, with a count of the bytes in use.
#pragma once

#include "langevin_rigid.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <new>
#include <utility>

namespace lr {

inline constexpr size_t block_alignment = 64; // a cache line, and the widest vector

class Allocator {
public:
    Allocator() = default;
    explicit Allocator(const lr_allocator& callbacks) : callbacks_(callbacks) {}

    // Null when out of memory.
    void* allocate(size_t size) {
        void* const memory = callbacks_.allocate ? callbacks_.allocate(callbacks_.user, size, block_alignment)
                                                 : ::operator new(size, alignment, std::nothrow);
        if (memory) bytes_ += size;
        return memory;
    }
    void release(void* memory, size_t size) {
        if (!memory) return;
        bytes_ -= size;
        if (callbacks_.release)
            callbacks_.release(callbacks_.user, memory, size, block_alignment);
        else
            ::operator delete(memory, alignment);
    }
    uint64_t bytes() const { return bytes_; }

    // Creates a T, null when out of memory; destroys it.
    template <class T, class... A> T* make(A&&... arguments) {
        void* const memory = allocate(sizeof(T));
        return memory ? new (memory) T(std::forward<A>(arguments)...) : nullptr;
    }
    template <class T> void end(T* one) {
        one->~T();
        release(one, sizeof(T));
    }

private:
    static constexpr auto alignment = static_cast<std::align_val_t>(block_alignment);

    lr_allocator callbacks_{};
    uint64_t bytes_ = 0;
};

// A fixed array from the world's allocator. It grows by swapping in a new one, so that running out of memory leaves the old one intact.
template <class T> class Buffer {
public:
    Buffer() = default;
    Buffer(const Buffer&) = delete;
    Buffer& operator=(const Buffer&) = delete;
    ~Buffer() { reset(); }

    bool allocate(Allocator& from, uint64_t count) {
        reset();
        if (count == 0) return true;
        constexpr size_t size_of_one = sizeof(T); // NOLINT(bugprone-sizeof-expression): pointers too
        if (count > SIZE_MAX / size_of_one) return false;
        data_ = static_cast<T*>(from.allocate(static_cast<size_t>(count) * size_of_one));
        if (!data_) return false;
        allocator_ = &from;
        size_ = static_cast<size_t>(count);
        return true;
    }
    void reset() {
        if (data_) allocator_->release(data_, size_ * sizeof(T)); // NOLINT(bugprone-sizeof-expression)
        data_ = nullptr;
        size_ = 0;
    }
    void swap(Buffer& other) {
        std::swap(allocator_, other.allocator_);
        std::swap(data_, other.data_);
        std::swap(size_, other.size_);
    }
    T* data() { return data_; }
    const T* data() const { return data_; }
    size_t size() const { return size_; }
    // i < size(), so that data_ is not null: the analyzer cannot know.
    T& operator[](size_t i) { return data_[i]; }             // NOLINT(clang-analyzer-core.uninitialized.UndefReturn)
    const T& operator[](size_t i) const { return data_[i]; } // NOLINT(clang-analyzer-core.uninitialized.UndefReturn)

private:
    Allocator* allocator_ = nullptr;
    T* data_ = nullptr;
    size_t size_ = 0;
};

// One T from the world's allocator, or none.
template <class T> class Owned {
public:
    Owned() = default;
    Owned(const Owned&) = delete;
    Owned& operator=(const Owned&) = delete;
    ~Owned() { reset(); }

    // Creates the T, which reserves its own memory by T::allocate(from, arguments...). False when out of memory; nothing has then changed.
    template <class... A> bool reserve(Allocator& from, const A&... arguments) {
        if (one_) return true;
        one_ = from.make<T>();
        if (!one_) return false;
        allocator_ = &from;
        const bool whole = one_->allocate(from, arguments...);
        if (!whole) reset();
        return whole;
    }
    void reset() {
        if (one_) allocator_->end(one_);
        one_ = nullptr;
    }
    T* get() const { return one_; }
    T* operator->() const { return one_; }
    explicit operator bool() const { return one_ != nullptr; }

private:
    Allocator* allocator_ = nullptr;
    T* one_ = nullptr;
};

// Makes room for at least `count`, with an eighth to spare, and drops the contents if it grows. False when out of memory; nothing has then changed.
template <class T> bool grow(Allocator& allocator, Buffer<T>& buffer, size_t count) {
    if (buffer.size() >= count) return true;
    Buffer<T> larger;
    if (!larger.allocate(allocator, count + count / 8 + 1)) return false;
    buffer.swap(larger);
    return true;
}

// Keeps the first `used` elements and adds no spare room. False when out of memory; nothing has then changed.
template <class T> bool enlarge(Allocator& allocator, Buffer<T>& buffer, uint64_t size, size_t used) {
    if (size <= buffer.size()) return true;
    Buffer<T> larger;
    if (!larger.allocate(allocator, size)) return false;
    std::copy_n(buffer.data(), used, larger.data());
    buffer.swap(larger);
    return true;
}

// A list filled during a step and valid until the next one, of fixed capacity.
template <class T> struct StepList {
    Buffer<T> items;
    uint32_t count = 0;

    // False if there is no room.
    bool add(const T& item) {
        if (count == items.size()) return false;
        items[count++] = item;
        return true;
    }
};

// LR_ERROR_OUT_OF_MEMORY if `body` throws bad_alloc. WebAssembly has no exceptions, and operator new ends the call (bindings/web/native/memory.cpp).
template <class F> lr_status unless_out_of_memory(F&& body) {
#if defined(__cpp_exceptions)
    try {
        return std::forward<F>(body)();
    } catch (const std::bad_alloc&) {
        return LR_ERROR_OUT_OF_MEMORY;
    }
#else
    return std::forward<F>(body)();
#endif
}
} // namespace lr
