// Forces from outside on a batch: on each body by itself over the next step, and on all of them until changed.
#pragma once

#include "kernel/limits.h"
#include "kernel/step.h"
#include "world/allocator.h"

namespace lr {

// Null when fine, else what is wrong.
inline const char* wrong_batch_force(const float (&force)[force_components]) {
    return within(force, most_force) ? nullptr : "a component is over 1e9";
}

class ExternalForces {
public:
    // Memory for forces on single bodies, taken once. False when there is none; nothing has then changed.
    bool reserve(Allocator& allocator, size_t lanes);

    void add(uint32_t index, size_t frame, size_t kind, const double value[3]); // reserve() has held
    // The body at `from` moves into the place of another, or ends when both are the same.
    void move(uint32_t from, uint32_t to);
    void swap(uint32_t a, uint32_t b);
    void clear();
    void clear(uint32_t index); // those on one body
    void clear(uint32_t begin, uint32_t end);

    void set_batch(const float (&force)[force_components]);
    const float (&batch() const)[force_components] { return batch_; }
    bool on_batch() const { return on_batch_; }
    bool pending() const { return used_ != 0; } // on single bodies
    // force_components arrays, `stride` apart; null before the first reserve().
    float* bodies() { return bodies_.data(); }
    const float* bodies() const { return bodies_.data(); }
    size_t stride() const { return stride_; }

    // Those on single bodies act over 1/part of the time that they were meant for.
    void spread(float part, uint32_t count);
    void fill(ExternalInput& in);                    // for a step
    void stepped() { used_ = 0; }                    // the kernel has left zeros
    void restored_pending() { used_ = all_vectors; } // bodies() has been filled

private:
    float batch_[force_components] = {};
    static constexpr uint32_t all_vectors = (1u << force_components / 3) - 1;

    bool on_batch_ = false;
    uint32_t used_ = 0; // a bit for each vector that is not 0 on all bodies
    Buffer<float> bodies_;
    size_t stride_ = 0;
};

struct Kick {
    double v[3], w[3]; // m/s and rad/s, body frame
};

// What an impulse (N s) and an angular one (N m s) in the body frame do to a body and the fluid that moves along with it:
// (M + added)^-1 of them.
Kick impulse_response(const BodyConstants& body, double scale, const double linear[3], const double angular[3]);

} // namespace lr
