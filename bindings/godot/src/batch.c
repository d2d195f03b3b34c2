/*
 * LangevinBatch: all bodies of an asset, with their emitter, rules and forces.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

enum { ENTER_TREE = 10, EXIT_TREE = 11, ENTER_WORLD = 41, EXIT_WORLD = 42, VISIBILITY_CHANGED = 43 };
enum { TRANSFORM_CHANGED = 2000 };

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
    self->variation = 0.15;
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
    world_node* world;
    switch (what) {
    case ENTER_TREE:
        world = world_above(self);
        if (!world) {
            if (!gd.in_editor) /* which shows it on the node */
                gd_warning("a LangevinBatch is not below a LangevinWorld: its bodies will not move");
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
        batch_draw(self); /* its instances are of when it was hidden, and the game may be paused */
        break;
    case TRANSFORM_CHANGED:
        self->moved = 1;
        node_redraw(&self->base); /* its bounds stay where they are */
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
    node_redraw(instance);
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
                         gd_string("Assign an asset: an .lrb file that lr_bake made from the mesh."));
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
    NUMBER(variation, 0, 0.5, "0,0.5,0.01", rebuild),
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
    {"spawned", 2, {BODIES, POSITIONS}},
    {"touched", 3, {BODIES, POSITIONS, {"speeds", GDX_PACKED_FLOAT32_ARRAY, NULL}}},
    {"landed", 2, {BODIES, POSITIONS}},
    {"woke", 2, {BODIES, POSITIONS}},
    {"ended", 2, {BODIES, POSITIONS}},
    {"respawned", 2, {BODIES, POSITIONS}},
    {"diverged", 2, {BODIES, POSITIONS}},
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
