// Divergence: the limits of a body's state, and how a diverged body is held: at its last valid pose, still, marked (docs/reference/bodies.md).
#pragma once

#include "base/lane_arrays.h"
#include "hwy/base.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace lr {

// Beyond anything that calls accept: only numerical errors or absurd forces carry a body that far or make it that fast.
inline constexpr float farthest_place = 1e10f;  // m, each coordinate
inline constexpr float fastest_squared = 4e12f; // (2e6 m/s)^2
// (1e9 rad/s)^2: a body a hundredth of a millimetre thin flutters at some 1e7 rad/s.
inline constexpr float fastest_spin_squared = 1e18f;
inline constexpr float shortest_turn = 0.98f, longest_turn = 1.02f; // squares of a unit quaternion's length

// Marks in place of the age's rounding: of a held body, and of a body that the end of the step will hold.
inline constexpr float held_mark = -1e30f, diverged_mark = -2e30f, least_age_remainder = -1e29f;
inline bool is_held(float age_remainder) {
    return age_remainder <= least_age_remainder;
}

// The same bits as in kernel/integrator/equations_of_motion-inl.h. gusts: the body has a wake velocity.
inline bool is_sane(const BatchArrays& a, size_t i, bool gusts) {
    const auto at = [&](size_t field) { return a.field[field][i]; };
    const auto size = [](float x) { return x < 0.0f ? -x : x; };
    const auto squared = [&](size_t f) { return at(f) * at(f) + (at(f + 1) * at(f + 1) + at(f + 2) * at(f + 2)); };
    const float turn = at(field_qx) * at(field_qx) +
                       (at(field_qy) * at(field_qy) + (at(field_qz) * at(field_qz) + at(field_qw) * at(field_qw)));
    bool sane = turn >= shortest_turn && turn <= longest_turn; // false for NaN, like the others
    for (size_t f = field_x; f <= field_z; ++f) sane = sane && size(at(f)) <= farthest_place;
    sane = sane && squared(field_vx) <= fastest_squared && squared(field_wx) <= fastest_spin_squared;
    return sane && (!gusts || squared(field_gust_x) <= fastest_squared);
}

// Call after each change that can make a body diverge. Returns whether it is held. before(field): its last valid values, from x to w of its
// orientation. faults: set if it diverged; can be null.
template <class Before>
bool hold_if_insane(const BatchArrays& a, size_t i, uint32_t* faults, const Before& before, bool gusts = false) {
    const float age_remainder = a.field[field_age_remainder][i];
    const bool held = is_held(age_remainder);
    if (!held && is_sane(a, i, gusts)) return false;
    for (size_t f = field_x; f <= field_qw; ++f) a.field[f][i] = before(f);
    for (size_t f = field_vx; f <= field_wz; ++f) a.field[f][i] = 0.0f;
    for (size_t f = field_gust_x; f < field_count && a.field[f]; ++f) a.field[f][i] = 0.0f;
    a.field[field_age_remainder][i] = held ? age_remainder : diverged_mark;
    if (!held && faults) __atomic_store_n(faults, 1u, __ATOMIC_RELAXED); // any thread
    return true;
}

// The former state of a vector's bodies, for those that diverge.
class BodiesBefore {
public:
    HWY_NOINLINE void take(const BatchArrays& a, size_t begin, size_t count) {
        for (size_t f = 0; f < field_count; ++f)
            if (a.field[f]) std::copy_n(a.field[f] + begin, count, value_[f]);
    }
    // a: their present state; seconds: since then; gusts: as in is_sane().
    HWY_NOINLINE void hold(const BatchArrays& a, size_t begin, size_t count, float seconds, bool gusts,
                           uint32_t* faults) {
        for (size_t i = 0; i < count; ++i) {
            const float age = value_[field_age][i], age_remainder = value_[field_age_remainder][i];
            if (is_held(age_remainder)) {
                a.field[field_age][begin + i] = age + seconds;
                a.field[field_age_remainder][begin + i] = age_remainder;
            }
            hold_if_insane(
                a, begin + i, faults, [&](size_t f) { return value_[f][i]; }, gusts);
        }
    }

private:
    float value_[field_count][lane_block];
};
} // namespace lr
