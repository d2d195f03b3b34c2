// Functions of kernel/math/test_lanes.cpp for the tests beside it.
#pragma once

#include "base/lane_arrays.h"

#include <cstddef>
#include <cstdint>
#include <new>
#include <vector>

using lr::lane_block;

namespace test {

struct Lanes {
    const char* name;
    void (*log)(const float* x, float* out, size_t n);
    void (*sin_cos)(const float* turn, float* sine, float* cosine, size_t n);
    void (*philox)(const uint32_t* counter, uint64_t key, uint32_t* out);
    void (*words)(const uint32_t* keys, uint64_t substep, uint64_t seed, uint32_t* out, size_t n);
    // words: four arrays of n; out: three.
    void (*angles)(const uint32_t* words, uint32_t* out, size_t n);
    void (*squared_radius)(const uint32_t* word, float* out, size_t n);
    void (*pair)(const uint32_t* word, const uint32_t* angle, float* first, float* second, size_t n);
    void (*gaussians)(const uint32_t* keys, uint64_t substep, uint64_t seed, float* out, size_t n);
    void (*three_gaussians)(const uint32_t* keys, uint64_t substep, uint64_t seed, float* out, size_t n);
};

// For this processor and build, best first; plain C++ last.
std::vector<Lanes> lanes();

template <class T> struct LaneAllocator {
    using value_type = T;
    LaneAllocator() = default;
    template <class U> LaneAllocator(const LaneAllocator<U>&) {}
    T* allocate(size_t n) { return static_cast<T*>(::operator new (n * sizeof(T), std::align_val_t{64})); }
    void deallocate(T* p, size_t) { ::operator delete (p, std::align_val_t{64}); }
    bool operator==(const LaneAllocator&) const { return true; }
};
template <class T> using Aligned = std::vector<T, LaneAllocator<T>>;

} // namespace test
