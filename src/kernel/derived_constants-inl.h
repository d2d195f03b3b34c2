// Constants of a body that follow from others: in double for a batch, in vectors for bodies in two fluids. N: number type; zero, one: its constants.
#if defined(LR_KERNEL_DERIVED_CONSTANTS_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef LR_KERNEL_DERIVED_CONSTANTS_INL_H_
#undef LR_KERNEL_DERIVED_CONSTANTS_INL_H_
#else
#define LR_KERNEL_DERIVED_CONSTANTS_INL_H_
#endif

#include "hwy/highway.h"
#include "kernel/body_constants.h"

#include <cstddef>

HWY_BEFORE_NAMESPACE();
namespace lr::HWY_NAMESPACE {

template <class N> HWY_INLINE N dot3(const N* a, const N* b) {
    return a[0] * b[0] + (a[1] * b[1] + a[2] * b[2]);
}
template <class N> HWY_INLINE void cross3(const N* a, const N* b, N* out) {
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = a[j] * b[k] - a[k] * b[j];
    }
}

// Symmetric matrices by their upper triangles, row by row.
template <class N> HWY_INLINE void times_symmetric3(const N* m, const N* a, N* out) {
    constexpr size_t at[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    for (size_t i = 0; i < 3; ++i) out[i] = m[at[i][0]] * a[0] + (m[at[i][1]] * a[1] + m[at[i][2]] * a[2]);
}
template <class N> HWY_INLINE void times_symmetric6(const N* m, const N* a, N* out) {
    for (size_t i = 0; i < 6; ++i) {
        N sum = m[upper6[i][0]] * a[0];
        for (size_t j = 1; j < 6; ++j) sum = m[upper6[i][j]] * a[j] + sum;
        out[i] = sum;
    }
}
template <class N> HWY_INLINE void invert_symmetric3(const N* m, N one, N* out) {
    const N xx = m[3] * m[5] - m[4] * m[4], xy = m[2] * m[4] - m[1] * m[5], xz = m[1] * m[4] - m[2] * m[3];
    const N inverse = one / (m[0] * xx + (m[1] * xy + m[2] * xz));
    out[0] = inverse * xx;
    out[1] = inverse * xy;
    out[2] = inverse * xz;
    out[3] = inverse * (m[0] * m[5] - m[2] * m[2]);
    out[4] = inverse * (m[1] * m[2] - m[0] * m[4]);
    out[5] = inverse * (m[0] * m[3] - m[1] * m[1]);
}

// Diagonal path, from the masses.
template <class N> HWY_INLINE void set_turning(BodyConstantsOf<N>& c) {
    for (size_t i = 0; i < 3; ++i) {
        const size_t j = (i + 1) % 3, k = (i + 2) % 3;
        c.gyroscopic[i] = (c.spin_mass[j] - c.spin_mass[k]) * c.inverse_spin_mass[i];
        c.munk[i] = (c.mass[j] - c.mass[k]) * c.inverse_spin_mass[i];
        c.munk_turn[i] = c.munk[i] * c.inverse_mass[j];
        c.munk_turn[i + 3] = c.munk[i] * c.inverse_mass[k];
    }
}

// Full path, from the mass matrix.
template <class N> HWY_INLINE void set_slip(N one, BodyConstantsOf<N>& c) {
    const N* const m = c.full_mass;
    const N first[6] = {m[0], m[1], m[2], m[6], m[7], m[11]}, rotation[6] = {m[15], m[16], m[17], m[18], m[19], m[20]};
    invert_symmetric3(first, one, c.inverse_translation);
    const N coupling[3][3] = {{m[3], m[8], m[12]}, {m[4], m[9], m[13]}, {m[5], m[10], m[14]}}; // columns of M12
    for (size_t i = 0; i < 3; ++i) times_symmetric3(c.inverse_translation, coupling[i], c.slip + 3 * i);
    for (size_t i = 0, n = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j, ++n) c.reduced_rotation[n] = rotation[n] - dot3(c.slip + 3 * i, coupling[j]);
}

// Full path, from the modes and the damping.
template <class N> HWY_INLINE void set_noise_of_modes(BodyConstantsOf<N>& c) {
    for (size_t mode = 0; mode < 6; ++mode) {
        N along[6];
        for (size_t i = 0; i < 6; ++i) along[i] = c.from_modes[i * 6 + mode];
        N* const noise = c.modes_of_noise + mode * 6;
        times_symmetric3(c.full_damping, along, noise);
        times_symmetric3(c.full_spin_damping, along + 3, noise + 3);
        for (size_t i = 3; i < 6; ++i) noise[i] = c.noise_spin * noise[i];
    }
}

// All constants of the load centre, from the inverse mass matrix and the axes and arm of the loads.
template <class N> HWY_INLINE void set_frame(N zero, N one, BodyConstantsOf<N>& c) {
    AerodynamicConstantsOf<N>& a = c.aerodynamics;
    N to[3][6], response[3][6], spin_response[3][6];
    for (size_t j = 0; j < 3; ++j) {
        const N* const q = a.axes + 3 * j;
        const N couple[6] = {zero, zero, zero, q[0], q[1], q[2]};
        for (size_t i = 0; i < 3; ++i) to[j][i] = q[i];
        cross3(a.arm, q, to[j] + 3);
        times_symmetric6(c.full_inverse, to[j], response[j]);
        times_symmetric6(c.full_inverse, couple, spin_response[j]);
    }
    N mobility[6], inverse_spin[6];
    for (size_t i = 0, k = 0; i < 3; ++i)
        for (size_t j = i; j < 3; ++j, ++k) {
            mobility[k] = dot3(to[i], response[j]) + dot3(to[i] + 3, response[j] + 3);
            a.spin_mobility[k] = dot3(a.axes + 3 * i, spin_response[j] + 3);
        }
    for (size_t i = 0; i < 9; ++i) {
        a.push[i] = response[i / 3][i % 3];
        a.push[i + 9] = spin_response[i / 3][i % 3];
    }
    invert_symmetric3(a.spin_mobility, one, inverse_spin);
    invert_symmetric3(mobility, one, a.centre_mass);
    N turned[3][3]; // rows: spin for an impulse; columns: velocity for a couple
    for (size_t i = 0; i < 3; ++i)
        for (size_t j = 0; j < 3; ++j) turned[i][j] = dot3(a.axes + 3 * i, response[j] + 3);
    for (size_t i = 0; i < 3; ++i) {
        const N couple[3] = {turned[0][i], turned[1][i], turned[2][i]};
        times_symmetric3(a.centre_mass, turned[i], a.spin_of_force + 3 * i);
        times_symmetric3(inverse_spin, couple, a.velocity_of_couple + 3 * i);
    }
    const N* const spin = a.spin_mobility;
    const N over[3] = {one / spin[0], one / spin[3], one / spin[5]};
    const N beside[6] = {spin[1], spin[2], spin[1], spin[4], spin[2], spin[4]};
    for (size_t i = 0; i < 6; ++i) a.spin_answer[i] = beside[i] * over[i / 2];
}
} // namespace lr::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();
#endif
