// Four floats side by side, written out: what compilers make of loops over points is not left to them.
#pragma once

#include <cstdint>
#include <cstring>

namespace lr {

using Four = float __attribute__((vector_size(16)));
using FourInts = int32_t __attribute__((vector_size(16)));

inline Four all(float a) {
    return Four{a, a, a, a};
}
inline Four load(const float* from) {
    Four a;
    std::memcpy(&a, from, sizeof a);
    return a;
}
inline void store(Four a, float* to) {
    std::memcpy(to, &a, sizeof a);
}
inline Four greater(Four a, Four b) {
    return a > b ? a : b;
}
inline Four less(Four a, Four b) {
    return a < b ? a : b;
}
inline float greatest(Four a) {
    const Four b = greater(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
    const float first = b[0], second = b[1];
    return first > second ? first : second;
}
inline float least(Four a) {
    const Four b = less(a, __builtin_shufflevector(a, a, 2, 3, 0, 1));
    const float first = b[0], second = b[1];
    return first < second ? first : second;
}

// Whether any lane of a comparison holds.
inline bool any(FourInts a) {
    using TwoInts = int64_t __attribute__((vector_size(16)));
    TwoInts halves;
    std::memcpy(&halves, &a, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

// The place of the greatest of many values, offered four at a time.
struct Greatest {
    Four value;
    FourInts place{0, 1, 2, 3};

    explicit Greatest(Four first) : value(first) {}
    void offer(Four a, int32_t from) {
        const FourInts at = FourInts{0, 1, 2, 3} + from, better = a > value;
        value = better ? a : value;
        place = better ? at : place;
    }
    // The first lane with it.
    float get(uint32_t& at) const {
        Four v = value;
        FourInts p = place;
        const Four far = __builtin_shufflevector(v, v, 2, 3, 0, 1);
        const FourInts far_place = __builtin_shufflevector(p, p, 2, 3, 0, 1), better = far > v;
        v = better ? far : v;
        p = better ? far_place : p;
        const float first = v[0], second = v[1];
        const int32_t first_place = p[0], second_place = p[1];
        at = static_cast<uint32_t>(second > first ? second_place : first_place);
        return second > first ? second : first;
    }
};

} // namespace lr
