/*
 * Methods for scripts: single bodies, and all bodies of a batch.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <string.h>

/* The library's world, with the batch created if possible; null after an error. */
static lr_world* ready(batch_node* self, const char* what) {
    batch_ensure(self);
    if (self->world && self->world->world && self->batch.id) return self->world->world;
    gd_error("%s: the batch is not in the tree below a LangevinWorld, or has no asset", what);
    return NULL;
}

static int failed(const char* what, lr_status status) {
    if (status != LR_OK) gd_error("%s: %s", what, lr_status_string(status));
    return status != LR_OK;
}

static int view_of(batch_node* self, lr_batch_view* view) {
    lr_batch_view_init(view, sizeof *view);
    batch_ensure(self);
    return self->world && self->world->world && self->batch.id &&
           lr_batch_get_view(self->world->world, self->batch, view) == LR_OK;
}

static lr_body handle_of(const gd_var* body) {
    return (lr_body){(uint64_t)gd_to_int(body)};
}

static int state_of(batch_node* self, const gd_var* body, lr_body_state* state, const char* what) {
    lr_world* world = ready(self, what);
    lr_body_state_init(state, sizeof *state);
    return world && !failed(what, lr_body_get_state(world, handle_of(body), state));
}

static void m_emit(void* self, const gd_var* args, gd_var* ret) {
    lr_world* world = ready(self, "emit");
    const int64_t count = gd_to_int(&args[0]);
    if (world && (count < 0 || count > 0xffffffff))
        gd_error("emit: %lld bodies", (long long)count);
    else if (world && !failed("emit", lr_batch_spawn(world, ((batch_node*)self)->batch, (uint32_t)count, NULL))) {
        *ret = gd_int(GD_OK);
        return;
    }
    *ret = gd_int(GD_FAILED);
}

static void m_spawn(void* self, const gd_var* args, gd_var* ret) {
    lr_world* world = ready(self, "spawn");
    lr_body_desc desc;
    lr_body body = {0};
    float engine[12], scale[3];
    lr_body_desc_init(&desc, sizeof desc);
    gd_to_floats(&args[0], GDX_TRANSFORM3D, engine);
    gd_to_floats(&args[1], GDX_VECTOR3, desc.linear_velocity);
    gd_to_floats(&args[2], GDX_VECTOR3, desc.angular_velocity);
    if (!transform_split(engine, desc.position, desc.orientation, scale) || scale[0] < 0.0f) {
        gd_error("spawn: the transform is mirrored or flat");
    } else if (world) {
        desc.scale = scale[0];
        failed("spawn", lr_body_create(world, ((batch_node*)self)->batch, &desc, 1, &body));
    }
    *ret = gd_int((int64_t)body.id);
}

static void m_destroy_bodies(void* self, const gd_var* args, gd_var* ret) {
    lr_world* world = ready(self, "destroy_bodies");
    const int64_t count = gd_array_count(&args[0]);
    const int ok =
        world && (count == 0 || !failed("destroy_bodies",
                                        lr_body_destroy(world, (const lr_body*)gd_read(&args[0]), (uint32_t)count)));
    *ret = gd_int(ok ? GD_OK : GD_FAILED);
}

static void m_clear(void* self, const gd_var* args, gd_var* ret) {
    lr_batch_view view;
    (void)args;
    (void)ret;
    while (view_of(self, &view) && view.count > 0) {
        /* The call changes the memory that holds the ids, so they are copied in pieces, from the end. */
        lr_body ids[256];
        const uint32_t count = view.count < 256u ? view.count : 256u;
        memcpy(ids, view.ids + (view.count - count), count * sizeof *ids);
        if (failed("clear", lr_body_destroy(((batch_node*)self)->world->world, ids, count))) break;
    }
}

static void m_body_count(void* self, const gd_var* args, gd_var* ret) {
    lr_batch_view view;
    (void)args;
    *ret = gd_int(view_of(self, &view) ? view.count : 0);
}

static void m_awake_count(void* self, const gd_var* args, gd_var* ret) {
    lr_batch_view view;
    (void)args;
    *ret = gd_int(view_of(self, &view) ? view.awake_count : 0);
}

