// External forces: on single bodies for the next step, on a whole batch until changed.
#pragma once

#include "base/pose.h"
#include "kernel/integrator/step.h"
#include "kernel/limits.h"

namespace lr {

// Null if valid, else the reason.
inline const char* wrong_batch_force(const float (&force)[force_components]) {
    return within(force, most_force) ? nullptr : "a component is over 1e9";
}

class ExternalForces {
public:
    // Sets the rows for single bodies, `stride` floats apart. Before this there can be no forces on single bodies.
    void use(float* rows, size_t stride) { rows_ = rows, stride_ = stride; }
    void add(uint32_t index, size_t frame, size_t kind, Double3 value);

    void set_batch(const float (&force)[force_components]);
    const float (&batch() const)[force_components] { return batch_; }
    bool pending() const { return used_ != 0; } // on single bodies

    // If all forces are 0, because they cancelled or their bodies ended, there are none: adding zeros rounds differently from adding nothing.
    void forget_zeros(uint32_t count);
    // Scales forces on single bodies by `part`, since the batch's step is 1/part times as long as the world's.
    void spread(float part, uint32_t count);
    void fill(ExternalInput& in) const; // for a step
    void stepped() { used_ = 0; }       // the kernel has cleared the rows
    void restored(bool pending) { used_ = pending ? all_vectors : 0; }

private:
    static constexpr uint32_t all_vectors = (1u << force_components / 3) - 1;

    float batch_[force_components] = {};
    bool on_batch_ = false;
    uint32_t used_ = 0; // a bit for each vector that is not 0 on every body
    float* rows_ = nullptr;
    size_t stride_ = 0;
};

struct Kick {
    Double3 v, w; // m/s and rad/s, body frame
};

// Change of velocity by a linear (N s) and an angular impulse (N m s) in the body frame, with the added mass: (M + A)^-1 times them.
Kick impulse_response(const BodyConstants& body, double scale, const Kick& impulse);
} // namespace lr
