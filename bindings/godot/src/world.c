/*
 * LangevinWorld: creates the library's world on entering the tree, steps it, and emits its signals.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <stdlib.h>
#include <string.h>

enum { ENTER_TREE = 10, EXIT_TREE = 11, INTERNAL_PROCESS = 25, INTERNAL_PHYSICS_PROCESS = 26 };

/* The world skips the rest of a longer frame: the game stood still, and so did the leaves. */
#define LONGEST_STEP 0.25

/* Not for errors: they are reported with the name of the failed call. */
static void on_log(void* user, int32_t level, const char* message) {
    (void)user;
    if (level == LR_LOG_WARNING) gd_warning("%s", message);
}

/* In the editor in idle frames: no physics runs there. */
static void set_processing(world_node* self) {
    const int runs = self->world != NULL;
    const int64_t when = gd.in_editor ? PROCESS_IDLE : self->process_callback;
    gd_call(self->base.object, GD_N_set_physics_process_internal, NULL, 1, gd_bool(runs && when == PROCESS_PHYSICS));
    gd_call(self->base.object, GD_N_set_process_internal, NULL, 1, gd_bool(runs && when == PROCESS_IDLE));
}

static void apply_events(world_node* self) {
    if (!self->world || gd.in_editor) return; /* no script of the game hears them there */
    const uint32_t capacity = self->events ? (uint32_t)self->event_capacity : 0u;
    const lr_status status = lr_world_set_events(self->world, capacity, (uint32_t)self->events);
    if (status != LR_OK) gd_error("events: %s", lr_status_string(status));
}

static void start(world_node* self) {
    if (self->world || (gd.in_editor && !(self->preview && self->selected))) return;
    lr_world_desc desc;
    lr_world_desc_init(&desc, sizeof desc);
    desc.seed = (uint64_t)self->seed;
    desc.worker_count = (uint32_t)self->workers;
    memcpy(desc.gravity, self->gravity, sizeof desc.gravity);
    desc.simd_target = (int32_t)self->simd;
    desc.log = on_log;
    lr_status status = lr_world_create(&desc, &self->world);
    if (status == LR_ERROR_UNSUPPORTED) {
        gd_warning("simd: this processor or build has no %s; the best available one is used, with the same results",
                   lr_simd_target_name(desc.simd_target));
        desc.simd_target = LR_SIMD_AUTO;
        status = lr_world_create(&desc, &self->world);
    }
    if (status != LR_OK) {
        gd_error("world: %s", lr_status_string(status));
        return;
    }
    self->gusts = self->turbulence = (lr_wind_source){0};
    self->areas.active = 0;
    self->last_status = LR_OK;
    self->wind_changed = self->tree_changed = 1;
    apply_events(self);
}

