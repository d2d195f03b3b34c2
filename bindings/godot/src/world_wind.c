/*
 * The world's wind: uniform, gusts, turbulence, and that of Area3D nodes.
 *
 * Areas follow Godot's soft bodies: the wind goes along -z of the node at wind_source_path, with strength
 * wind_force_magnitude times d to the power of -wind_attenuation_factor; d is the distance from that node along the wind.
 * Here the strength is a speed in m/s, and d is at least 1 m, so that the wind is finite at its source.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { AREA_BOX = 1, AREA_SPHERE = 2, AREA_CAPSULE = 3, AREA_CYLINDER = 4 };

static void check(lr_status status) {
    if (status != LR_OK) gd_error("wind: %s", lr_status_string(status));
}

static void remove_source(world_node* self, lr_wind_source* source) {
    if (source->id) check(lr_world_remove_wind(self->world, *source));
    *source = (lr_wind_source){0};
}

static void apply_gusts(world_node* self) {
    if (self->gust_speed <= 0.0) {
        remove_source(self, &self->gusts);
        return;
    }
    const float* w = self->wind;
    lr_gusts_desc desc;
    lr_gusts_desc_init(&desc, sizeof desc);
    if (w[0] * w[0] + w[1] * w[1] + w[2] * w[2] > 1e-12f) memcpy(desc.direction, w, sizeof desc.direction);
    desc.rms = (float)self->gust_speed;
    desc.angle_rms = 0.3f;
    desc.integral_time = (float)self->gust_period;
    check(self->gusts.id ? lr_world_update_gusts(self->world, self->gusts, &desc)
                         : lr_world_add_gusts(self->world, &desc, &self->gusts));
}

static void apply_turbulence(world_node* self) {
    if (self->turbulence_speed <= 0.0) {
        remove_source(self, &self->turbulence);
        return;
    }
    lr_turbulence_desc desc;
    lr_turbulence_desc_init(&desc, sizeof desc);
    desc.rms = (float)self->turbulence_speed;
    desc.integral_length = (float)self->turbulence_size;
    check(self->turbulence.id ? lr_world_update_turbulence(self->world, self->turbulence, &desc)
                              : lr_world_add_turbulence(self->world, &desc, &self->turbulence));
}

void world_apply_wind(world_node* self) {
    if (!self->wind_changed) return;
    self->wind_changed = 0;
    check(lr_world_set_uniform_wind(self->world, self->wind[0], self->wind[1], self->wind[2]));
    apply_gusts(self);
    apply_turbulence(self);
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Areas during the step: called from any thread, read-only.                                                          */

static int inside(const area_shape* shape, const float* at) {
    float p[3];
    for (int i = 0; i < 3; ++i) {
        const float* row = shape->to_local + 4 * i;
        p[i] = row[0] * at[0] + row[1] * at[1] + row[2] * at[2] + row[3];
    }
    const float* size = shape->size;
    switch (shape->kind) {
    case AREA_BOX:
        return fabsf(p[0]) <= size[0] && fabsf(p[1]) <= size[1] && fabsf(p[2]) <= size[2];
    case AREA_SPHERE:
        return p[0] * p[0] + p[1] * p[1] + p[2] * p[2] <= size[0] * size[0];
    case AREA_CYLINDER:
        return fabsf(p[1]) <= size[1] && p[0] * p[0] + p[2] * p[2] <= size[0] * size[0];
    default: {
        const float y = fmaxf(fabsf(p[1]) - size[1], 0.0f);
        return p[0] * p[0] + y * y + p[2] * p[2] <= size[0] * size[0];
    }
    }
}

/* Common exponents avoid powf, whose last bits differ between C libraries. */
static float attenuation(float distance, float exponent) {
    if (exponent == 0.0f) return 1.0f;
    const float d = distance > 1.0f ? distance : 1.0f;
    if (exponent == 1.0f) return 1.0f / d;
    if (exponent == 2.0f) return 1.0f / (d * d);
    if (exponent == 0.5f) return 1.0f / sqrtf(d);
    return powf(d, -exponent);
}

static void blow(void* user, const lr_wind_query* query) {
    const area_set* set = user;
    for (uint32_t body = 0; body < query->count; ++body) {
        const float at[3] = {query->position[0][body], query->position[1][body], query->position[2][body]};
        for (uint32_t a = 0; a < set->count; ++a) {
            const area_wind* area = &set->areas[a];
            int is_in = 0;
            for (uint32_t s = 0; s < area->count && !is_in; ++s) is_in = inside(&set->shapes[area->first + s], at);
            if (!is_in) continue;
            float distance = 0.0f;
            for (int i = 0; i < 3; ++i) distance += (at[i] - area->source[i]) * area->direction[i];
            const float factor = attenuation(distance, area->attenuation);
            for (int i = 0; i < 3; ++i) query->velocity[i][body] += factor * area->velocity[i];
        }
    }
}

/* ------------------------------------------------------------------------------------------------------------------ */
/* Between steps                                                                                                      */

void world_forget_areas(world_node* self) {
    free(self->areas.areas);
    free(self->areas.shapes);
    memset(&self->areas, 0, sizeof self->areas);
}

