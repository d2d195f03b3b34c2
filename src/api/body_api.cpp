// Bodies and the forces on them.
#include "api/checked_call.h"
#include "api/struct_conversion.h"

#include <iterator>

namespace lr::api {
namespace {

// For descs and states, which have the same physical fields.
template <class T> const char* wrong_in(const T& s) {
    if (!within(s.position, most_place)) return "position is over 1e9 m";
    if (!within(s.linear_velocity, most_speed)) return "linear_velocity is over 1e6 m/s";
    if (!within(s.angular_velocity, most_speed)) return "angular_velocity is over 1e6 rad/s";
    if (!(s.scale >= least_scale && s.scale <= most_scale)) return "scale is not 0.001 to 1000";
    if (!(s.age >= 0.0f && s.age <= most_age)) return "age is not 0 to 1e9 s";
    if (!normalisable(s.orientation)) return "orientation cannot be normalised";
    return nullptr;
}
template <class T> BodyState to_storage(const T& s) {
    const Quaternion<double> given = to_double(rotation_of(s.orientation));
    const Quaternion<double> to_body = 1.0 / std::sqrt(dot(given, given)) * inverse(given);
    BodyState out{};
    put(vector_of(s.position), out.value + field_x);
    put(unit_rotation(s.orientation), out.value + field_qx);
    put(to_float(rotate(to_body, to_double(vector_of(s.linear_velocity)))), out.value + field_vx);
    put(to_float(rotate(to_body, to_double(vector_of(s.angular_velocity)))), out.value + field_wx);
    out.value[field_scale] = s.scale;
    out.value[field_age] = s.age;
    out.noise_seed = s.noise_seed;
    out.user = s.user;
    return out;
}

template <class T> Outcome check(const T& s) {
    const bool numbers = finite(s.position, s.orientation, s.linear_velocity, s.angular_velocity, s.scale, s.age);
    return numbers ? invalid(wrong_in(s)) : LR_ERROR_NOT_FINITE;
}

constexpr double most_acceleration = 1e9; // m/s^2
constexpr double most_kick = 1e6;         // m/s and rad/s

// One force and torque about the centre of mass.
struct Push {
    int32_t mode;
    size_t frame;
    Double3 force, torque;
};

bool continuous(int32_t mode) {
    return mode == LR_FORCE_MODE_FORCE || mode == LR_FORCE_MODE_ACCELERATION;
}

const char* unknown_in(int32_t mode, int32_t frame) {
    if (mode < LR_FORCE_MODE_FORCE || mode > LR_FORCE_MODE_VELOCITY) return "unknown mode";
    if (frame != LR_FRAME_WORLD && frame != LR_FRAME_BODY) return "unknown frame";
    return nullptr;
}

// The change of velocity and spin by an impulse or a change of velocity, body frame. constants: in the fluid that an impulse moves.
Kick kick_of(const BodyConstants& constants, const BodyState& body, const Push& p) {
    Kick kick{p.force, p.torque};
    if (p.frame == LR_FRAME_WORLD) {
        const Quaternion<double> to_body = inverse(to_double(rotation_of(body.value + field_qx)));
        kick = {rotate(to_body, p.force), rotate(to_body, p.torque)};
    }
    return p.mode == LR_FORCE_MODE_IMPULSE ? impulse_response(constants, wide(body.value[field_scale]), kick) : kick;
}

Kick kick_here(const lr_world& world, Batch& batch, uint32_t index, const BodyState& body, const Push& p) {
    float stream[3];
    const bool impulse = p.mode == LR_FORCE_MODE_IMPULSE;
    return kick_of(impulse ? constants_at(world, batch, index, stream) : batch.step.body, body, p);
}

bool all_within(Double3 v, double most) {
    return in_range(v.x, -most, most) && in_range(v.y, -most, most) && in_range(v.z, -most, most);
}

// The kernel divides a force by the reference mass, which up to a small factor is a lower bound of every body's inertia.
const char* too_large(const lr_world& world, Batch& batch, uint32_t index, const Push& p) {
    if (!continuous(p.mode)) {
        const BodyState body = batch.read(index);
        const auto fits = [](const Kick& k) { return all_within(k.v, most_kick) && all_within(k.w, most_kick); };
        // Water only adds mass, so its surface (perhaps a callback) is not queried if the impulse is small enough in air.
        return fits(kick_of(batch.step.body, body, p)) || fits(kick_here(world, batch, index, body, p))
                   ? nullptr
                   : "an impulse or velocity gives more than 1e6 m/s or rad/s";
    }
    const double scale = wide(batch.arrays().field[field_scale][index]), length = scale * wide(batch.step.body.length);
    const double mass = scale * scale * scale * wide(batch.step.body.unit_mass);
    const bool force = p.mode == LR_FORCE_MODE_FORCE;
    const double most = force ? most_acceleration * mass : most_acceleration;
    return all_within(p.force, most) && all_within(p.torque, force ? most * length : most / length)
               ? nullptr
               : "a force or acceleration gives more than 1e9 m/s^2";
}

// Wakes the body unless force and torque are zero; a body that wakes moves to a lower index.
void apply(const lr_world& world, Batch& batch, uint32_t index, const Push& p) {
    if (batch.asleep(index)) {
        if (dot(p.force, p.force) == 0.0 && dot(p.torque, p.torque) == 0.0) return;
        index = batch.wake(index);
    }
    if (continuous(p.mode)) {
        const bool force = p.mode == LR_FORCE_MODE_FORCE;
        batch.external.add(index, p.frame, force ? force_newton : force_acceleration, p.force);
        batch.external.add(index, p.frame, force ? force_torque : force_spin, p.torque);
        return;
    }
    BodyState body = batch.read(index);
    const Kick kick = kick_here(world, batch, index, body, p);
    put(to_float(to_double(vector_of(body.value + field_vx)) + kick.v), body.value + field_vx);
    put(to_float(to_double(vector_of(body.value + field_wx)) + kick.w), body.value + field_wx);
    batch.write(index, body);
    batch.judge(index);
}

Push push_of(const lr_body_force& f, const Batch& batch, uint32_t index) {
    Push p{f.mode, static_cast<size_t>(f.frame), to_double(vector_of(f.force)), to_double(vector_of(f.torque))};
    if ((f.flags & LR_FORCE_AT_POINT) == 0) return p;
    Double3 arm = to_double(vector_of(f.point));
    if (f.frame == LR_FRAME_WORLD) arm = arm - to_double(vector_in(batch.arrays().field, field_x, index));
    p.torque = p.torque + cross(arm, p.force);
    return p;
}

const char* wrong_in(const lr_body_force& f) {
    if (const char* why = unknown_in(f.mode, f.frame)) return why;
    if (f.flags & ~uint32_t{LR_FORCE_AT_POINT}) return "unknown flags";
    if ((f.flags & LR_FORCE_AT_POINT) && (f.mode == LR_FORCE_MODE_ACCELERATION || f.mode == LR_FORCE_MODE_VELOCITY))
        return "only forces and impulses act at a point";
    return nullptr;
}

// The x, y, z arrays of an optional vector.
struct Arrays {
    const unsigned char* at[3];
    uint64_t stride;

