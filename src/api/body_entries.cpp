// Exported functions of bodies and colliders: how calls come in.
#include "api/entry.h"

using namespace lr::api;

namespace {

// With the arrays that a collider of its kind is made of.
void tell_colliders(Call& call, const lr_collider_desc* descs, uint32_t count) {
    call.structures(descs, count, [&](const lr_collider_desc& d) {
        const bool mesh = d.kind == LR_COLLIDER_MESH, field = d.kind == LR_COLLIDER_HEIGHTFIELD;
        call.shared_array(mesh || d.kind == LR_COLLIDER_HULL ? d.vertices : nullptr, 12 * uint64_t{d.vertex_count});
        call.shared_array(mesh ? d.indices : nullptr, 12 * uint64_t{d.triangle_count});
        call.shared_array(field ? d.heights : nullptr, 4 * uint64_t{d.counts[0]} * d.counts[1]);
    });
}

} // namespace

extern "C" {

lr_status lr_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count, lr_body* out_ids) {
    return change(
        world, Op::body_create, [&] { return lr_inner_body_create(world, batch, descs, count, out_ids); },
        [&](Call& call) {
            call.value(batch);
            call.structures(descs, count);
            call.output(out_ids, count);
        });
}

lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count) {
    return change(
        world, Op::body_destroy, [&] { return lr_inner_body_destroy(world, bodies, count); },
        [&](Call& call) {
            call.value(count);
            call.array(bodies, 8 * uint64_t{count});
        });
}

lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state) {
    return plain_query(world, "lr_body_get_state", &lr_inner_body_get_state, body, state);
}

lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state) {
    return plain_change(world, Op::body_set_state, &lr_inner_body_set_state, body, state);
}

lr_status lr_body_set_rest(lr_world* world, const lr_body* bodies, uint32_t count, int32_t rest) {
    return change(
        world, Op::body_set_rest, [&] { return lr_inner_body_set_rest(world, bodies, count, rest); },
        [&](Call& call) {
            call.value(count);
            call.value(rest);
            call.array(bodies, 8 * uint64_t{count});
        });
}

lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count) {
    return change(
        world, Op::body_add_force, [&] { return lr_inner_body_add_force(world, forces, count); },
        [&](Call& call) { call.structures(forces, count); });
}

lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count, lr_collider* out_ids) {
    return change(
        world, Op::collider_create, [&] { return lr_inner_collider_create(world, descs, count, out_ids); },
        [&](Call& call) {
            tell_colliders(call, descs, count);
            call.output(out_ids, count);
        });
}

lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count) {
    return change(
        world, Op::collider_destroy, [&] { return lr_inner_collider_destroy(world, colliders, count); },
        [&](Call& call) {
            call.value(count);
            call.array(colliders, 8 * uint64_t{count});
        });
}

lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count) {
    return change(
        world, Op::collider_move, [&] { return lr_inner_collider_move(world, motions, count); },
        [&](Call& call) { call.structures(motions, count); });
}

lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state) {
    return plain_query(world, "lr_collider_get_state", &lr_inner_collider_get_state, collider, state);
}

lr_status lr_collider_set_surface(lr_world* world, const lr_collider* colliders, uint32_t count,
                                  const lr_collider_surface* surface) {
    return change(
        world, Op::collider_set_surface,
        [&] { return lr_inner_collider_set_surface(world, colliders, count, surface); },
        [&](Call& call) {
            call.value(count);
            call.structure(surface);
            call.array(colliders, 8 * uint64_t{count});
        });
}

} // extern "C"