void world_scan_areas(world_node* self) {
    area_set* set = &self->areas;
    set->count = set->shape_count = 0;
    if (!self->wind_from_areas) return;
    gdx_object space = gd_call_object(self->base.object, GD_N_get_world_3d);
    gd_var nodes = gd_nodes_below_viewport(self->base.object, "Area3D");
    const int64_t count = gd_type(&nodes) == GDX_ARRAY ? gd_array_count(&nodes) : 0;
    for (int64_t i = 0; i < count; ++i) {
        gd_var node;
        uint8_t valid, out;
        gd.variant_get_indexed(&nodes, i, &node, &valid, &out);
        gdx_object object = gd_to_object(&node);
        gd_free(&node);
        if (!object || gd_call_object(object, GD_N_get_world_3d) != space) continue;
        if (set->count == set->capacity) {
            const uint32_t capacity = set->capacity ? 2u * set->capacity : 8u;
            area_wind* grown = realloc(set->areas, capacity * sizeof *grown);
            if (!grown) break;
            set->areas = grown;
            set->capacity = capacity;
        }
        memset(&set->areas[set->count], 0, sizeof *set->areas);
        set->areas[set->count++].area = gd.object_get_instance_id(object);
    }
    gd_free(&nodes);
}

static int read_shape(gdx_object shape, const float* global, area_shape* out) {
    if (!transform_invert_to_rows(global, out->to_local)) return 0;
    if (gd_is_class(shape, "BoxShape3D")) {
        out->kind = AREA_BOX;
        if (!gd_call_floats(shape, GD_N_get_size, GDX_VECTOR3, out->size)) return 0;
        for (int i = 0; i < 3; ++i) out->size[i] *= 0.5f;
    } else if (gd_is_class(shape, "SphereShape3D")) {
        out->kind = AREA_SPHERE;
        out->size[0] = (float)gd_call_float(shape, GD_N_get_radius);
    } else if (gd_is_class(shape, "CapsuleShape3D") || gd_is_class(shape, "CylinderShape3D")) {
        out->kind = gd_is_class(shape, "CapsuleShape3D") ? AREA_CAPSULE : AREA_CYLINDER;
        out->size[0] = (float)gd_call_float(shape, GD_N_get_radius);
        out->size[1] = 0.5f * (float)gd_call_float(shape, GD_N_get_height);
        if (out->kind == AREA_CAPSULE) out->size[1] = fmaxf(out->size[1] - out->size[0], 0.0f);
    } else {
        return 0;
    }
    return 1;
}

/* Reads the shapes of an area with wind, behind those of the areas before it. */
static void read_shapes(area_set* set, area_wind* wind, gdx_object area) {
    float global[12];
    wind->first = set->shape_count;
    wind->count = 0;
    gd_var owners;
    if (!gd_call_floats(area, GD_N_get_global_transform, GDX_TRANSFORM3D, global)) return;
    if (!gd_call(area, GD_N_get_shape_owners, &owners, 0)) return;
    const int64_t owner_count = gd_array_count(&owners);
    for (int64_t o = 0; o < owner_count; ++o) {
        const int64_t owner = ((const int32_t*)gd_read(&owners))[o];
        gd_var ret;
        gd_call(area, GD_N_is_shape_owner_disabled, &ret, 1, gd_int(owner));
        const int disabled = gd_to_bool(&ret);
        gd_free(&ret);
        if (disabled) continue;
        gd_call(area, GD_N_shape_owner_get_shape_count, &ret, 1, gd_int(owner));
        const int64_t shape_count = gd_to_int(&ret);
        gd_free(&ret);
        float offset[12];
        gd_call(area, GD_N_shape_owner_get_transform, &ret, 1, gd_int(owner));
        gd_to_floats(&ret, GDX_TRANSFORM3D, offset);
        gd_free(&ret);
        transform_multiply(global, offset, offset);
        for (int64_t s = 0; s < shape_count; ++s) {
            if (set->shape_count == set->shape_capacity) {
                const uint32_t capacity = set->shape_capacity ? 2u * set->shape_capacity : 16u;
                area_shape* grown = realloc(set->shapes, capacity * sizeof *grown);
                if (!grown) break;
                set->shapes = grown;
                set->shape_capacity = capacity;
            }
            gd_call(area, GD_N_shape_owner_get_shape, &ret, 2, gd_int(owner), gd_int(s));
            gdx_object shape = gd_to_object(&ret);
            if (shape && read_shape(shape, offset, &set->shapes[set->shape_count])) {
                ++set->shape_count;
                ++wind->count;
            }
            gd_free(&ret);
        }
    }
    gd_free(&owners);
}

void world_sync_areas(world_node* self) {
    area_set* set = &self->areas;
    int active = 0;
    set->shape_count = 0;
    for (uint32_t a = 0; a < set->count; ++a) {
        area_wind* wind = &set->areas[a];
        wind->count = 0;
        gdx_object area = gd.object_get_instance_from_id(wind->area);
        if (!area) continue;
        const float magnitude = (float)gd_call_float(area, GD_N_get_wind_force_magnitude);
        if (!(magnitude > 0.0f)) continue;
        gd_var path, ret;
        gd_call(area, GD_N_get_wind_source_path, &path, 0);
        gd_call(area, GD_N_get_node_or_null, &ret, 1, path);
        gdx_object source = gd_to_object(&ret);
        gd_free(&ret);
        float at[12];
        if (!source || !gd_is_class(source, "Node3D") ||
            !gd_call_floats(source, GD_N_get_global_transform, GDX_TRANSFORM3D, at))
            continue;
        const float z[3] = {at[2], at[5], at[8]};
        const float length = sqrtf(z[0] * z[0] + z[1] * z[1] + z[2] * z[2]);
        if (!(length > 1e-9f)) continue;
        for (int i = 0; i < 3; ++i) {
            wind->direction[i] = -z[i] / length;
            wind->velocity[i] = magnitude * wind->direction[i];
            wind->source[i] = at[9 + i];
        }
        wind->attenuation = (float)gd_call_float(area, GD_N_get_wind_attenuation_factor);
        read_shapes(set, wind, area);
        active |= wind->count > 0;
    }
    if (active != set->active) {
        set->active = active;
        lr_world_set_wind_callback(self->world, active ? blow : NULL, set);
    }
}
