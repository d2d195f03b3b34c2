#include "api/refuse.h"
#include "contact/collider_limits.h"
#include "world/world.h"

#include <algorithm>

namespace {

using namespace lr::api;

const char* wrong_pose(const float (&position)[3], const float (&orientation)[4]) {
    if (!lr::within(position, lr::most_place)) return "position is over 1e9 m";
    double n = 0.0;
    for (float q : orientation) n += static_cast<double>(q) * static_cast<double>(q);
    return in_range(n, 1e-12, 1e12) ? nullptr : "orientation cannot be normalised";
}

struct Refusal {
    lr_status status;
    const char* why;
};
constexpr Refusal fine{LR_OK, nullptr};
Refusal invalid(const char* why) {
    return {why ? LR_ERROR_INVALID_ARGUMENT : LR_OK, why};
}

Refusal check_lengths(const float* values, uint64_t count) {
    for (uint64_t i = 0; i < count; ++i) {
        if (!std::isfinite(values[i])) return {LR_ERROR_NOT_FINITE, nullptr};
        if (!in_range(values[i], -lr::most_size, lr::most_size)) return invalid("a vertex or height is over 1e6 m");
    }
    return fine;
}

Refusal check_vertices(const lr_collider_desc& d, uint32_t least, uint32_t most) {
    if (d.vertex_count < least || d.vertex_count > most) return invalid("vertex_count is out of its range");
    if (!d.vertices) return {LR_ERROR_NULL_ARGUMENT, nullptr};
    return check_lengths(d.vertices, uint64_t{3} * d.vertex_count);
}

Refusal check_mesh(const lr_collider_desc& d) {
    if (d.triangle_count < 1 || d.triangle_count > LR_MAX_COLLIDER_VERTICES)
        return invalid("triangle_count is out of its range");
    if (!d.indices) return {LR_ERROR_NULL_ARGUMENT, nullptr};
    const Refusal vertices = check_vertices(d, 3, LR_MAX_COLLIDER_VERTICES);
    if (vertices.status != LR_OK) return vertices;
    for (uint64_t i = 0; i < uint64_t{3} * d.triangle_count; ++i)
        if (d.indices[i] >= d.vertex_count) return invalid("an index is not less than vertex_count");
    return fine;
}

Refusal check_heightfield(const lr_collider_desc& d) {
    const uint64_t samples = uint64_t{d.counts[0]} * d.counts[1];
    if (d.counts[0] < 2 || d.counts[1] < 2 || samples > LR_MAX_COLLIDER_VERTICES)
        return invalid("counts are out of their range");
    for (float s : d.spacing) {
        if (!std::isfinite(s)) return {LR_ERROR_NOT_FINITE, nullptr};
        if (!in_range(s, static_cast<double>(1e-6f), 1e6)) return invalid("spacing is not 1e-6 to 1e6 m");
    }
    if (!d.heights) return {LR_ERROR_NULL_ARGUMENT, nullptr};
    return check_lengths(d.heights, samples);
}

Refusal check_sizes(const lr_collider_desc& d) {
    for (int i = 0; i < lr::sizes_of(d.kind); ++i)
        if (!std::isfinite(d.size[i])) return {LR_ERROR_NOT_FINITE, nullptr};
    return invalid(lr::wrong_sizes(d.kind, d.size));
}

Refusal check_shape(const lr_collider_desc& d) {
    switch (d.kind) {
    case LR_COLLIDER_PLANE:
        return fine;
    case LR_COLLIDER_SPHERE:
    case LR_COLLIDER_CAPSULE:
    case LR_COLLIDER_BOX:
        return check_sizes(d);
    case LR_COLLIDER_HULL:
        return check_vertices(d, 4, LR_MAX_HULL_VERTICES);
    case LR_COLLIDER_HEIGHTFIELD:
        return check_heightfield(d);
    case LR_COLLIDER_MESH:
        return check_mesh(d);
    default:
        return invalid("unknown kind of collider");
    }
}

// What a kind does not use is not looked at, and made zero: equal colliders are to be equal.
void clear_unused(lr_collider_desc& d) {
    std::fill(d.size + lr::sizes_of(d.kind), d.size + 3, 0.0f);
}

// Descs often repeat the arrays of the one before, which need not be gone through again.
bool same_arrays(const lr_collider_desc& a, const lr_collider_desc& b) {
    return a.kind == b.kind && a.vertices == b.vertices && a.indices == b.indices && a.heights == b.heights &&
           a.vertex_count == b.vertex_count && a.triangle_count == b.triangle_count &&
           std::equal(a.counts, a.counts + 2, b.counts) && a.spacing[0] == b.spacing[0] && a.spacing[1] == b.spacing[1];
}

Refusal check_desc(const lr_collider_desc& d, const lr_collider_desc& before) {
    if (!finite(d.position) || !finite(d.orientation) || !finite(d.linear_velocity) || !finite(d.angular_velocity) ||
        !std::isfinite(d.friction) || !std::isfinite(d.restitution))
        return {LR_ERROR_NOT_FINITE, nullptr};
    if (d.flags != 0) return invalid("flags are not 0");
    for (const char* why :
         {wrong_pose(d.position, d.orientation), lr::wrong_velocity(d.linear_velocity, d.angular_velocity),
          lr::wrong_surface(d.friction, d.restitution)})
        if (why) return invalid(why);
    return d.kind >= LR_COLLIDER_HULL && same_arrays(d, before) ? fine : check_shape(d);
}

Refusal check_motion(const lr_collider_motion& m) {
    if (m.mode < LR_MOVE_TO || m.mode > LR_MOVE_VELOCITY) return invalid("unknown mode of motion");
    if (m.reserved != 0) return invalid("reserved is not 0");
    if (!finite(m.position) || !finite(m.orientation) || !finite(m.linear_velocity) || !finite(m.angular_velocity))
        return {LR_ERROR_NOT_FINITE, nullptr};
    if (m.mode != LR_MOVE_VELOCITY)
        if (const char* why = wrong_pose(m.position, m.orientation)) return invalid(why);
    return m.mode == LR_MOVE_TO ? fine : invalid(lr::wrong_velocity(m.linear_velocity, m.angular_velocity));
}

} // namespace

