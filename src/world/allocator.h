// The world's memory: the caller's allocator or the C library's, with what is taken counted.
#pragma once

#include "langevin_rigid.h"

#include <cstddef>
#include <cstdint>

namespace lr {

inline constexpr size_t block_alignment = 64; // a cache line, and the widest vector

class Allocator {
public:
    Allocator() = default;
    explicit Allocator(const lr_allocator& callbacks) : callbacks_(callbacks) {}

    void* allocate(size_t size, size_t alignment = block_alignment); // null when out of memory
    void release(void* memory, size_t size, size_t alignment = block_alignment);
    uint64_t bytes() const { return bytes_; }

private:
    lr_allocator callbacks_{};
    uint64_t bytes_ = 0;
};

// A fixed array from the world's allocator. Not resized in place: a new one is made and swapped in, so that running out
// of memory leaves the old one whole.
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
        Allocator* const a = allocator_;
        T* const d = data_;
        const size_t s = size_;
        allocator_ = other.allocator_, data_ = other.data_, size_ = other.size_;
        other.allocator_ = a, other.data_ = d, other.size_ = s;
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

// Room for so many at least, and an eighth more where it grows: nothing has to be copied, and what is never used is memory all the
// same. What was there is lost then. False when out of memory, and nothing has changed.
template <class T> bool grow(Allocator& allocator, Buffer<T>& buffer, size_t count) {
    if (buffer.size() >= count) return true;
    Buffer<T> larger;
    if (!larger.allocate(allocator, count + count / 8 + 1)) return false;
    buffer.swap(larger);
    return true;
}

} // namespace lr
