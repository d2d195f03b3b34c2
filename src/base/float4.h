// Four floats as a vector, so that loops over points do not depend on the compiler's vectoriser.
#pragma once

#include <cstdint>
#include <cstring>

namespace lr {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int32_t __attribute__((vector_size(16)));

inline Float4 all(float a) {
    return Float4{a, a, a, a};
}
inline Float4 load(const float* from) {
    Float4 a;
    std::memcpy(&a, from, sizeof a);
    return a;
}
inline void store(Float4 a, float* to) {
    std::memcpy(to, &a, sizeof a);
}
inline Float4 greater(Float4 a, Float4 b) {
    return a > b ? a : b;
}
inline Float4 less(Float4 a, Float4 b) {
    return a < b ? a : b;
}
inline float greatest(Float4 a) {
    const Float4 b = greater(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
    const float first = b[0], second = b[1];
    return first > second ? first : second;
}
inline float least(Float4 a) {
    const Float4 b = less(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
    const float first = b[0], second = b[1];
    return first < second ? first : second;
}

inline bool any(Int4 a) {
    using TwoInts = int64_t __attribute__((vector_size(16)));
    TwoInts halves;
    std::memcpy(&halves, &a, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

// Finds the index of the greatest of many values, offered four at a time.
struct Greatest {
    Float4 value;
    Int4 place{0, 1, 2, 3};

    explicit Greatest(Float4 first) : value(first) {}
    void offer(Float4 a, int32_t from) {
        const Int4 at = Int4{0, 1, 2, 3} + from, better = a > value;
        value = better ? a : value;
        place = better ? at : place;
    }
    // The greatest value, and the first index that has it.
    float get(uint32_t& at) const {
        Float4 v = value;
        Int4 p = place;
        const Float4 far = __builtin_shufflevector(v, v, 2, 3, 0, 1);
        const Int4 far_place = __builtin_shufflevector(p, p, 2, 3, 0, 1), better = far > v;
        v = better ? far : v;
        p = better ? far_place : p;
        const float first = v[0], second = v[1];
        const int32_t first_place = p[0], second_place = p[1];
        at = static_cast<uint32_t>(second > first ? second_place : first_place);
        return second > first ? second : first;
    }
};
} // namespace lr
