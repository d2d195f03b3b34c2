// Exported functions of bodies and colliders: how calls come in.
#include "api/entry.h"

using namespace lr::api;

extern "C" {

lr_status lr_body_create(lr_world* world, lr_batch batch, const lr_body_desc* descs, uint32_t count, lr_body* out_ids) {
    return change(world, "lr_body_create", [&] { return lr_inner_body_create(world, batch, descs, count, out_ids); });
}

lr_status lr_body_destroy(lr_world* world, const lr_body* bodies, uint32_t count) {
    return change(world, "lr_body_destroy", [&] { return lr_inner_body_destroy(world, bodies, count); });
}

lr_status lr_body_get_state(const lr_world* world, lr_body body, lr_body_state* state) {
    return query(world, "lr_body_get_state", [&] { return lr_inner_body_get_state(world, body, state); });
}

lr_status lr_body_set_state(lr_world* world, lr_body body, const lr_body_state* state) {
    return change(world, "lr_body_set_state", [&] { return lr_inner_body_set_state(world, body, state); });
}

lr_status lr_body_set_rest(lr_world* world, const lr_body* bodies, uint32_t count, int32_t rest) {
    return change(world, "lr_body_set_rest", [&] { return lr_inner_body_set_rest(world, bodies, count, rest); });
}

lr_status lr_body_add_force(lr_world* world, const lr_body_force* forces, uint32_t count) {
    return change(world, "lr_body_add_force", [&] { return lr_inner_body_add_force(world, forces, count); });
}

lr_status lr_collider_create(lr_world* world, const lr_collider_desc* descs, uint32_t count, lr_collider* out_ids) {
    return change(world, "lr_collider_create", [&] { return lr_inner_collider_create(world, descs, count, out_ids); });
}

lr_status lr_collider_destroy(lr_world* world, const lr_collider* colliders, uint32_t count) {
    return change(world, "lr_collider_destroy", [&] { return lr_inner_collider_destroy(world, colliders, count); });
}

lr_status lr_collider_move(lr_world* world, const lr_collider_motion* motions, uint32_t count) {
    return change(world, "lr_collider_move", [&] { return lr_inner_collider_move(world, motions, count); });
}

lr_status lr_collider_get_state(const lr_world* world, lr_collider collider, lr_collider_state* state) {
    return query(world, "lr_collider_get_state", [&] { return lr_inner_collider_get_state(world, collider, state); });
}

lr_status lr_collider_set_surface(lr_world* world, const lr_collider* colliders, uint32_t count,
                                  const lr_collider_surface* surface) {
    return change(world, "lr_collider_set_surface",
                  [&] { return lr_inner_collider_set_surface(world, colliders, count, surface); });
}

} // extern "C"