    bool given() const { return at[0] != nullptr; }
    Double3 value(uint32_t body) const {
        const auto one = [&](const unsigned char* from) {
            return wide(*reinterpret_cast<const float*>(from + stride * body));
        };
        return given() ? Double3{one(at[0]), one(at[1]), one(at[2])} : Double3{};
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

// Calls each(vector, index of its first component) for the vectors of an lr_batch_force.
template <class Force, class Each> void each_force(Force& f, const Each& each) {
    each(f.force, force_component(LR_FRAME_WORLD, force_newton));
    each(f.torque, force_component(LR_FRAME_WORLD, force_torque));
    each(f.acceleration, force_component(LR_FRAME_WORLD, force_acceleration));
    each(f.angular_acceleration, force_component(LR_FRAME_WORLD, force_spin));
    each(f.body_force, force_component(LR_FRAME_BODY, force_newton));
    each(f.body_torque, force_component(LR_FRAME_BODY, force_torque));
    each(f.body_acceleration, force_component(LR_FRAME_BODY, force_acceleration));
    each(f.body_angular_acceleration, force_component(LR_FRAME_BODY, force_spin));
}
} // namespace

// Only for arrays without gaps.
static void record_argument(Call& call, const lr_force_arrays* arrays) {
    lr_force_arrays a{};
    if (!call.structure(arrays, a)) return;
    for (const auto* three : {&a.force, &a.torque}) {
        const Arrays all = arrays_of(*three, a.stride);
        for (const unsigned char* from : all.at) {
            call.value(static_cast<uint32_t>(from ? recording::Where::here : recording::Where::null));
            for (uint32_t i = 0; from && i < a.count; ++i) call.raw(from + all.stride * i, sizeof(float));
        }
    }
}
} // namespace lr::api

using namespace lr;
using namespace lr::api;

extern "C" {

lr_status lr_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count, lr_body* out_ids) {
    const auto create = [](lr_world& w, Batch& b, const Structs<lr_body_desc>& all, Out<lr_body> ids) -> Outcome {
        if (all.count > b.capacity() - b.count()) return LR_ERROR_CAPACITY;
        bool users = false;
        const auto check_one = [&users](const lr_body_desc& d) {
            users = users || d.user != 0;
            return check(d);
        };
        if (const Outcome outcome = all.check(check_one); outcome.refused()) return outcome;
        if (!accepted(w) || (users && !b.reserve_users())) return LR_ERROR_OUT_OF_MEMORY;
        all.visit([&](const lr_body_desc& d) {
            BodyState state = to_storage(d);
            if (state.noise_seed == 0) state.noise_seed = w.take_key();
            const lr_body id = b.add(state);
            if (ids.first) *ids.first++ = id;
        });
        return {};
    };
    return change(world, args(batch, Structs{descs, count}, Out{out_ids, count}), create);
}

lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count) {
    return change(world, args(Handles{bodies, count}), [](lr_world& w, const Handles<lr_body>& all) -> Outcome {
        // All or none: marks every body first; a stale or marked one ends the call.
        uint32_t index = 0, marked = 0;
        for (; marked < all.count; ++marked) {
            Batch* const batch = w.find(all.first[marked], index);
            if (!batch || !batch->mark(index)) break;
        }
        for (uint32_t i = 0; i < marked; ++i) w.find(all.first[i], index)->unmark(index);
        if (marked < all.count) return LR_ERROR_STALE_BODY;
        for (uint32_t i = 0; i < all.count; ++i) {
            Batch& batch = *w.find(all.first[i], index);
            w.leave(batch, index);
            batch.remove(all.first[i]);
        }
        w.wake_left();
        return {};
    });
}

int32_t lr_body_is_valid(const lr_world* world, lr_body body) {
    return is_valid<Body>(world, body);
}

lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state) {
    return query(world, args(body, state), [](const lr_world&, Body at, lr_body_state& out) {
        const BodyState s = at.batch.read(at.index);
        const Rotation q = rotation_of(s.value + field_qx);
        put(vector_of(s.value + field_x), out.position);
        put(q, out.orientation);
        put(to_world(q, vector_of(s.value + field_vx)), out.linear_velocity);
        put(to_world(q, vector_of(s.value + field_wx)), out.angular_velocity);
        out.scale = s.value[field_scale];
        out.age = s.value[field_age];
        out.noise_seed = s.noise_seed;
        out.user = s.user;
        out.sleep_state = at.batch.asleep(at.index) ? LR_SLEEP_ASLEEP
                          : at.batch.held(at.index) ? LR_SLEEP_HELD
                                                    : LR_SLEEP_AWAKE;
    });
}

