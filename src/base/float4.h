// Vectors of four floats, so that loops over points do not depend on the compiler's vectoriser. Compilers without vector extensions (Microsoft's) get
// an array with the same operators.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>

namespace lr {

#if (defined(__GNUC__) || defined(__clang__)) && !defined(LR_PLAIN_FLOAT4)
using Float4 = float __attribute__((vector_size(16)));
using Int4 = int32_t __attribute__((vector_size(16)));

template <int A, int B, int C, int D, class V> V shuffled(V v) {
    return __builtin_shufflevector(v, v, A, B, C, D);
}
inline Float4 choose(Int4 where, Float4 a, Float4 b) {
    return where ? a : b;
}
inline Int4 choose(Int4 where, Int4 a, Int4 b) {
    return where ? a : b;
}
#else
template <class T> struct alignas(16) FourLanes {
    T lane[4];
    T operator[](size_t i) const { return lane[i]; }
};
using Float4 = FourLanes<float>;
using Int4 = FourLanes<int32_t>;

template <class T, class Function> auto by_lane(FourLanes<T> a, FourLanes<T> b, Function f) {
    return FourLanes<decltype(f(a[0], b[0]))>{{f(a[0], b[0]), f(a[1], b[1]), f(a[2], b[2]), f(a[3], b[3])}};
}
template <class T> FourLanes<T> same_lanes(T a) {
    return {{a, a, a, a}};
}
#define LR_LANE_OPERATOR(op, T, expression)                                                                            \
    inline auto operator op(FourLanes<T> a, FourLanes<T> b) {                                                          \
        return by_lane(a, b, [](T x, T y) { return expression; });                                                     \
    }                                                                                                                  \
    inline auto operator op(T a, FourLanes<T> b) {                                                                     \
        return same_lanes(a) op b;                                                                                     \
    }                                                                                                                  \
    inline auto operator op(FourLanes<T> a, T b) {                                                                     \
        return a op same_lanes(b);                                                                                     \
    }
LR_LANE_OPERATOR(+, float, x + y)
LR_LANE_OPERATOR(-, float, x - y)
LR_LANE_OPERATOR(*, float, x* y)
LR_LANE_OPERATOR(<, float, -int32_t{x < y})
LR_LANE_OPERATOR(>, float, -int32_t{x > y})
LR_LANE_OPERATOR(<=, float, -int32_t{x <= y})
LR_LANE_OPERATOR(>=, float, -int32_t{x >= y})
LR_LANE_OPERATOR(+, int32_t, x + y)
LR_LANE_OPERATOR(&, int32_t, x& y)
LR_LANE_OPERATOR(|, int32_t, x | y)
#undef LR_LANE_OPERATOR
inline Float4 operator-(Float4 a) {
    return {{-a[0], -a[1], -a[2], -a[3]}};
}
inline Int4 operator~(Int4 a) {
    return {{~a[0], ~a[1], ~a[2], ~a[3]}};
}
inline Int4& operator&=(Int4& a, Int4 b) {
    return a = a & b;
}
inline Int4& operator|=(Int4& a, Int4 b) {
    return a = a | b;
}
template <int A, int B, int C, int D, class V> V shuffled(V v) {
    return {{v[A], v[B], v[C], v[D]}};
}
template <class V> V choose(Int4 where, V a, V b) {
    V chosen = b;
    for (size_t i = 0; i < 4; ++i)
        if (where[i] != 0) chosen.lane[i] = a[i];
    return chosen;
}
#endif

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
    return choose(a > b, a, b);
}
inline Float4 less(Float4 a, Float4 b) {
    return choose(a < b, a, b);
}
inline float greatest(Float4 a) {
    const Float4 b = greater(a, shuffled<2, 3, 0, 1>(a));
    const float first = b[0], second = b[1];
    return first > second ? first : second;
}
inline float least(Float4 a) {
    const Float4 b = less(a, shuffled<2, 3, 0, 1>(a));
    const float first = b[0], second = b[1];
    return first < second ? first : second;
}

inline bool any(Int4 a) {
    int64_t halves[2];
    std::memcpy(halves, &a, sizeof halves);
    return (halves[0] | halves[1]) != 0;
}

// Finds the index of the greatest of many values, offered four at a time.
struct Greatest {
    Float4 value;
    Int4 place{0, 1, 2, 3};

    explicit Greatest(Float4 first) : value(first) {}
    void offer(Float4 a, int32_t from) {
        const Int4 at = Int4{0, 1, 2, 3} + from, better = a > value;
        value = choose(better, a, value);
        place = choose(better, at, place);
    }
    // The greatest value, and the first index that has it.
    float get(uint32_t& at) const {
        Float4 v = value;
        Int4 p = place;
        const Float4 far = shuffled<2, 3, 0, 1>(v);
        const Int4 far_place = shuffled<2, 3, 0, 1>(p), better = far > v;
        v = choose(better, far, v);
        p = choose(better, far_place, p);
        const float first = v[0], second = v[1];
        const int32_t first_place = p[0], second_place = p[1];
        at = static_cast<uint32_t>(second > first ? second_place : first_place);
        return second > first ? second : first;
    }
};
} // namespace lr
