// The baseline: the first sketch of a step, untuned. Runge-Kutta of fourth order, LANGEVIN loads with the SPEED clock, two
// Philox4x32-7 blocks and six Gaussians a substep, diagonal tensors, fused multiply-adds, compiled for one instruction set.
#pragma once

#include <cstddef>
#include <cstdint>

namespace lr_bench {

struct SketchConstants {
    float inverse_mass[3], inverse_inertia[3], mass[3], inertia[3];
    float carried[3], turned[3]; // mass for turbulence
    float weight;
    float damping, noise;
};

// x y z, q0 (real) q1 q2 q3, v, w: 13 arrays, aligned for any vector, in whole vectors.
using SketchStep = void (*)(const SketchConstants& p, float* const* state, size_t count, int substeps, uint32_t first,
                            float h);
void sketch_step_native(const SketchConstants&, float* const*, size_t, int, uint32_t, float);
void sketch_step_native_no_fma(const SketchConstants&, float* const*, size_t, int, uint32_t, float);
void sketch_step_avx2(const SketchConstants&, float* const*, size_t, int, uint32_t, float);

} // namespace lr_bench
