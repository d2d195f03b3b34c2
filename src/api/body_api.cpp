#include "api/refuse.h"
#include "world/rotate.h"
#include "world/world.h"

#include <algorithm>

namespace {

using namespace lr::api;
using lr::rotate;
using lr::WideVector;

// Desc and state have the same physical fields.
template <class T> const char* wrong_in(const T& s) {
    if (!lr::within(s.position, lr::most_place)) return "position is over 1e9 m";
    if (!lr::within(s.linear_velocity, lr::most_speed)) return "linear_velocity is over 1e6 m/s";
    if (!lr::within(s.angular_velocity, lr::most_speed)) return "angular_velocity is over 1e6 rad/s";
    if (!(s.scale >= lr::least_scale && s.scale <= lr::most_scale)) return "scale is not 0.001 to 1000";
    if (!(s.age >= 0.0f && s.age <= lr::most_age)) return "age is not 0 to 1e9 s";
    double n = 0.0;
    for (float q : s.orientation) n += static_cast<double>(q) * static_cast<double>(q);
    if (!in_range(n, 1e-12, 1e12)) return "orientation cannot be normalised";
    if (s.reserved != 0) return "reserved is not 0";
    return nullptr;
}
template <class T> bool all_finite(const T& s) {
    return finite(s.position) && finite(s.orientation) && finite(s.linear_velocity) && finite(s.angular_velocity) &&
           std::isfinite(s.scale) && std::isfinite(s.age);
}

template <class T> lr::BodyState to_storage(const T& s) {
    double q[4], n = 0.0;
    for (int i = 0; i < 4; ++i) n += static_cast<double>(s.orientation[i]) * static_cast<double>(s.orientation[i]);
    n = std::sqrt(n);
    lr::BodyState out{};
    for (size_t i = 0; i < 4; ++i) {
        q[i] = static_cast<double>(s.orientation[i]) / n;
        // A quaternion that is a unit one already keeps its bits.
        out.value[lr::field_qx + i] = std::abs(n - 1.0) < 1e-7 ? s.orientation[i] : static_cast<float>(q[i]);
    }
    const WideVector v = rotate(q, s.linear_velocity, true), w = rotate(q, s.angular_velocity, true);
    for (size_t i = 0; i < 3; ++i) {
        out.value[lr::field_x + i] = s.position[i];
        out.value[lr::field_vx + i] = static_cast<float>(v.v[i]);
        out.value[lr::field_wx + i] = static_cast<float>(w.v[i]);
    }
    out.value[lr::field_scale] = s.scale;
    out.value[lr::field_age] = s.age;
    out.key = s.key;
    return out;
}

template <class T> void init_pose(T* s) {
    s->orientation[3] = 1.0f;
    s->scale = 1.0f;
}

} // namespace

extern "C" {

lr_status lr_body_desc_init(lr_body_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status == LR_OK) init_pose(desc);
    return status;
}

lr_status lr_inner_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count,
                               lr_body* out_ids) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_body_create";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr::Batch* const b = world->find(batch);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BATCH);
    if (count == 0) return LR_OK;
    if (!descs) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    if (count > b->capacity() - b->count()) return refuse(world, name, LR_ERROR_CAPACITY);

    const ArrayOf<lr_body_desc> all(descs);
    // All or none: the whole array is checked before the first is made.
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d;
        const lr_status status = all.read(i, d);
        if (status != LR_OK) return refuse(world, name, status);
        if (!all_finite(d)) return refuse(world, name, LR_ERROR_NOT_FINITE);
        if (const char* why = wrong_in(d)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    }
    if (!accepted(world)) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_desc d;
        all.read(i, d);
        lr::BodyState state = to_storage(d);
        if (state.key == 0) state.key = world->take_key();
        const lr_body id = b->add(state);
        if (out_ids) out_ids[i] = id;
    }
    return LR_OK;
}

lr_status lr_inner_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!bodies) return refuse(world, "lr_body_destroy", LR_ERROR_NULL_ARGUMENT);
    const lr_status status = world->destroy_bodies(bodies, count);
    return status == LR_OK ? status : refuse(world, "lr_body_destroy", status);
}

lr_status lr_body_state_init(lr_body_state* state, uint32_t struct_size) {
    const lr_status status = begin_init(state, struct_size);
    if (status == LR_OK) init_pose(state);
    return status;
}

lr_status lr_inner_body_get_state(const lr_world* world, lr_body body, lr_body_state* state) {
    const lr::FloatMode mode;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    uint32_t index = 0;
    const lr::Batch* const b = world->find(body, index);
    if (!b) return refuse(world, "lr_body_get_state", LR_ERROR_STALE_BODY);
    const lr_status status = check_size(state);
    if (status != LR_OK) return refuse(world, "lr_body_get_state", status);
    const lr::BodyState s = b->read(index);
    lr_body_state out{};
    double q[4];
    for (size_t i = 0; i < 4; ++i) {
        out.orientation[i] = s.value[lr::field_qx + i];
        q[i] = static_cast<double>(out.orientation[i]);
    }
    const WideVector v = rotate(q, &s.value[lr::field_vx], false), w = rotate(q, &s.value[lr::field_wx], false);
    for (size_t i = 0; i < 3; ++i) {
        out.position[i] = s.value[lr::field_x + i];
        out.linear_velocity[i] = static_cast<float>(v.v[i]);
        out.angular_velocity[i] = static_cast<float>(w.v[i]);
    }
    out.scale = s.value[lr::field_scale];
    out.age = s.value[lr::field_age];
    out.key = s.key;
    out.resting = b->rests(index) ? LR_REST_RESTING : b->held(index) ? LR_REST_HELD : LR_REST_AWAKE;
    write_struct(out, state);
    return LR_OK;
}

lr_status lr_inner_body_set_state(lr_world* world, lr_body body, const lr_body_state* state) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_body_set_state";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    uint32_t index = 0;
    lr::Batch* const b = world->find(body, index);
    if (!b) return refuse(world, name, LR_ERROR_STALE_BODY);
    lr_body_state s;
    const lr_status status = read_struct(state, s);
    if (status != LR_OK) return refuse(world, name, status);
    if (!all_finite(s)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = wrong_in(s)) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    if (b->rests(index)) index = b->wake(index);
    world->leave(*b, index);
    b->write(index, to_storage(s));
    world->wake_left();
    return LR_OK;
}

lr_status lr_inner_body_set_rest(lr_world* world, const lr_body* bodies, uint32_t count, int32_t rest) {
    constexpr const char* name = "lr_body_set_rest";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (rest != LR_REST_AWAKE && rest != LR_REST_RESTING)
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "rest is neither LR_REST_AWAKE nor LR_REST_RESTING");
    if (count == 0) return LR_OK;
    if (!bodies) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    const lr::FloatMode mode;
    const lr_status status = world->set_rest(bodies, count, rest == LR_REST_RESTING);
    return status == LR_OK ? status : refuse(world, name, status);
}

lr_status lr_inner_world_wake_box(lr_world* world, const float* low, const float* high, uint32_t* woken) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_world_wake_box";
    if (woken) *woken = 0;
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (!low || !high) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    float from[3], to[3];
    std::copy(low, low + 3, from);
    std::copy(high, high + 3, to);
    if (!finite(from) || !finite(to)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    for (size_t k = 0; k < 3; ++k)
        if (from[k] > to[k]) return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, "low is above high");
    if (!accepted(world)) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    const uint32_t count = world->wake_box({lr::vector_of(from), lr::vector_of(to)});
    if (woken) *woken = count;
    return LR_OK;
}

} // extern "C"
