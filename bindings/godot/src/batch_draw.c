/*
 * Drawing a batch: a multimesh of the rendering server with an instance at the origin, since bodies are in the scene's
 * space. The library writes its rows of 3x4 into the packed array that becomes the multimesh's buffer.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <float.h>
#include <math.h>
#include <string.h>

static uint64_t rid_of(int method, int count, gd_var a, gd_var b) {
    gd_var ret;
    if (count)
        gd_call(gd.rendering_server, method, &ret, 2, a, b);
    else
        gd_call(gd.rendering_server, method, &ret, 0);
    const uint64_t rid = gd_type(&ret) == GDX_RID ? gd_to_rid(&ret) : 0;
    gd_free(&ret);
    return rid;
}

static uint64_t rid_of_resource(const gd_var* resource) {
    gdx_object object = gd_to_object(resource);
    gd_var ret;
    if (!object || !gd_call(object, GD_N_get_rid, &ret, 0)) return 0;
    const uint64_t rid = gd_to_rid(&ret);
    gd_free(&ret);
    return rid;
}

/* local = mesh_transform moved from the mesh's origin to the body's: the centre of mass. */
static void update_local(batch_node* self) {
    float moved[12], box[6], identity[12];
    const asset_node* asset = batch_asset(self);
    memcpy(moved, self->mesh_transform, sizeof moved);
    for (int i = 0; i < 3 && asset; ++i) moved[9 + i] -= (float)asset->info.center_of_mass[i];
    transform_to_rows(moved, self->local);
    transform_identity(identity);
    const float tiny = asset ? 1e-6f * (float)asset->info.length_d : 0.0f;
    self->local_is_identity = memcmp(moved, identity, 9 * sizeof(float)) == 0 && fabsf(moved[9]) <= tiny &&
                              fabsf(moved[10]) <= tiny && fabsf(moved[11]) <= tiny;
    self->mesh_radius = asset ? (float)asset->info.length_d : 1.0f;
    if (gd_type(&self->mesh) != GDX_NIL && gd_call_floats(gd_to_object(&self->mesh), GD_N_get_aabb, GDX_AABB, box)) {
        float radius = 0.0f;
        for (int corner = 0; corner < 8; ++corner) {
            float length = 0.0f;
            for (int i = 0; i < 3; ++i) {
                const float* row = self->local + 4 * i;
                float at = row[3];
                for (int j = 0; j < 3; ++j) at += row[j] * (box[j] + (corner >> j & 1 ? box[3 + j] : 0.0f));
                length += at * at;
            }
            radius = fmaxf(radius, sqrtf(length));
        }
        self->mesh_radius = radius;
    }
}

void batch_draw_changed(void* instance) {
    batch_node* self = instance;
    update_local(self);
    self->revision = 0; /* write everything anew */
    self->drawn = 0;
    if (!self->instance) return;
    gd_var ret;
    gd_call(self->base.object, GD_N_is_visible_in_tree, &ret, 0);
    self->visible = gd_to_bool(&ret) && gd_type(&self->mesh) != GDX_NIL;
    gd_free(&ret);
    gdx_object server = gd.rendering_server;
    gd_call(server, GD_N_multimesh_set_mesh, NULL, 2, gd_rid(self->multimesh), gd_rid(rid_of_resource(&self->mesh)));
    gd_call(server, GD_N_instance_set_visible, NULL, 2, gd_rid(self->instance), gd_bool(self->visible));
    gd_call(server, GD_N_instance_set_layer_mask, NULL, 2, gd_rid(self->instance), gd_int(self->layers));
    gd_call(server, GD_N_instance_geometry_set_cast_shadows_setting, NULL, 2, gd_rid(self->instance),
            gd_int(self->cast_shadow));
    gd_call(server, GD_N_instance_geometry_set_material_override, NULL, 2, gd_rid(self->instance),
            gd_rid(rid_of_resource(&self->material)));
}

void batch_draw_begin(batch_node* self) {
    gd_var world, scenario = gd_nil();
    if (!gd.rendering_server) gd.rendering_server = gd_singleton("RenderingServer");
    if (self->instance || !gd_call(self->base.object, GD_N_get_world_3d, &world, 0)) return;
    gdx_object object = gd_to_object(&world);
    if (object) gd_call(object, GD_N_get_scenario, &scenario, 0);
    self->multimesh = rid_of(GD_N_multimesh_create, 0, gd_nil(), gd_nil());
    self->allocated = 0;
    /* Bodies change their order when bodies wake or end, so interpolating by index between two steps would be wrong. */
    gd_call(gd.rendering_server, GD_N_multimesh_set_physics_interpolated, NULL, 2, gd_rid(self->multimesh), gd_bool(0));
    self->instance = rid_of(GD_N_instance_create2, 2, gd_rid(self->multimesh), scenario);
    gd_free(&world);
    batch_draw_changed(self);
}

