/*
 * The editor's side: lines that show a batch's emitter and a world's wind, and the selection, which begins a preview.
 * These classes exist in the editor only.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <math.h>
#include <string.h>

enum { ENTER_TREE = 10, EXIT_TREE = 11 };

void node_redraw(const gd_instance* node) {
    if (gd.in_editor) gd_call(node->object, GD_N_update_gizmos, NULL, 0);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Lines                                                                                                              */

typedef struct lines {
    float points[64][3]; /* two a line */
    int count;
} lines;

static void add_line(lines* l, const float* a, const float* b) {
    if (l->count + 2 > 64) return;
    memcpy(l->points[l->count++], a, 3 * sizeof(float));
    memcpy(l->points[l->count++], b, 3 * sizeof(float));
}

/* From -half to half about the centre, mapped by rows of 3x4. */
static void add_box(lines* l, const float* center, const float* half, const float* rows) {
    float corners[8][3];
    for (int c = 0; c < 8; ++c) {
        float at[3];
        for (int i = 0; i < 3; ++i) at[i] = center[i] + (c >> i & 1 ? half[i] : -half[i]);
        for (int i = 0; i < 3; ++i)
            corners[c][i] = rows[4 * i] * at[0] + rows[4 * i + 1] * at[1] + rows[4 * i + 2] * at[2] + rows[4 * i + 3];
    }
    for (int c = 0; c < 8; ++c)
        for (int i = 0; i < 3; ++i)
            if (!(c >> i & 1)) add_line(l, corners[c], corners[c | 1 << i]);
}

/* Two vectors of that length across `v`. */
static void across(const float* v, float length, float* a, float* b) {
    const float norm = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const float n[3] = {v[0] / norm, v[1] / norm, v[2] / norm};
    const float up[3] = {0.0f, fabsf(n[1]) < 0.9f ? 1.0f : 0.0f, fabsf(n[1]) < 0.9f ? 0.0f : 1.0f};
    a[0] = n[1] * up[2] - n[2] * up[1], a[1] = n[2] * up[0] - n[0] * up[2], a[2] = n[0] * up[1] - n[1] * up[0];
    const float scale = length / sqrtf(a[0] * a[0] + a[1] * a[1] + a[2] * a[2]);
    for (int i = 0; i < 3; ++i) a[i] *= scale;
    b[0] = n[1] * a[2] - n[2] * a[1], b[1] = n[2] * a[0] - n[0] * a[2], b[2] = n[0] * a[1] - n[1] * a[0];
}

static void add_arrow(lines* l, const float* v) {
    static const float origin[3] = {0, 0, 0};
    const float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0.0f)) return;
    float sides[2][3], barb[3];
    across(v, 0.1f * length, sides[0], sides[1]);
    add_line(l, origin, v);
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) barb[k] = 0.8f * v[k] + (i & 1 ? 1.0f : -1.0f) * sides[i >> 1][k];
        add_line(l, v, barb);
    }
}

/* Eight lines at this half angle about `v`. */
static void add_cone(lines* l, const float* v, float angle) {
    static const float origin[3] = {0, 0, 0};
    const float length = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0.0f) || !(angle > 0.0f)) return;
    float sides[2][3], end[3];
    across(v, length, sides[0], sides[1]);
    for (int i = 0; i < 8; ++i) {
        const float turn = 0.785398163f * (float)i;
        for (int k = 0; k < 3; ++k)
            end[k] = cosf(angle) * v[k] + sinf(angle) * (cosf(turn) * sides[0][k] + sinf(turn) * sides[1][k]);
        add_line(l, origin, end);
    }
}

static void draw(const gd_instance* plugin, gdx_object gizmo, const char* material, const lines* l, int clickable) {
    if (l->count == 0) return;
    gd_var points = gd_array(GDX_PACKED_VECTOR3_ARRAY, l->count), look;
    float* data = gd_data(&points);
    if (data) memcpy(data, l->points, (size_t)l->count * sizeof l->points[0]);
    if (data && gd_call(plugin->object, GD_N_get_material, &look, 2, gd_string(material), gd_object(gizmo))) {
        gd_call(gizmo, GD_N_add_lines, NULL, 2, gd_copy(&points), look);
        if (clickable) gd_call(gizmo, GD_N_add_collision_segments, NULL, 1, gd_copy(&points));
    }
    gd_free(&points);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Gizmos                                                                                                             */

static void draw_batch(const gd_instance* plugin, gdx_object gizmo, const batch_node* batch) {
    static const float identity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0}, origin[3] = {0, 0, 0};
    float rows[12], global[12];
    lines emitter = {.count = 0}, bounds = {.count = 0}, velocity = {.count = 0};
    add_box(&emitter, origin, batch->extents, identity);
    draw(plugin, gizmo, "emitter", &emitter, 1);
    /* A gizmo has the node's frame; velocity and bounds have the scene's. */
    if (!gd_call_floats(batch->base.object, GD_N_get_global_transform, GDX_TRANSFORM3D, global) ||
        !transform_invert_to_rows(global, rows))
        return;
    float v[3];
    for (int i = 0; i < 3; ++i)
        v[i] = rows[4 * i] * batch->velocity[0] + rows[4 * i + 1] * batch->velocity[1] +
               rows[4 * i + 2] * batch->velocity[2];
    add_arrow(&velocity, v);
    add_cone(&velocity, v, (float)(batch->spread * 3.14159265358979 / 180.0));
    draw(plugin, gizmo, "emitter", &velocity, 0);
    const float* box = batch->bounds;
    if (box[3] == 0.0f || box[4] == 0.0f || box[5] == 0.0f) return;
    const float half[3] = {0.5f * box[3], 0.5f * box[4], 0.5f * box[5]};
    const float center[3] = {box[0] + half[0], box[1] + half[1], box[2] + half[2]};
    add_box(&bounds, center, half, rows);
    draw(plugin, gizmo, "bounds", &bounds, 0);
}

