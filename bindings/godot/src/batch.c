/*
 * LangevinBatch: the bodies of one asset, how they are born and end, and what they feel.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <math.h>
#include <string.h>

enum { ENTER_TREE = 10, EXIT_TREE = 11, ENTER_WORLD = 41, EXIT_WORLD = 42, VISIBILITY_CHANGED = 43 };
enum { TRANSFORM_CHANGED = 2000 };

asset_node* batch_asset(const batch_node* self) {
    return gd_instance_of(gd_to_object(&self->asset), &asset_class);
}

static void complain(const batch_node* self, const char* what, lr_status status) {
    if (status != LR_OK) {
        const asset_node* asset = batch_asset(self);
        gd_error("%s, %s: %s", asset ? asset->info.name : "batch", what, lr_status_string(status));
    }
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* From properties to the library                                                                                     */

static void apply_rules(batch_node* self) {
    lr_batch_rules rules;
    lr_batch_rules_init(&rules, sizeof rules);
    rules.action = self->respawn ? LR_END_RESPAWN : LR_END_DESTROY;
    rules.max_age = (float)self->lifetime;
    if (self->bounds[3] != 0.0f && self->bounds[4] != 0.0f && self->bounds[5] != 0.0f) {
        lr_kill_volume* volume = &rules.volumes[rules.volume_count++];
        volume->shape = LR_VOLUME_BOX;
        volume->side = LR_KILL_OUTSIDE;
        for (int i = 0; i < 3; ++i) {
            volume->size[i] = 0.5f * fabsf(self->bounds[3 + i]);
            volume->center[i] = self->bounds[i] + 0.5f * self->bounds[3 + i];
        }
    }
    complain(self, "rules", lr_batch_set_rules(self->world->world, self->batch, &rules));
}

static void apply_emitter(batch_node* self) {
    float global[12], scale[3];
    lr_emitter_desc desc;
    lr_emitter_desc_init(&desc, sizeof desc);
    desc.shape = LR_EMIT_BOX;
    if (gd_call_floats(self->base.object, GD_N_get_global_transform, GDX_TRANSFORM3D, global) &&
        transform_split(global, desc.position, desc.orientation, scale))
        for (int i = 0; i < 3; ++i) desc.size[i] = self->extents[i] * fabsf(scale[i]);
    desc.pose = self->random_orientation ? LR_POSE_RANDOM : LR_POSE_FIXED;
    memcpy(desc.body_orientation, desc.orientation, sizeof desc.body_orientation);
    const float* v = self->velocity;
    const float speed = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (speed > 0.0f) memcpy(desc.direction, v, sizeof desc.direction);
    desc.speed_min = desc.speed_max = speed;
    desc.spread = (float)(self->spread * 3.14159265358979 / 180.0);
    desc.spin_max = (float)self->spin;
    desc.scale_min = (float)fmin(self->scale_min, self->scale_max);
    desc.scale_max = (float)fmax(self->scale_min, self->scale_max);
    desc.rate = self->emitting ? (float)self->rate : 0.0f;
    complain(self, "emitter", lr_batch_set_emitter(self->world->world, self->batch, &desc));
}

static void apply_all(batch_node* self) {
    lr_world* world = self->world->world;
    lr_load_gains gains;
    lr_load_gains_init(&gains, sizeof gains);
    gains.drag = (float)self->drag;
    gains.lift = (float)self->lift;
    gains.spin_drag = (float)self->spin_drag;
    gains.turbulence = (float)self->turbulence;
    complain(self, "gains", lr_batch_set_load_gains(world, self->batch, &gains));
    lr_batch_contact contact;
    lr_batch_contact_init(&contact, sizeof contact);
    contact.layers = (uint32_t)self->collision_mask;
    contact.friction = (float)self->friction;
    contact.restitution = (float)self->bounce;
    complain(self, "contact", lr_batch_set_contact(world, self->batch, &contact));
    int32_t meets = 0;
    lr_batch_get_pair_contact(world, self->batch, self->batch, &meets);
    if (meets != (self->body_contact != 0))
        complain(self, "body_contact",
                 lr_batch_set_pair_contact(world, self->batch, self->batch, self->body_contact != 0));
    complain(self, "rate_divisor", lr_batch_set_rate(world, self->batch, (uint32_t)self->rate_divisor));
}

