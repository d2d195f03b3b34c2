#include "api/refuse.h"
#include "world/rotate.h"
#include "world/world.h"

#include <algorithm>
#include <iterator>

namespace {

using namespace lr::api;

constexpr double most_acceleration = 1e9; // m/s^2
constexpr double most_kick = 1e6;         // m/s and rad/s

// One force and torque about the centre of mass.
struct Push {
    int32_t mode;
    size_t frame;
    double force[3], torque[3];
};

bool continuous(int32_t mode) {
    return mode == LR_FORCE_MODE_FORCE || mode == LR_FORCE_MODE_ACCELERATION;
}

const char* unknown_in(int32_t mode, int32_t frame) {
    if (mode < LR_FORCE_MODE_FORCE || mode > LR_FORCE_MODE_VELOCITY) return "unknown mode";
    if (frame != LR_FRAME_WORLD && frame != LR_FRAME_BODY) return "unknown frame";
    return nullptr;
}

// What an impulse or a change of velocity does, in the body frame.
lr::Kick kick_of(const lr::Batch& batch, const lr::BodyState& body, const Push& p) {
    double q[4];
    for (size_t i = 0; i < 4; ++i) q[i] = static_cast<double>(body.value[lr::field_qx + i]);
    lr::Kick kick;
    std::copy(p.force, p.force + 3, kick.v);
    std::copy(p.torque, p.torque + 3, kick.w);
    if (p.frame == LR_FRAME_WORLD) {
        const lr::WideVector v = lr::rotate(q, p.force, true), w = lr::rotate(q, p.torque, true);
        std::copy(v.v, v.v + 3, kick.v);
        std::copy(w.v, w.v + 3, kick.w);
    }
    if (p.mode != LR_FORCE_MODE_IMPULSE) return kick;
    return lr::impulse_response(batch.step.body, static_cast<double>(body.value[lr::field_scale]), kick.v, kick.w);
}

// In kernel units a force is what it does to the reference mass, which no body's inertia is far below.
const char* too_large(const lr::Batch& batch, uint32_t index, const Push& p) {
    if (!continuous(p.mode)) {
        const lr::Kick kick = kick_of(batch, batch.read(index), p);
        for (size_t i = 0; i < 3; ++i)
            if (!in_range(kick.v[i], -most_kick, most_kick) || !in_range(kick.w[i], -most_kick, most_kick))
                return "an impulse or velocity gives more than 1e6 m/s or rad/s";
        return nullptr;
    }
    const double scale = static_cast<double>(batch.arrays().field[lr::field_scale][index]);
    const double length = scale * static_cast<double>(batch.step.body.length);
    const double mass = scale * scale * scale * static_cast<double>(batch.step.body.unit_mass);
    const bool force = p.mode == LR_FORCE_MODE_FORCE;
    const double most = force ? most_acceleration * mass : most_acceleration;
    const double most_torque = force ? most * length : most / length;
    for (size_t i = 0; i < 3; ++i)
        if (!in_range(p.force[i], -most, most) || !in_range(p.torque[i], -most_torque, most_torque))
            return "a force or acceleration gives more than 1e9 m/s^2";
    return nullptr;
}

// Wakes the body where there is anything to apply: it then changes places with one before it.
void apply(lr::Batch& batch, uint32_t index, const Push& p) {
    const auto nothing = [](double v) { return v == 0.0; };
    if (batch.rests(index)) {
        if (std::all_of(p.force, p.force + 3, nothing) && std::all_of(p.torque, p.torque + 3, nothing)) return;
        index = batch.wake(index);
    }
    if (continuous(p.mode)) {
        const bool force = p.mode == LR_FORCE_MODE_FORCE;
        batch.external.add(index, p.frame, force ? lr::force_newton : lr::force_acceleration, p.force);
        batch.external.add(index, p.frame, force ? lr::force_torque : lr::force_spin, p.torque);
        return;
    }
    lr::BodyState body = batch.read(index);
    const lr::Kick kick = kick_of(batch, body, p);
    for (size_t i = 0; i < 3; ++i) {
        float& v = body.value[lr::field_vx + i];
        float& w = body.value[lr::field_wx + i];
        v = static_cast<float>(static_cast<double>(v) + kick.v[i]);
        w = static_cast<float>(static_cast<double>(w) + kick.w[i]);
    }
    batch.write(index, body);
    batch.judge(index);
}

Push push_of(const lr_body_force& f, const lr::Batch& batch, uint32_t index) {
    Push p{f.mode, static_cast<size_t>(f.frame), {}, {}};
    double arm[3];
    for (size_t i = 0; i < 3; ++i) {
        p.force[i] = static_cast<double>(f.force[i]);
        p.torque[i] = static_cast<double>(f.torque[i]);
        arm[i] = static_cast<double>(f.point[i]);
        if (f.frame == LR_FRAME_WORLD) arm[i] -= static_cast<double>(batch.arrays().field[lr::field_x + i][index]);
    }
    if (f.flags & LR_FORCE_AT_POINT)
        for (size_t i = 0; i < 3; ++i) {
            const size_t j = (i + 1) % 3, k = (i + 2) % 3;
            p.torque[i] += arm[j] * p.force[k] - arm[k] * p.force[j];
        }
    return p;
}

const char* wrong_in(const lr_body_force& f) {
    if (const char* why = unknown_in(f.mode, f.frame)) return why;
    if (f.flags & ~LR_FORCE_AT_POINT) return "unknown flags";
    if ((f.flags & LR_FORCE_AT_POINT) && (f.mode == LR_FORCE_MODE_ACCELERATION || f.mode == LR_FORCE_MODE_VELOCITY))
        return "only forces and impulses act at a point";
    if (f.reserved != 0) return "reserved is not 0";
    return nullptr;
}

// Three arrays of equal stride, or none.
struct Arrays {
    const unsigned char* at[3];
    uint64_t stride;