static void draw_world(const gd_instance* plugin, gdx_object gizmo, const world_node* world) {
    float rows[12], global[12], v[3];
    lines wind = {.count = 0};
    if (!gd_call_floats(world->base.object, GD_N_get_global_transform, GDX_TRANSFORM3D, global) ||
        !transform_invert_to_rows(global, rows))
        return;
    for (int i = 0; i < 3; ++i)
        v[i] = rows[4 * i] * world->wind[0] + rows[4 * i + 1] * world->wind[1] + rows[4 * i + 2] * world->wind[2];
    add_arrow(&wind, v);
    draw(plugin, gizmo, "wind", &wind, 1);
}

static void v_gizmo_name(void* instance, const void* const* args, void* ret) {
    gd_var name = gd_string("Langevin Rigid");
    (void)instance;
    (void)args;
    gd.destroy[GDX_STRING](ret);
    gd.to_type[GDX_STRING](ret, &name);
    gd_free(&name);
}

/* The world of a node of ours: itself, or a batch's. */
static world_node* world_of(gdx_object node) {
    world_node* world = gd_instance_of(node, &world_class);
    const batch_node* batch = world ? NULL : gd_instance_of(node, &batch_class);
    return batch ? batch->world : world;
}

static void v_is_ours(void* instance, const void* const* args, void* ret) {
    gdx_object node = *(gdx_object const*)args[0];
    (void)instance;
    *(uint8_t*)ret = gd_instance_of(node, &world_class) || gd_instance_of(node, &batch_class);
}

static void v_redraw(void* plugin, const void* const* args, void* ret) {
    gdx_object gizmo = gd.ref_get_object(args[0]);
    gdx_object node = gizmo ? gd_call_object(gizmo, GD_N_get_node_3d) : NULL;
    const world_node* world = gd_instance_of(node, &world_class);
    const batch_node* batch = gd_instance_of(node, &batch_class);
    (void)ret;
    if (!gizmo) return;
    gd_call(gizmo, GD_N_clear, NULL, 0);
    if (world) draw_world(plugin, gizmo, world);
    if (batch) draw_batch(plugin, gizmo, batch);
}

static const gd_virtual gizmo_virtuals[] = {
    {GD_N__has_gizmo, v_is_ours}, {GD_N__get_gizmo_name, v_gizmo_name}, {GD_N__redraw, v_redraw}, {0, NULL}};

const gd_class gizmo_class = {.name = "LangevinGizmoPlugin",
                              .parent = "EditorNode3DGizmoPlugin",
                              .size = sizeof(gd_instance),
                              .virtuals = gizmo_virtuals,
                              .internal = 1};

/* ------------------------------------------------------------------------------------------------------------------ */
/* Plugin                                                                                                             */

typedef struct editor_plugin {
    gd_instance base;
    gd_var gizmos;  /* the gizmo plugin */
    uint64_t world; /* instance id of the selected one */
} editor_plugin;

static void select_world(editor_plugin* self, const world_node* next) {
    const uint64_t id = next ? next->base.id : 0;
    if (id == self->world && (!next || next->selected)) return; /* leaving the tree ends a selection too */
    world_node* before = self->world ? gd_instance_of(gd.object_get_instance_from_id(self->world), &world_class) : NULL;
    self->world = id;
    if (before) world_select(before, 0);
    if (next) world_select((world_node*)next, 1);
}

static void v_edit(void* instance, const void* const* args, void* ret) {
    (void)ret;
    select_world(instance, world_of(*(gdx_object const*)args[0]));
}

static void plugin_notification(void* instance, int32_t what) {
    static const struct {
        const char* name;
        float color[4];
    } materials[] = {{"emitter", {0.55f, 0.85f, 0.3f, 1.0f}},
                     {"bounds", {0.55f, 0.85f, 0.3f, 0.35f}},
                     {"wind", {0.45f, 0.75f, 1.0f, 1.0f}}};
    editor_plugin* self = instance;
    if (what == ENTER_TREE && gd_type(&self->gizmos) == GDX_NIL) {
        self->gizmos = gd_object(gd_construct(&gizmo_class));
        for (size_t i = 0; i < sizeof materials / sizeof *materials; ++i)
            gd_call(gd_to_object(&self->gizmos), GD_N_create_material, NULL, 2, gd_string(materials[i].name),
                    gd_color(materials[i].color));
        gd_call(self->base.object, GD_N_add_node_3d_gizmo_plugin, NULL, 1, gd_copy(&self->gizmos));
    } else if (what == EXIT_TREE && gd_type(&self->gizmos) != GDX_NIL) {
        select_world(self, NULL);
        gd_call(self->base.object, GD_N_remove_node_3d_gizmo_plugin, NULL, 1, gd_copy(&self->gizmos));
        gd_free(&self->gizmos);
    }
}

static void plugin_destruct(void* instance) {
    gd_free(&((editor_plugin*)instance)->gizmos);
}

static const gd_virtual plugin_virtuals[] = {{GD_N__handles, v_is_ours}, {GD_N__edit, v_edit}, {0, NULL}};

const gd_class plugin_class = {.name = "LangevinEditorPlugin",
                               .parent = "EditorPlugin",
                               .size = sizeof(editor_plugin),
                               .destruct = plugin_destruct,
                               .notification = plugin_notification,
                               .virtuals = plugin_virtuals,
                               .internal = 1};