extern "C" {

lr_status lr_collider_desc_init(lr_collider_desc* desc, uint32_t struct_size) {
    const lr_status status = begin_init(desc, struct_size);
    if (status != LR_OK) return status;
    desc->orientation[3] = 1.0f;
    desc->friction = 0.5f;
    desc->restitution = 0.2f;
    desc->layers = 1;
    desc->spacing[0] = desc->spacing[1] = 1.0f;
    return LR_OK;
}

lr_status lr_inner_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count,
                                   lr_collider* out_ids) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_collider_create";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!descs) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    const ArrayOf<lr_collider_desc> all(descs);
    lr_collider_desc d{}, before{};
    for (uint32_t i = 0; i < count; ++i, before = d) {
        const lr_status status = all.read(i, d);
        if (status != LR_OK) return refuse(world, name, status);
        const Refusal refusal = check_desc(d, before);
        if (refusal.status != LR_OK) return refuse(world, name, refusal.status, refusal.why);
    }
    if (!accepted(world) || !world->reserve_contact()) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    lr::Colliders& colliders = world->colliders;
    lr_status status = colliders.begin_create(count);
    for (uint32_t i = 0; i < count && status == LR_OK; ++i) {
        all.read(i, d);
        clear_unused(d);
        status = colliders.create(d);
    }
    if (status == LR_OK) status = colliders.finish_create(out_ids);
    if (status == LR_OK) return status;
    colliders.cancel_create();
    return refuse(world, name, status,
                  status == LR_ERROR_INVALID_ARGUMENT ? "a hull is flat, or a mesh has no area" : nullptr);
}

lr_status lr_inner_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count) {
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!colliders) return refuse(world, "lr_collider_destroy", LR_ERROR_NULL_ARGUMENT);
    if (!world->colliders.can_destroy(colliders, count))
        return refuse(world, "lr_collider_destroy", LR_ERROR_STALE_COLLIDER);
    // What rests on them would hang in the air.
    uint32_t slot = 0;
    const bool resting = world->any_resting();
    for (uint32_t i = 0; i < count && resting; ++i)
        if (world->colliders.find(colliders[i], slot)) world->wake_at(slot);
    const lr_status status = world->colliders.destroy(colliders, count);
    world->recheck_contacts();
    return status;
}

lr_status lr_collider_motion_init(lr_collider_motion* motion, uint32_t struct_size) {
    const lr_status status = begin_init(motion, struct_size);
    if (status != LR_OK) return status;
    motion->mode = LR_MOVE_TO;
    motion->orientation[3] = 1.0f;
    return LR_OK;
}