lr_status lr_body_get_loads(const lr_world* world, lr_body body, lr_body_loads* loads) {
    const auto get = [](const lr_world& w, Body at, lr_body_loads& out) { find_loads(w, at.batch, at.index, out); };
    return query(world, args(body, loads), get);
}

lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state) {
    return change(world, args(body, state), [](lr_world& w, Body at, const lr_body_state& s) -> Outcome {
        if (const Outcome outcome = check(s); outcome.refused()) return outcome;
        if (s.user != 0 && !at.batch.reserve_users()) return LR_ERROR_OUT_OF_MEMORY;
        const uint32_t index = at.batch.asleep(at.index) ? at.batch.wake(at.index) : at.index;
        w.leave(at.batch, index);
        // Of the whole batch: a pass over the pairs for each of many growing bodies would be slow.
        if (s.scale != at.batch.arrays().field[field_scale][index]) w.pair_cache.forget(at.batch.slot());
        at.batch.write(index, to_storage(s));
        at.batch.set_user(index, s.user);
        w.wake_left();
        return {};
    });
}

lr_status lr_body_set_sleep(lr_world* world, const lr_body* bodies, uint32_t count, int32_t sleep_state) {
    const auto set = [](lr_world& w, int32_t to, const Handles<lr_body>& all) -> Outcome {
        if (to != LR_SLEEP_AWAKE && to != LR_SLEEP_ASLEEP)
            return invalid("sleep_state is neither LR_SLEEP_AWAKE nor LR_SLEEP_ASLEEP");
        const bool asleep = to == LR_SLEEP_ASLEEP;
        uint32_t index = 0;
        for (uint32_t i = 0; i < all.count; ++i)
            if (!w.find(all.first[i], index)) return LR_ERROR_STALE_BODY;
        for (uint32_t i = 0; i < all.count && asleep; ++i)
            if (!w.find(all.first[i], index)->reserve_sleep()) return LR_ERROR_OUT_OF_MEMORY;
        for (uint32_t i = 0; i < all.count; ++i) {
            Batch& batch = *w.find(all.first[i], index);
            if (batch.asleep(index) == asleep) continue;
            if (!asleep) {
                batch.wake(index);
                continue;
            }
            index = batch.fall_asleep(index);
            if (batch.events()) batch.events()->take_back(unpack(batch.ids()[index]).slot, noted_waking);
            batch.sleeping()->ask_again(); // the rules may never have checked it
        }
        return {};
    };
    return change(world, args(sleep_state, Handles{bodies, count}), set);
}