void batch_draw_end(batch_node* self) {
    if (self->instance) gd_call(gd.rendering_server, GD_N_free_rid, NULL, 1, gd_rid(self->instance));
    if (self->multimesh) gd_call(gd.rendering_server, GD_N_free_rid, NULL, 1, gd_rid(self->multimesh));
    self->instance = self->multimesh = 0;
    self->allocated = 0;
    gd_free(&self->buffer);
}

/* The buffer is as long as the multimesh, which grows by doubling: a batch of a million with ten bodies uploads
 * sixteen. */
static int reserve(batch_node* self, uint32_t count) {
    if (count <= self->allocated) return 1;
    uint32_t size = self->allocated ? self->allocated : 16u;
    while (size < count) size *= 2u;
    if (size > (uint32_t)self->capacity && count <= (uint32_t)self->capacity) size = (uint32_t)self->capacity;
    if (gd_type(&self->buffer) == GDX_NIL) self->buffer = gd_empty(GDX_PACKED_FLOAT32_ARRAY);
    gd_array_resize(&self->buffer, (int64_t)size * 12);
    if (gd_array_count(&self->buffer) != (int64_t)size * 12) {
        gd_error("no memory for %u instances", (unsigned)size);
        return 0;
    }
    const int ok = gd_call(gd.rendering_server, GD_N_multimesh_allocate_data, NULL, 5, gd_rid(self->multimesh),
                           gd_int(size), gd_int(1), gd_bool(0), gd_bool(0));
    if (ok) self->allocated = size;
    self->drawn = 0;
    self->revision = 0;
    return ok;
}

static void set_aabb(batch_node* self, const lr_batch_view* view) {
    float box[6];
    if (self->custom_aabb[3] != 0.0f || self->custom_aabb[4] != 0.0f || self->custom_aabb[5] != 0.0f) {
        memcpy(box, self->custom_aabb, sizeof box);
    } else {
        float scale = 0.0f;
        for (uint32_t i = 0; i < view->count; ++i) scale = view->scale[i] > scale ? view->scale[i] : scale;
        const float margin = scale * self->mesh_radius;
        for (int axis = 0; axis < 3; ++axis) {
            const float* at = view->position[axis];
            float low = FLT_MAX, high = -FLT_MAX;
            for (uint32_t i = 0; i < view->count; ++i) {
                low = at[i] < low ? at[i] : low;
                high = at[i] > high ? at[i] : high;
            }
            box[axis] = low - margin;
            box[3 + axis] = high - low + 2.0f * margin;
        }
    }
    gd_call(gd.rendering_server, GD_N_multimesh_set_custom_aabb, NULL, 2, gd_rid(self->multimesh), gd_aabb(box));
}

/* Its bodies are gone: the instances must go with them. */
void batch_draw_nothing(batch_node* self) {
    if (self->multimesh)
        gd_call(gd.rendering_server, GD_N_multimesh_set_visible_instances, NULL, 2, gd_rid(self->multimesh), gd_int(0));
}

void batch_draw(batch_node* self) {
    if (!self->multimesh || !self->visible) return;
    lr_batch_view view;
    lr_batch_view_init(&view, sizeof view);
    if (self->batch.id && lr_batch_get_view(self->world->world, self->batch, &view) != LR_OK) return;
    const uint32_t before = self->drawn;
    if (!reserve(self, view.count)) return;
    if (view.count > 0) {
        /* The instances of sleeping bodies are still right, unless such a body woke, ended or moved. */
        const int same_rest = self->drawn > 0 && self->revision == view.revision;
        uint32_t write = view.count;
        if (same_rest) write = view.awake_count > self->moving ? view.awake_count : self->moving;
        if (write > 0) {
            float* rows = gd_data(&self->buffer);
            uint32_t written = 0;
            lr_batch_write_transforms(self->world->world, self->batch, LR_TRANSFORM_3X4_ROW_MAJOR, rows, 0, write,
                                      &written);
            if (!self->local_is_identity) transform_apply(rows, written, self->local);
            gd_call(gd.rendering_server, GD_N_multimesh_set_buffer, NULL, 2, gd_rid(self->multimesh),
                    gd_copy(&self->buffer));
            set_aabb(self, &view);
        }
    }
    if (view.count != before || before == 0) /* 0: also where the instances are not known */
        gd_call(gd.rendering_server, GD_N_multimesh_set_visible_instances, NULL, 2, gd_rid(self->multimesh),
                gd_int(view.count));
    self->drawn = view.count;
    self->moving = view.awake_count;
    self->revision = view.revision;
}