static void m_bodies(void* self, const gd_var* args, gd_var* ret) {
    lr_batch_view view;
    (void)args;
    const int ok = view_of(self, &view);
    *ret = gd_array(GDX_PACKED_INT64_ARRAY, ok ? view.count : 0);
    if (ok && view.count) memcpy(gd_data(ret), view.ids, view.count * sizeof(int64_t));
}

static void m_positions(void* self, const gd_var* args, gd_var* ret) {
    lr_batch_view view;
    (void)args;
    const int ok = view_of(self, &view);
    *ret = gd_array(GDX_PACKED_VECTOR3_ARRAY, ok ? view.count : 0);
    float* to = ok ? gd_data(ret) : NULL;
    for (uint32_t i = 0; to && i < view.count; ++i)
        for (int axis = 0; axis < 3; ++axis) to[3u * i + (uint32_t)axis] = view.position[axis][i];
}

static void m_transforms(void* instance, const gd_var* args, gd_var* ret) {
    batch_node* self = instance;
    lr_batch_view view;
    (void)args;
    const int ok = view_of(self, &view);
    *ret = gd_array(GDX_PACKED_FLOAT32_ARRAY, ok ? (int64_t)view.count * 12 : 0);
    if (ok && view.count)
        lr_batch_write_transforms(self->world->world, self->batch, LR_TRANSFORM_3X4_ROW_MAJOR, gd_data(ret), 0,
                                  view.count, NULL);
}

static void m_instance_buffer(void* instance, const gd_var* args, gd_var* ret) {
    const batch_node* self = instance;
    (void)args;
    *ret = gd_type(&self->buffer) == GDX_NIL ? gd_empty(GDX_PACKED_FLOAT32_ARRAY) : gd_copy(&self->buffer);
}

static void m_multimesh(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_rid(((batch_node*)self)->multimesh);
}

static void m_has_body(void* instance, const gd_var* args, gd_var* ret) {
    const batch_node* self = instance;
    *ret = gd_bool(self->world && self->batch.id && lr_body_is_valid(self->world->world, handle_of(&args[0])));
}

static void m_body_transform(void* self, const gd_var* args, gd_var* ret) {
    lr_body_state state;
    float engine[12];
    transform_identity(engine);
    if (state_of(self, &args[0], &state, "get_body_transform"))
        transform_join(state.position, state.orientation, state.scale, engine);
    *ret = gd_transform(engine);
}

static void m_linear_velocity(void* self, const gd_var* args, gd_var* ret) {
    lr_body_state state;
    state_of(self, &args[0], &state, "get_body_linear_velocity");
    *ret = gd_vector3(state.linear_velocity);
}

static void m_angular_velocity(void* self, const gd_var* args, gd_var* ret) {
    lr_body_state state;
    state_of(self, &args[0], &state, "get_body_angular_velocity");
    *ret = gd_vector3(state.angular_velocity);
}

static void m_age(void* self, const gd_var* args, gd_var* ret) {
    lr_body_state state;
    *ret = gd_float(state_of(self, &args[0], &state, "get_body_age") ? (double)state.age : 0.0);
}

static void m_resting(void* self, const gd_var* args, gd_var* ret) {
    lr_body_state state;
    *ret = gd_bool(state_of(self, &args[0], &state, "is_body_resting") && state.sleep_state == LR_SLEEP_ASLEEP);
}

static void m_set_transform(void* self, const gd_var* args, gd_var* ret) {
    lr_body_state state;
    float engine[12], scale[3];
    (void)ret;
    if (!state_of(self, &args[0], &state, "set_body_transform")) return;
    gd_to_floats(&args[1], GDX_TRANSFORM3D, engine);
    if (!transform_split(engine, state.position, state.orientation, scale) || scale[0] < 0.0f) {
        gd_error("set_body_transform: the transform is mirrored or flat");
        return;
    }
    state.scale = scale[0];
    failed("set_body_transform", lr_body_set_state(((batch_node*)self)->world->world, handle_of(&args[0]), &state));
}

static void add_force(void* self, const gd_var* args, gd_var* ret, int mode, const char* what) {
    lr_world* world = ready(self, what);
    lr_body_force force;
    lr_body_force_init(&force, sizeof force);
    force.mode = mode;
    force.body = handle_of(&args[0]);
    gd_to_floats(&args[1], GDX_VECTOR3, force.force);
    gd_to_floats(&args[2], GDX_VECTOR3, force.torque);
    (void)ret;
    if (world) failed(what, lr_body_add_force(world, &force, 1));
}