lr_status lr_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken) {
    if (woken) *woken = 0;
    const auto wake = [](lr_world& w, const float* lows, const float* highs, Out<uint32_t> out) -> Outcome {
        if (!lows || !highs) return LR_ERROR_NULL_ARGUMENT;
        const Vector from = vector_of(lows), to = vector_of(highs);
        for (uint32_t k = 0; k < 3; ++k)
            if (!finite(from[k], to[k])) return LR_ERROR_NOT_FINITE;
        if (from.x > to.x || from.y > to.y || from.z > to.z) return invalid("low is above high");
        if (!accepted(w)) return LR_ERROR_OUT_OF_MEMORY;
        uint32_t count = 0;
        w.each_batch([&](Batch& batch, uint32_t) {
            count -= batch.awake();
            batch.wake_in({from, to});
            count += batch.awake();
        });
        if (out.first) *out.first = count;
        return {};
    };
    return change(world, args(low, high, Out{woken}), wake);
}

lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count) {
    return change(world, args(Structs{forces, count}), [](lr_world& w, const Structs<lr_body_force>& all) -> Outcome {
        uint32_t index = 0;
        const Outcome outcome = all.check([&](const lr_body_force& f) -> Outcome {
            Batch* const batch = w.find(f.body, index);
            if (!batch) return LR_ERROR_STALE_BODY;
            if (!finite(f.force, f.torque, f.point)) return LR_ERROR_NOT_FINITE;
            if (const char* why = wrong_in(f)) return invalid(why);
            return invalid(too_large(w, *batch, index, push_of(f, *batch, index)));
        });
        if (outcome.refused()) return outcome;
        bool reserved = accepted(w);
        all.visit([&](const lr_body_force& f) {
            if (continuous(f.mode)) reserved = reserved && w.find(f.body, index)->reserve_forces();
        });
        if (!reserved) return LR_ERROR_OUT_OF_MEMORY;
        all.visit([&](const lr_body_force& f) {
            Batch& batch = *w.find(f.body, index);
            apply(w, batch, index, push_of(f, batch, index));
        });
        return {};
    });
}

lr_status lr_batch_add_forces(lr_world* world, lr_batch batch, const lr_force_arrays* arrays) {
    return change(world, args(batch, arrays), [](lr_world& w, Batch& b, const lr_force_arrays& a) -> Outcome {
        if (const char* why = unknown_in(a.mode, a.frame)) return invalid(why);
        if (a.stride % sizeof(float) != 0 || misaligned(a.force) || misaligned(a.torque))
            return invalid("stride or alignment is wrong for floats");
        if (a.first > b.count() || a.count > b.count() - a.first)
            return invalid("first + count exceeds the batch's bodies");
        if (some_missing(a.force) || some_missing(a.torque)) return LR_ERROR_NULL_ARGUMENT;
        const Arrays force = arrays_of(a.force, a.stride), torque = arrays_of(a.torque, a.stride);
        if (a.count == 0 || (!force.given() && !torque.given())) return {};
        const auto push = [&](uint32_t i) {
            return Push{a.mode, static_cast<size_t>(a.frame), force.value(i), torque.value(i)};
        };
        for (uint32_t i = 0; i < a.count; ++i) {
            const Push p = push(i);
            if (!finite(p.force.x, p.force.y, p.force.z, p.torque.x, p.torque.y, p.torque.z))
                return LR_ERROR_NOT_FINITE;
            if (const char* why = too_large(w, b, a.first + i, p)) return invalid(why);
        }
        if (!accepted(w) || (continuous(a.mode) && !b.reserve_forces())) return LR_ERROR_OUT_OF_MEMORY;
        // In ascending order: waking body i swaps it with one below i, whose force is already applied.
        for (uint32_t i = 0; i < a.count; ++i) apply(w, b, a.first + i, push(i));
        return {};
    });
}

lr_status lr_batch_set_force(lr_world* world, lr_batch batch, const lr_batch_force* force) {
    return change(world, args(batch, force), [](lr_world&, Batch& b, const lr_batch_force* f) -> Outcome {
        float values[force_components] = {};
        if (f) {
            each_force(*f, [&](const float(&v)[3], size_t at) { std::copy(v, v + 3, values + at); });
            if (!finite(values)) return LR_ERROR_NOT_FINITE;
            if (const char* why = wrong_batch_force(values)) return invalid(why);
        }
        // In stored form, where -0 is 0.
        if (!std::equal(values, values + force_components, b.external.batch())) b.wake_all();
        b.external.set_batch(values);
        return {};
    });
}

lr_status lr_batch_get_force(const lr_world* world, lr_batch batch, lr_batch_force* force) {
    return query(world, args(batch, force), [](const lr_world&, const Batch& b, lr_batch_force& out) {
        each_force(out, [&](float(&v)[3], size_t at) { std::copy_n(b.external.batch() + at, 3, v); });
    });
}

} // extern "C"