lr_status lr_inner_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count) {
    const lr::FloatMode mode;
    constexpr const char* name = "lr_collider_move";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    if (count == 0) return LR_OK;
    if (!motions) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    const ArrayOf<lr_collider_motion> all(motions);
    lr::Colliders& colliders = world->colliders;
    lr_collider_motion m{};
    uint32_t slot = 0;
    colliders.begin_reserve();
    for (uint32_t i = 0; i < count; ++i) {
        const lr_status status = all.read(i, m);
        if (status != LR_OK) return refuse(world, name, status);
        if (!colliders.find(m.collider, slot)) return refuse(world, name, LR_ERROR_STALE_COLLIDER);
        const Refusal refusal = check_motion(m);
        if (refusal.status != LR_OK) return refuse(world, name, refusal.status, refusal.why);
        colliders.reserve_move(slot, m);
    }
    const bool resting = world->any_resting();
    if (!accepted(world) || !colliders.finish_reserve()) return refuse(world, name, LR_ERROR_OUT_OF_MEMORY);
    for (uint32_t i = 0; i < count; ++i) {
        all.read(i, m);
        colliders.find(m.collider, slot);
        if (resting && m.mode == LR_MOVE_PLACE) world->wake_at(slot);
        colliders.move(slot, m);
    }
    return LR_OK;
}

lr_status lr_collider_state_init(lr_collider_state* state, uint32_t struct_size) {
    const lr_status status = begin_init(state, struct_size);
    if (status == LR_OK) state->orientation[3] = 1.0f;
    return status;
}

lr_status lr_inner_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state) {
    constexpr const char* name = "lr_collider_get_state";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    uint32_t slot = 0;
    if (!world->colliders.find(collider, slot)) return refuse(world, name, LR_ERROR_STALE_COLLIDER);
    const lr_status status = check_size(state);
    if (status != LR_OK) return refuse(world, name, status);
    const lr::Collider& c = world->colliders.at(slot);
    const lr::ColliderMotion& m = world->colliders.motion(slot);
    lr_collider_state out{};
    out.kind = static_cast<int32_t>(c.geometry.kind);
    put(c.begin.position, out.position);
    const lr::Rotation& q = c.begin.rotation;
    const float orientation[4] = {q.x, q.y, q.z, q.w};
    std::copy(orientation, orientation + 4, out.orientation);
    put(m.linear, out.linear_velocity);
    put(m.angular, out.angular_velocity);
    out.friction = c.friction;
    out.restitution = c.restitution;
    out.layers = c.layers;
    write_struct(out, state);
    return LR_OK;
}

lr_status lr_collider_surface_init(lr_collider_surface* surface, uint32_t struct_size) {
    const lr_status status = begin_init(surface, struct_size);
    if (status != LR_OK) return status;
    surface->layers = 1;
    surface->friction = 0.5f;
    surface->restitution = 0.2f;
    return LR_OK;
}

lr_status lr_inner_collider_set_surface(lr_world* world, const lr_collider* colliders, uint32_t count,
                                        const lr_collider_surface* surface) {
    constexpr const char* name = "lr_collider_set_surface";
    if (!world) return LR_ERROR_NULL_ARGUMENT;
    lr_collider_surface s;
    const lr_status status = read_struct(surface, s);
    if (status != LR_OK) return refuse(world, name, status);
    if (!std::isfinite(s.friction) || !std::isfinite(s.restitution)) return refuse(world, name, LR_ERROR_NOT_FINITE);
    if (const char* why = lr::wrong_surface(s.friction, s.restitution))
        return refuse(world, name, LR_ERROR_INVALID_ARGUMENT, why);
    if (count == 0) return LR_OK;
    if (!colliders) return refuse(world, name, LR_ERROR_NULL_ARGUMENT);
    uint32_t slot = 0;
    for (uint32_t i = 0; i < count; ++i)
        if (!world->colliders.find(colliders[i], slot)) return refuse(world, name, LR_ERROR_STALE_COLLIDER);
    for (uint32_t i = 0; i < count; ++i) {
        world->colliders.find(colliders[i], slot);
        world->colliders.set_surface(slot, s.friction, s.restitution, s.layers);
    }
    return LR_OK;
}

} // extern "C"