static void m_impulse(void* self, const gd_var* args, gd_var* ret) {
    add_force(self, args, ret, LR_FORCE_MODE_IMPULSE, "apply_impulse");
}

static void m_force(void* self, const gd_var* args, gd_var* ret) {
    add_force(self, args, ret, LR_FORCE_MODE_FORCE, "apply_force");
}

static void m_velocity(void* self, const gd_var* args, gd_var* ret) {
    add_force(self, args, ret, LR_FORCE_MODE_VELOCITY, "add_velocity");
}

#define BODY                                                                                                           \
    { "body", GDX_INT, NULL }
#define GIVES(type)                                                                                                    \
    { "", type, NULL }
#define NOTHING GIVES(GDX_NIL)
#define CONST (GDX_METHOD_NORMAL | GDX_METHOD_CONST)

const gd_method batch_methods[] = {
    {"emit", m_emit, 0, GIVES(GDX_INT), 1, {{"count", GDX_INT, NULL}}},
    {"spawn",
     m_spawn,
     0,
     GIVES(GDX_INT),
     3,
     {{"transform", GDX_TRANSFORM3D, NULL},
      {"linear_velocity", GDX_VECTOR3, NULL},
      {"angular_velocity", GDX_VECTOR3, NULL}}},
    {"destroy_bodies", m_destroy_bodies, 0, GIVES(GDX_INT), 1, {{"bodies", GDX_PACKED_INT64_ARRAY, NULL}}},
    {"clear", m_clear, 0, NOTHING, 0, {{0}}},
    {"get_body_count", m_body_count, CONST, GIVES(GDX_INT), 0, {{0}}},
    {"get_awake_count", m_awake_count, CONST, GIVES(GDX_INT), 0, {{0}}},
    {"get_bodies", m_bodies, CONST, GIVES(GDX_PACKED_INT64_ARRAY), 0, {{0}}},
    {"get_positions", m_positions, CONST, GIVES(GDX_PACKED_VECTOR3_ARRAY), 0, {{0}}},
    {"get_transforms", m_transforms, CONST, GIVES(GDX_PACKED_FLOAT32_ARRAY), 0, {{0}}},
    {"get_instance_buffer", m_instance_buffer, CONST, GIVES(GDX_PACKED_FLOAT32_ARRAY), 0, {{0}}},
    {"get_multimesh_rid", m_multimesh, CONST, GIVES(GDX_RID), 0, {{0}}},
    {"has_body", m_has_body, CONST, GIVES(GDX_BOOL), 1, {BODY}},
    {"get_body_transform", m_body_transform, CONST, GIVES(GDX_TRANSFORM3D), 1, {BODY}},
    {"set_body_transform", m_set_transform, 0, NOTHING, 2, {BODY, {"transform", GDX_TRANSFORM3D, NULL}}},
    {"get_body_linear_velocity", m_linear_velocity, CONST, GIVES(GDX_VECTOR3), 1, {BODY}},
    {"get_body_angular_velocity", m_angular_velocity, CONST, GIVES(GDX_VECTOR3), 1, {BODY}},
    {"get_body_age", m_age, CONST, GIVES(GDX_FLOAT), 1, {BODY}},
    {"is_body_resting", m_resting, CONST, GIVES(GDX_BOOL), 1, {BODY}},
    {"apply_impulse",
     m_impulse,
     0,
     NOTHING,
     3,
     {BODY, {"impulse", GDX_VECTOR3, NULL}, {"torque_impulse", GDX_VECTOR3, NULL}}},
    {"apply_force", m_force, 0, NOTHING, 3, {BODY, {"force", GDX_VECTOR3, NULL}, {"torque", GDX_VECTOR3, NULL}}},
    {"add_velocity",
     m_velocity,
     0,
     NOTHING,
     3,
     {BODY, {"linear_velocity", GDX_VECTOR3, NULL}, {"angular_velocity", GDX_VECTOR3, NULL}}},
    {.name = NULL},
};