void batch_ensure(batch_node* self) {
    if (!self->world || !self->world->world) return;
    if (self->rebuild) {
        batch_leave(self);
        self->rebuild = 0;
        const asset_node* asset = batch_asset(self);
        if (!asset || !asset->asset) return; /* the editor shows a warning on the node */
        lr_batch_desc desc;
        lr_batch_desc_init(&desc, sizeof desc);
        desc.asset = asset->asset;
        desc.capacity = (uint32_t)self->capacity;
        const lr_status status = lr_batch_create(self->world->world, &desc, &self->batch);
        complain(self, "batch", status);
        if (status != LR_OK) return;
        batch_draw_changed(self);
        apply_all(self);
        apply_emitter(self);
        apply_rules(self);
        self->retune = self->moved = 0;
        const int64_t first = self->initial_count < self->capacity ? self->initial_count : self->capacity;
        if (first > 0)
            complain(self, "initial_count", lr_batch_emit(self->world->world, self->batch, (uint32_t)first, NULL));
    }
    if (!self->batch) return;
    if (self->retune) {
        apply_all(self);
        apply_emitter(self); /* before the rules, which may need one */
        apply_rules(self);
    } else if (self->moved) {
        apply_emitter(self);
    }
    self->retune = self->moved = 0;
}

void batch_leave(batch_node* self) {
    if (self->batch && self->world && self->world->world) lr_batch_destroy(self->world->world, self->batch);
    self->batch = 0;
    self->rebuild = 1;
    self->drawn = self->moving = 0;
    self->revision = 0;
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Class                                                                                                              */

static void construct(void* instance) {
    batch_node* self = instance;
    transform_identity(self->mesh_transform);
    self->cast_shadow = 1;
    self->layers = 1;
    self->capacity = 1000;
    self->initial_count = 0;
    self->emitting = 1;
    self->rate = 100.0;
    self->scale_min = self->scale_max = 1.0;
    self->random_orientation = 1;
    self->drag = self->lift = self->spin_drag = self->turbulence = 1.0;
    self->collision_mask = 4294967295;
    self->friction = 0.5;
    self->bounce = 0.1;
    self->rate_divisor = 1;
    self->rebuild = 1;
}

static void destruct(void* instance) {
    batch_node* self = instance;
    if (self->world) {
        batch_leave(self);
        world_remove_batch(self->world, self);
    }
    batch_draw_end(self);
    gd_free(&self->asset);
    gd_free(&self->mesh);
    gd_free(&self->material);
}

static world_node* world_above(batch_node* self) {
    gdx_object node = gd_call_object(self->base.object, GD_N_get_parent);
    while (node) {
        world_node* world = gd_instance_of(node, &world_class);
        if (world) return world;
        node = gd_call_object(node, GD_N_get_parent);
    }
    return NULL;
}

static void notification(void* instance, int32_t what) {
    batch_node* self = instance;
    if (gd.in_editor) return;
    world_node* world;
    switch (what) {
    case ENTER_TREE:
        world = world_above(self);
        if (!world) {
            gd_warning("a LangevinBatch is not below a LangevinWorld: nothing will move it");
            break;
        }
        world_add_batch(world, self);
        gd_call(self->base.object, GD_N_set_notify_transform, NULL, 1, gd_bool(1));
        break;
    case EXIT_TREE:
        if (!self->world) break;
        batch_leave(self);
        world_remove_batch(self->world, self);
        break;
    case ENTER_WORLD:
        batch_draw_begin(self);
        break;
    case EXIT_WORLD:
        batch_draw_end(self);
        break;
    case VISIBILITY_CHANGED:
        batch_draw_changed(self);
        break;
    case TRANSFORM_CHANGED:
        self->moved = 1;
        break;
    default:
        break;
    }
}

static void warnings_changed(batch_node* self) {
    if (gd.in_editor) gd_call(self->base.object, GD_N_update_configuration_warnings, NULL, 0);
}

static void rebuild(void* instance) {
    ((batch_node*)instance)->rebuild = 1;
    warnings_changed(instance);
}

static void retune(void* instance) {
    ((batch_node*)instance)->retune = 1;
}

static void mesh_changed(void* instance) {
    batch_draw_changed(instance);
    warnings_changed(instance);
}

static void v_warnings(void* instance, const void* const* args, void* ret) {
    batch_node* self = instance;
    const asset_node* asset = batch_asset(self);
    gd_var list = gd_empty(GDX_PACKED_STRING_ARRAY);
    (void)args;
    if (!world_above(self))
        gd_call_in_place(&list, GD_N_append, NULL, 1,
                         gd_string("Put this node below a LangevinWorld, which steps its bodies."));
    if (!asset || !asset->asset)
        gd_call_in_place(&list, GD_N_append, NULL, 1,
                         gd_string("Assign an asset: an .lrb file that lr_bake has made of the mesh."));
    if (gd_type(&self->mesh) == GDX_NIL)
        gd_call_in_place(&list, GD_N_append, NULL, 1, gd_string("Assign a mesh: without one nothing is drawn."));
    gd.destroy[GDX_PACKED_STRING_ARRAY](ret);
    gd.to_type[GDX_PACKED_STRING_ARRAY](ret, &list);
    gd_free(&list);
}

#define F(field) offsetof(batch_node, field)
#define NUMBER(field_name, least, most, shown, then)                                                                   \
    {                                                                                                                  \
        .name = #field_name, .type = GDX_FLOAT, .offset = F(field_name), .hint = GD_HINT_RANGE, .hint_string = shown,  \
        .minimum = least, .maximum = most, .changed = then                                                             \
    }
#define COUNT(field_name, least, most, shown, then)                                                                    \
    {                                                                                                                  \
        .name = #field_name, .type = GDX_INT, .offset = F(field_name), .hint = GD_HINT_RANGE, .hint_string = shown,    \
        .minimum = least, .maximum = most, .changed = then                                                             \
    }
#define GROUP(title)                                                                                                   \
    { .name = title, .type = GDX_NIL }

static const gd_property properties[] = {
    {.name = "asset",
     .type = GDX_OBJECT,
     .offset = F(asset),
     .hint = GD_HINT_RESOURCE_TYPE,
     .hint_string = "LangevinAsset",
     .changed = rebuild},
    COUNT(capacity, 1, 1 << 26, "1,100000,1,or_greater", rebuild),
    GROUP("Drawing"),
    {.name = "mesh",
     .type = GDX_OBJECT,
     .offset = F(mesh),
     .hint = GD_HINT_RESOURCE_TYPE,
     .hint_string = "Mesh",
     .changed = mesh_changed},
    {.name = "mesh_transform", .type = GDX_TRANSFORM3D, .offset = F(mesh_transform), .changed = batch_draw_changed},
    {.name = "material_override",
     .type = GDX_OBJECT,
     .offset = F(material),
     .hint = GD_HINT_RESOURCE_TYPE,
     .hint_string = "Material",
     .changed = batch_draw_changed},
    {.name = "cast_shadow",
     .type = GDX_INT,
     .offset = F(cast_shadow),
     .hint = GD_HINT_ENUM,
     .hint_string = "Off,On,Double-Sided,Shadows Only",
     .minimum = 0,
     .maximum = 3,
     .changed = batch_draw_changed},
    {.name = "layers",
     .type = GDX_INT,
     .offset = F(layers),
     .hint = GD_HINT_LAYERS_3D_RENDER,
     .minimum = 0,
     .maximum = 4294967295.0,
     .changed = batch_draw_changed},
    {.name = "custom_aabb", .type = GDX_AABB, .offset = F(custom_aabb), .changed = batch_draw_changed},
    GROUP("Emitter"),
    {.name = "emitting", .type = GDX_BOOL, .offset = F(emitting), .changed = retune},
    COUNT(initial_count, 0, 1 << 26, "0,100000,1,or_greater", NULL),
    {.name = "emission_rate",
     .type = GDX_FLOAT,
     .offset = F(rate),
     .hint = GD_HINT_RANGE,
     .hint_string = "0,10000,0.1,or_greater,suffix:1/s",
     .minimum = 0,
     .maximum = 1e9,
     .changed = retune},
    {.name = "emission_extents",
     .type = GDX_VECTOR3,
     .offset = F(extents),
     .hint_string = "suffix:m",
     .minimum = 0,
     .maximum = 1e9,
     .changed = retune},
    {.name = "initial_velocity",
     .type = GDX_VECTOR3,
     .offset = F(velocity),
     .hint_string = "suffix:m/s",
     .minimum = -1e5,
     .maximum = 1e5,
     .changed = retune},
    NUMBER(spread, 0, 180, "0,180,0.1,suffix:deg", retune),
    NUMBER(spin, 0, 1e5, "0,50,0.1,or_greater,suffix:rad/s", retune),
    {.name = "random_orientation", .type = GDX_BOOL, .offset = F(random_orientation), .changed = retune},
    NUMBER(scale_min, 0.001, 1000, "0.1,10,0.01,or_less,or_greater", retune),
    NUMBER(scale_max, 0.001, 1000, "0.1,10,0.01,or_less,or_greater", retune),
    GROUP("End"),
    NUMBER(lifetime, 0, 1e6, "0,120,0.1,or_greater,suffix:s", retune),
    {.name = "bounds", .type = GDX_AABB, .offset = F(bounds), .hint_string = "suffix:m", .changed = retune},
    {.name = "respawn", .type = GDX_BOOL, .offset = F(respawn), .changed = retune},
    GROUP("Motion"),
    NUMBER(drag, 0, 100, "0,4,0.01,or_greater", retune),
    NUMBER(lift, 0, 100, "0,4,0.01,or_greater", retune),
    NUMBER(spin_drag, 0, 100, "0,4,0.01,or_greater", retune),
    NUMBER(turbulence, 0, 100, "0,4,0.01,or_greater", retune),
    COUNT(rate_divisor, 1, 1024, "1,16,1,or_greater", retune),
    GROUP("Collision"),
    {.name = "collision_mask",
     .type = GDX_INT,
     .offset = F(collision_mask),
     .hint = GD_HINT_LAYERS_3D_PHYSICS,
     .minimum = 0,
     .maximum = 4294967295.0,
     .changed = retune},
    NUMBER(friction, 0, 10, "0,2,0.01,or_greater", retune),
    NUMBER(bounce, 0, 1, "0,1,0.01", retune),
    {.name = "body_contact", .type = GDX_BOOL, .offset = F(body_contact), .changed = retune},
    {.name = NULL},
};

#define BODIES                                                                                                         \
    { "bodies", GDX_PACKED_INT64_ARRAY, NULL }
#define POSITIONS                                                                                                      \
    { "positions", GDX_PACKED_VECTOR3_ARRAY, NULL }
static const gd_signal signals[] = {
    {"touched", 3, {BODIES, POSITIONS, {"speeds", GDX_PACKED_FLOAT32_ARRAY, NULL}}},
    {"landed", 2, {BODIES, POSITIONS}},
    {"woke", 2, {BODIES, POSITIONS}},
    {"ended", 2, {BODIES, POSITIONS}},
    {"faulted", 2, {BODIES, POSITIONS}},
    {.name = NULL},
};

static const gd_virtual virtuals[] = {{GD_N__get_configuration_warnings, v_warnings}, {0, NULL}};

const gd_class batch_class = {.name = "LangevinBatch",
                              .parent = "Node3D",
                              .size = sizeof(batch_node),
                              .construct = construct,
                              .destruct = destruct,
                              .notification = notification,
                              .properties = properties,
                              .methods = batch_methods,
                              .signals = signals,
                              .virtuals = virtuals};