static void stop(world_node* self) {
    for (uint32_t i = 0; i < self->batch_count; ++i) batch_leave(self->batches[i]);
    world_forget_colliders(self, 0);
    lr_world_destroy(self->world);
    self->world = NULL;
    gd_free(&self->recording);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Signals of the tree: nodes come and go, among them colliders and areas.                                            */

static void watch_tree(world_node* self, int on) {
    if (on) {
        gdx_object tree = gd_call_object(self->base.object, GD_N_get_tree);
        if (!tree) return;
        self->tree = gd.object_get_instance_id(tree);
    }
    gdx_object tree = self->tree ? gd.object_get_instance_from_id(self->tree) : NULL;
    static const int signals[2] = {GD_N_node_added, GD_N_node_removed};
    for (int i = 0; i < 2 && tree; ++i) {
        gd_var connected = gd_nil();
        gd_call(tree, GD_N_is_connected, &connected, 2, gd_name_var(signals[i]),
                gd_callable(self->base.object, GD_N__tree_changed));
        if (gd_to_bool(&connected) != on)
            gd_call(tree, on ? GD_N_connect : GD_N_disconnect, NULL, 2, gd_name_var(signals[i]),
                    gd_callable(self->base.object, GD_N__tree_changed));
        gd_free(&connected);
    }
    if (!on) self->tree = 0;
}

/* In the editor begins only what is selected. */
static void begin(world_node* self) {
    start(self);
    if (self->world) watch_tree(self, 1);
    set_processing(self);
}

static void end(world_node* self) {
    if (self->world) watch_tree(self, 0);
    stop(self);
}

static void preview_changed(void* instance) {
    world_node* self = instance;
    if (!gd.in_editor) return;
    if (!(self->selected && self->preview)) end(self);
    begin(self);
}

void world_select(world_node* self, int selected) {
    self->selected = selected;
    preview_changed(self);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Step                                                                                                               */

void world_step(world_node* self, double dt) {
    if (!self->world || !(dt > 0.0)) return;
    if (dt > LONGEST_STEP) dt = LONGEST_STEP;
    for (uint32_t i = 0; i < self->batch_count; ++i) batch_ensure(self->batches[i]);
    if (self->tree_changed) {
        self->tree_changed = 0;
        world_scan_areas(self);
        world_scan_colliders(self);
    }
    world_sync_areas(self);
    world_sync_colliders(self);
    world_apply_wind(self);
    const lr_status status = lr_world_step(self->world, (float)dt, (uint32_t)self->substeps);
    if (status != LR_OK) {
        if (status != self->last_status) gd_error("step: %s", lr_status_string(status));
        self->last_status = status;
        /* With too little memory for all contacts, the step is still taken. */
        if (status != LR_ERROR_OUT_OF_MEMORY) return;
    }
    self->last_status = status;
    for (uint32_t i = 0; i < self->batch_count; ++i) batch_draw(self->batches[i]);
    /* Last, because a handler can free nodes, this one too. */
    if (self->events && !gd.in_editor) world_emit_events(self);
}

void world_add_batch(world_node* self, batch_node* batch) {
    if (self->batch_count == self->batch_capacity) {
        const uint32_t capacity = self->batch_capacity ? 2u * self->batch_capacity : 8u;
        batch_node** grown = realloc(self->batches, capacity * sizeof *grown);
        if (!grown) {
            gd_error("out of memory");
            return;
        }
        self->batches = grown;
        self->batch_capacity = capacity;
    }
    self->batches[self->batch_count++] = batch;
    batch->world = self;
}

void world_remove_batch(world_node* self, batch_node* batch) {
    for (uint32_t i = 0; i < self->batch_count; ++i)
        if (self->batches[i] == batch) {
            memmove(self->batches + i, self->batches + i + 1, (self->batch_count - i - 1u) * sizeof *self->batches);
            --self->batch_count;
            break;
        }
    batch->world = NULL;
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Class                                                                                                              */

static void construct(void* instance) {
    world_node* self = instance;
    self->gravity[1] = -9.81f;
    self->substeps = 2;
    self->gust_period = 10.0;
    self->turbulence_size = 1.0;
    self->wind_from_areas = 1;
    self->sync_colliders = 1;
    self->collision_mask = 1;
    self->event_capacity = 4096;
    self->preview = 1;
}

static void destruct(void* instance) {
    world_node* self = instance;
    stop(self);
    for (uint32_t i = 0; i < self->batch_count; ++i) self->batches[i]->world = NULL;
    free(self->batches);
    free(self->colliders.links);
    world_forget_areas(self);
}

static void notification(void* instance, int32_t what) {
    world_node* self = instance;
    switch (what) {
    case ENTER_TREE:
        begin(self);
        break;
    case EXIT_TREE:
        end(self);
        self->selected = 0;
        break;
    case INTERNAL_PHYSICS_PROCESS:
        world_step(self, gd_call_float(self->base.object, GD_N_get_physics_process_delta_time));
        break;
    case INTERNAL_PROCESS:
        world_step(self, gd_call_float(self->base.object, GD_N_get_process_delta_time));
        break;
    default:
        break;
    }
}

static void gravity_changed(void* instance) {
    world_node* self = instance;
    if (self->world) lr_world_set_gravity(self->world, self->gravity);
}

static void wind_changed(void* instance) {
    ((world_node*)instance)->wind_changed = 1;
    node_redraw(instance);
}

static void simd_changed(void* instance) {
    world_node* self = instance;
    if (!self->world) return;
    const lr_status status = lr_world_set_simd_target(self->world, (int32_t)self->simd);
    if (status != LR_OK) gd_warning("simd: %s: %s", lr_simd_target_name((int32_t)self->simd), lr_status_string(status));
}

static void process_changed(void* instance) {
    world_node* self = instance;
    if (self->world) set_processing(self);
}

static void scan_changed(void* instance) {
    ((world_node*)instance)->tree_changed = 1;
}

static void events_changed(void* instance) {
    apply_events(instance);
}

static void m_tree_changed(void* self, const gd_var* args, gd_var* ret) {
    static const char* const classes[] = {"CollisionObject3D", "CollisionShape3D", "CollisionPolygon3D"};
    gdx_object node = gd_to_object(&args[0]);
    (void)ret;
    for (int i = 0; i < 3 && node; ++i)
        if (gd_is_class(node, classes[i])) ((world_node*)self)->tree_changed = 1;
}

static void m_refresh(void* instance, const gd_var* args, gd_var* ret) {
    world_node* self = instance;
    (void)args;
    (void)ret;
    world_forget_colliders(self, 1);
    self->tree_changed = 1;
}

static void m_step(void* self, const gd_var* args, gd_var* ret) {
    (void)ret;
    world_step(self, gd_to_float(&args[0]));
}

static void m_reset(void* instance, const gd_var* args, gd_var* ret) {
    world_node* self = instance;
    (void)args;
    (void)ret;
    if (!self->world) return;
    stop(self);
    start(self);
    set_processing(self);
}

static void m_hash(void* instance, const gd_var* args, gd_var* ret) {
    uint64_t hash = 0;
    (void)args;
    if (((world_node*)instance)->world) lr_world_hash(((world_node*)instance)->world, &hash);
    *ret = gd_int((int64_t)hash);
}

static lr_world_info info_of_world(const world_node* self) {
    lr_world_info info;
    lr_world_info_init(&info, sizeof info);
    if (self->world) lr_world_get_info(self->world, &info);
    return info;
}

static void m_time(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_float(info_of_world(self).time);
}

static void m_body_count(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_int((int64_t)info_of_world(self).body_count);
}

static void m_awake_count(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_int((int64_t)info_of_world(self).awake_count);
}

static void m_collider_count(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_int((int64_t)info_of_world(self).collider_count);
}

static void m_simd_name(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_string(lr_simd_target_name(info_of_world(self).simd_target));
}

static void m_sample_wind(void* instance, const gd_var* args, gd_var* ret) {
    world_node* self = instance;
    float at[3], velocity[3] = {0, 0, 0};
    gd_to_floats(&args[0], GDX_VECTOR3, at);
    const lr_status status =
        self->world ? lr_world_sample_wind(self->world, at, 1, velocity) : LR_ERROR_INVALID_ARGUMENT;
    if (status != LR_OK) gd_error("sample_wind: %s", self->world ? lr_status_string(status) : "not in the tree");
    *ret = gd_vector3(velocity);
}

static void m_wake_box(void* instance, const gd_var* args, gd_var* ret) {
    world_node* self = instance;
    float box[6], low[3], high[3];
    uint32_t woken = 0;
    gd_to_floats(&args[0], GDX_AABB, box);
    for (int i = 0; i < 3; ++i) {
        low[i] = box[3 + i] < 0.0f ? box[i] + box[3 + i] : box[i];
        high[i] = box[3 + i] < 0.0f ? box[i] : box[i] + box[3 + i];
    }
    if (self->world) lr_world_wake_box(self->world, low, high, &woken);
    *ret = gd_int(woken);
}

static void m_save(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = world_save(self);
}

static void m_restore(void* self, const gd_var* args, gd_var* ret) {
    const lr_status status = world_restore(self, &args[0]);
    if (status != LR_OK) gd_error("restore_snapshot: %s", lr_status_string(status));
    *ret = gd_int(gd_error_from_status(status));
}

static void m_start_recording(void* self, const gd_var* args, gd_var* ret) {
    *ret = gd_int(world_start_recording(self, &args[0]));
}

static void m_stop_recording(void* self, const gd_var* args, gd_var* ret) {
    (void)args;
    *ret = gd_int(world_stop_recording(self));
}

#define F(field) offsetof(world_node, field)
static const gd_property properties[] = {
    {.name = "gravity",
     .type = GDX_VECTOR3,
     .offset = F(gravity),
     .minimum = -1e4,
     .maximum = 1e4,
     .changed = gravity_changed},
    {.name = "seed", .type = GDX_INT, .offset = F(seed)},
    {.name = "substeps",
     .type = GDX_INT,
     .offset = F(substeps),
     .hint = GD_HINT_RANGE,
     .hint_string = "1,16,1,or_greater",
     .minimum = 1,
     .maximum = LR_MAX_SUBSTEPS},
    {.name = "workers",
     .type = GDX_INT,
     .offset = F(workers),
     .hint = GD_HINT_RANGE,
     .hint_string = "0,64,1",
     .minimum = 0,
     .maximum = 64},
    {.name = "simd",
     .type = GDX_INT,
     .offset = F(simd),
     .hint = GD_HINT_ENUM,
     .hint_string = "Auto,SSE4,AVX2,AVX-512,NEON,WebAssembly",
     .minimum = 0,
     .maximum = 5,
     .changed = simd_changed},
    {.name = "process_callback",
     .type = GDX_INT,
     .offset = F(process_callback),
     .hint = GD_HINT_ENUM,
     .hint_string = "Physics,Idle,Manual",
     .minimum = 0,
     .maximum = 2,
     .changed = process_changed},
    {.name = "preview", .type = GDX_BOOL, .offset = F(preview), .changed = preview_changed},
    {.name = "Wind", .type = GDX_NIL},
    {.name = "wind",
     .type = GDX_VECTOR3,
     .offset = F(wind),
     .hint = GD_HINT_NONE,
     .hint_string = "suffix:m/s",
     .minimum = -1000,
     .maximum = 1000,
     .changed = wind_changed},
    {.name = "gust_speed",
     .type = GDX_FLOAT,
     .offset = F(gust_speed),
     .hint = GD_HINT_RANGE,
     .hint_string = "0,20,0.01,or_greater,suffix:m/s",
     .minimum = 0,
     .maximum = 1000,
     .changed = wind_changed},
    {.name = "gust_period",
     .type = GDX_FLOAT,
     .offset = F(gust_period),
     .hint = GD_HINT_RANGE,
     .hint_string = "0.1,60,0.1,or_greater,suffix:s",
     .minimum = 0.01,
     .maximum = 1e6,
     .changed = wind_changed},
    {.name = "turbulence_speed",
     .type = GDX_FLOAT,
     .offset = F(turbulence_speed),
     .hint = GD_HINT_RANGE,
     .hint_string = "0,20,0.01,or_greater,suffix:m/s",
     .minimum = 0,
     .maximum = 1000,
     .changed = wind_changed},
    {.name = "turbulence_size",
     .type = GDX_FLOAT,
     .offset = F(turbulence_size),
     .hint = GD_HINT_RANGE,
     .hint_string = "0.05,20,0.01,or_greater,suffix:m",
     .minimum = 1e-4,
     .maximum = 1e6,
     .changed = wind_changed},
    {.name = "wind_from_areas", .type = GDX_BOOL, .offset = F(wind_from_areas), .changed = scan_changed},
    {.name = "Collision", .type = GDX_NIL},
    {.name = "sync_colliders", .type = GDX_BOOL, .offset = F(sync_colliders), .changed = scan_changed},
    {.name = "collision_mask",
     .type = GDX_INT,
     .offset = F(collision_mask),
     .hint = GD_HINT_LAYERS_3D_PHYSICS,
     .minimum = 0,
     .maximum = 4294967295.0,
     .changed = scan_changed},
    {.name = "Signals", .type = GDX_NIL},
    {.name = "events",
     .type = GDX_INT,
     .offset = F(events),
     .hint = GD_HINT_FLAGS,
     .hint_string = "Spawned:1,Touched:2,Landed:8,Woke:16,Ended:32,Respawned:64,Diverged:128",
     .minimum = 0,
     .maximum = LR_EVENTS_ALL,
     .changed = events_changed},
    {.name = "event_capacity",
     .type = GDX_INT,
     .offset = F(event_capacity),
     .minimum = 1,
     .maximum = 1 << 24,
     .changed = events_changed},
    {.name = NULL},
};

static const gd_method methods[] = {
    {"step", m_step, 0, {"", GDX_NIL, NULL}, 1, {{"delta", GDX_FLOAT, NULL}}},
    {"reset", m_reset, 0, {"", GDX_NIL, NULL}, 0, {{0}}},
    {"refresh", m_refresh, 0, {"", GDX_NIL, NULL}, 0, {{0}}},
    {"get_state_hash", m_hash, 5, {"", GDX_INT, NULL}, 0, {{0}}},
    {"get_time", m_time, 5, {"", GDX_FLOAT, NULL}, 0, {{0}}},
    {"get_body_count", m_body_count, 5, {"", GDX_INT, NULL}, 0, {{0}}},
    {"get_awake_count", m_awake_count, 5, {"", GDX_INT, NULL}, 0, {{0}}},
    {"get_collider_count", m_collider_count, 5, {"", GDX_INT, NULL}, 0, {{0}}},
    {"get_simd_name", m_simd_name, 5, {"", GDX_STRING, NULL}, 0, {{0}}},
    {"sample_wind", m_sample_wind, 5, {"", GDX_VECTOR3, NULL}, 1, {{"position", GDX_VECTOR3, NULL}}},
    {"wake_box", m_wake_box, 0, {"", GDX_INT, NULL}, 1, {{"box", GDX_AABB, NULL}}},
    {"save_snapshot", m_save, 0, {"", GDX_PACKED_BYTE_ARRAY, NULL}, 0, {{0}}},
    {"restore_snapshot", m_restore, 0, {"", GDX_INT, NULL}, 1, {{"snapshot", GDX_PACKED_BYTE_ARRAY, NULL}}},
    {"start_recording", m_start_recording, 0, {"", GDX_INT, NULL}, 1, {{"file", GDX_OBJECT, "FileAccess"}}},
    {"stop_recording", m_stop_recording, 0, {"", GDX_INT, NULL}, 0, {{0}}},
    {"_tree_changed", m_tree_changed, 0, {"", GDX_NIL, NULL}, 1, {{"node", GDX_OBJECT, "Node"}}},
    {.name = NULL},
};

static const gd_constant constants[] = {
    {"ProcessCallback", "PROCESS_CALLBACK_PHYSICS", PROCESS_PHYSICS},
    {"ProcessCallback", "PROCESS_CALLBACK_IDLE", PROCESS_IDLE},
    {"ProcessCallback", "PROCESS_CALLBACK_MANUAL", PROCESS_MANUAL},
    {"Events", "EVENTS_SPAWNED", LR_EVENTS_SPAWNED},
    {"Events", "EVENTS_TOUCHED", LR_EVENTS_HIT},
    {"Events", "EVENTS_LANDED", LR_EVENTS_LANDED},
    {"Events", "EVENTS_WOKE", LR_EVENTS_WOKE},
    {"Events", "EVENTS_ENDED", LR_EVENTS_KILLED},
    {"Events", "EVENTS_RESPAWNED", LR_EVENTS_RESPAWNED},
    {"Events", "EVENTS_DIVERGED", LR_EVENTS_DIVERGED},
    {.name = NULL},
};

const gd_class world_class = {.name = "LangevinWorld",
                              .parent = "Node3D",
                              .size = sizeof(world_node),
                              .construct = construct,
                              .destruct = destruct,
                              .notification = notification,
                              .properties = properties,
                              .methods = methods,
                              .constants = constants};