    bool given() const { return at[0] != nullptr; }
    double value(size_t i, uint32_t body) const {
        return static_cast<double>(*reinterpret_cast<const float*>(at[i] + stride * body));
    }
    void read(uint32_t body, double (&out)[3]) const {
        for (size_t i = 0; i < 3; ++i) out[i] = given() ? value(i, body) : 0.0;
    }
};

Arrays arrays_of(const float* const (&from)[3], uint32_t stride) {
    Arrays a{{}, stride == 0 ? sizeof(float) : stride};
    for (size_t i = 0; i < 3; ++i) a.at[i] = reinterpret_cast<const unsigned char*>(from[i]);
    return a;
}

bool some_missing(const float* const (&from)[3]) {
    const auto missing = std::count(std::begin(from), std::end(from), nullptr);
    return missing == 1 || missing == 2;
}

bool misaligned(const float* const (&from)[3]) {
    return std::any_of(std::begin(from), std::end(from),
                       [](const float* p) { return reinterpret_cast<uintptr_t>(p) % alignof(float) != 0; });
}

} // namespace

extern "C" {

lr_status lr_body_force_init(lr_body_force* force, uint32_t struct_size) {
    return begin_init(force, struct_size);
}

lr_status lr_inner_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_body_add_force";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!forces) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    const ArrayOf<lr_body_force> all(forces);
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_force f{};
        const lr_status status = all.read(i, f);
        if (status != LR_OK) return refuse(world, name, status);
        uint32_t index = 0;
        const lr::Batch* const batch = world->find(f.body, index);
        if (!batch) return refuse(world, name, LR_ERROR_STALE_BODY);
        if (!finite(f.force) || !finite(f.torque) || !finite(f.point)) return refuse(world, name, LR_ERROR_NOT_FINITE);
        const char* why = wrong_in(f);
        if (!why) why = too_large(*batch, index, push_of(f, *batch, index));
        if (why) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    }
    if (!accepted(world)) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    uint32_t index = 0;
    lr_body_force f{};
    for (uint32_t i = 0; i < count; ++i) {
        all.read(i, f);
        if (continuous(f.mode) && !world->find(f.body, index)->reserve_forces())
            return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    }
    for (uint32_t i = 0; i < count; ++i) {
        all.read(i, f);
        lr::Batch& batch = *world->find(f.body, index);
        apply(batch, index, push_of(f, batch, index));
    }
    return LR_OK;
}

lr_status lr_force_arrays_init(lr_force_arrays* arrays, uint32_t struct_size) {
    return begin_init(arrays, struct_size);
}

lr_status lr_inner_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_batch_add_forces";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    lr_force_arrays a;
    const lr_status status = read_struct(arrays, a);
    if (status != LR_OK) return refuse(world, name, status);
    if (const char* why = unknown_in(a.mode, a.frame)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    if (a.stride % sizeof(float) != 0 || misaligned(a.force) || misaligned(a.torque))
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "stride or alignment does not fit floats");
    if (a.first > b->count() || a.count > b->count() - a.first)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "first and count reach behind the last body");
    if (some_missing(a.force) || some_missing(a.torque)) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    const Arrays force = arrays_of(a.force, a.stride), torque = arrays_of(a.torque, a.stride);
    if (a.count == 0 || (!force.given() && !torque.given())) return LR_OK;
    Push p{a.mode, static_cast<size_t>(a.frame), {}, {}};
    for (uint32_t i = 0; i < a.count; ++i) {
        force.read(i, p.force);
        torque.read(i, p.torque);
        if (!finite(p.force) || !finite(p.torque)) return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (const char* why = too_large(*b, a.first + i, p)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    }
    if (!accepted(world) || (continuous(a.mode) && !b->reserve_forces()))
        return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    // From the first to the last: who changes places with one that wakes has been served.
    for (uint32_t i = 0; i < a.count; ++i) {
        force.read(i, p.force);
        torque.read(i, p.torque);
        apply(*b, a.first + i, p);
    }
    return LR_OK;
}

lr_status lr_batch_force_init(lr_batch_force* force, uint32_t struct_size) {
    return begin_init(force, struct_size);
}

lr_status lr_inner_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force) {
    constexpr const char* name = "lr_batch_set_force";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    float values[lr::force_components] = {};
    if (force) {
        lr_batch_force f;
        const lr_status status = read_struct(force, f);
        if (status != LR_OK) return refuse(world, name, status);
        const auto put = [&](size_t frame, size_t kind, const float(&v)[3]) {
            std::copy(v, v + 3, values + lr::force_component(frame, kind));
        };
        put(LR_FRAME_WORLD, lr::force_newton, f.force);
        put(LR_FRAME_WORLD, lr::force_torque, f.torque);
        put(LR_FRAME_WORLD, lr::force_acceleration, f.acceleration);
        put(LR_FRAME_WORLD, lr::force_spin, f.angular_acceleration);
        put(LR_FRAME_BODY, lr::force_newton, f.body_force);
        put(LR_FRAME_BODY, lr::force_torque, f.body_torque);
        put(LR_FRAME_BODY, lr::force_acceleration, f.body_acceleration);
        put(LR_FRAME_BODY, lr::force_spin, f.body_angular_acceleration);
        if (!finite(values)) return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (f.reserved != 0) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "reserved is not 0");
        if (const char* why = lr::wrong_batch_force(values)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    }
    // Compared as they are kept, without negative zeros.
    if (!std::equal(values, values + lr::force_components, b->external.batch())) b->wake_all();
    b->external.set_batch(values);
    return LR_OK;
}

} // extern "C"
