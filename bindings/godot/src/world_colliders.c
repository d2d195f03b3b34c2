/*
 * Colliders for the shapes of the scene's physics bodies. A scan finds shapes when nodes come or go. Before each step the
 * shapes' transforms are compared; the collider of a moved shape moves during that step.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A cylinder becomes a hull with this number of corners at each end; its flats lie within 1 % of the radius. */
#define CYLINDER_SIDES 24

static float max_abs(const float* v) {
    return fmaxf(fabsf(v[0]), fmaxf(fabsf(v[1]), fabsf(v[2])));
}

static float* scaled(const float* points, int64_t count, const float* scale) {
    float* out = malloc((size_t)(3 * count) * sizeof(float));
    if (!out) return NULL;
    for (int64_t i = 0; i < 3 * count; ++i) out[i] = points[i] * scale[i % 3];
    return out;
}

/* An engine's height map, with its middle at the origin. Scales other than 1 along the axes of the grid become its
 * spacing. */
static int height_map(gdx_object shape, const float* scale, lr_collider_desc* desc, float** floats, float* extra) {
    const int64_t width = gd_call_int(shape, GD_N_get_map_width), depth = gd_call_int(shape, GD_N_get_map_depth);
    gd_var data;
    if (!gd_call(shape, GD_N_get_map_data, &data, 0)) return 0;
    const float* heights = gd_read(&data);
    const int64_t count = gd_array_count(&data);
    int ok = heights && width >= 2 && depth >= 2 && count == width * depth;
    if (ok) {
        *floats = malloc((size_t)count * sizeof(float));
        ok = *floats != NULL;
    }
    if (ok) {
        for (int64_t i = 0; i < count; ++i)
            (*floats)[i] = isfinite(heights[i]) ? heights[i] * scale[1] : 0.0f; /* NaN is a hole in Godot */
        desc->kind = LR_COLLIDER_HEIGHTFIELD;
        desc->counts[0] = (uint32_t)width;
        desc->counts[1] = (uint32_t)depth;
        desc->spacing[0] = fabsf(scale[0]);
        desc->spacing[1] = fabsf(scale[2]);
        desc->heights = *floats;
        extra[0] = -0.5f * (float)(width - 1) * desc->spacing[0];
        extra[2] = -0.5f * (float)(depth - 1) * desc->spacing[1];
    }
    gd_free(&data);
    return ok;
}

static int points_of(gdx_object shape, int method, const float* scale, float** floats, int64_t* count) {
    gd_var points;
    if (!gd_call(shape, method, &points, 0)) return 0;
    *count = gd_array_count(&points);
    const float* data = gd_read(&points);
    *floats = data ? scaled(data, *count, scale) : NULL;
    gd_free(&points);
    return *floats != NULL;
}

/* Fills a desc for a shape, except its pose. extra: the collider's pose in the shape's frame, initially the identity.
 * floats, indices: arrays of the desc, to be freed. Returns 0 if the shape has no collider. */
static int describe(gdx_object shape, const float* scale, lr_collider_desc* desc, float* extra, float** floats,
                    uint32_t** indices) {
    int64_t count = 0;
    if (gd_is_class(shape, "BoxShape3D")) {
        desc->kind = LR_COLLIDER_BOX;
        gd_call_floats(shape, GD_N_get_size, GDX_VECTOR3, desc->size);
        for (int i = 0; i < 3; ++i) desc->size[i] *= 0.5f * fabsf(scale[i]);
        return 1;
    }
    if (gd_is_class(shape, "SphereShape3D")) {
        desc->kind = LR_COLLIDER_SPHERE;
        desc->size[0] = (float)gd_call_float(shape, GD_N_get_radius) * max_abs(scale);
        return 1;
    }
    if (gd_is_class(shape, "CapsuleShape3D")) {
        const float radius = (float)gd_call_float(shape, GD_N_get_radius);
        const float height = (float)gd_call_float(shape, GD_N_get_height); /* from tip to tip */
        const float half = 0.5f * height - radius, around = fmaxf(fabsf(scale[0]), fabsf(scale[2]));
        desc->kind = half * fabsf(scale[1]) > 1e-4f ? LR_COLLIDER_CAPSULE : LR_COLLIDER_SPHERE;
        desc->size[0] = radius * around;
        desc->size[1] = half * fabsf(scale[1]);
        return 1;
    }
    if (gd_is_class(shape, "CylinderShape3D")) {
        const float radius = (float)gd_call_float(shape, GD_N_get_radius);
        const float half = 0.5f * (float)gd_call_float(shape, GD_N_get_height);
        *floats = malloc(2 * CYLINDER_SIDES * 3 * sizeof(float));
        if (!*floats) return 0;
        for (int i = 0; i < 2 * CYLINDER_SIDES; ++i) {
            const float angle = 6.2831853f * (float)(i / 2) / CYLINDER_SIDES;
            (*floats)[3 * i] = radius * cosf(angle) * scale[0];
            (*floats)[3 * i + 1] = (i % 2 ? half : -half) * scale[1];
            (*floats)[3 * i + 2] = radius * sinf(angle) * scale[2];
        }
        desc->kind = LR_COLLIDER_HULL;
        desc->vertices = *floats;
        desc->vertex_count = 2 * CYLINDER_SIDES;
        return 1;
    }
    if (gd_is_class(shape, "ConvexPolygonShape3D")) {
        if (!points_of(shape, GD_N_get_points, scale, floats, &count)) return 0;
        if (count > (int64_t)LR_MAX_HULL_VERTICES) {
            gd_warning("a convex shape has %lld points, but at most %u are possible: simplify it", (long long)count,
                       LR_MAX_HULL_VERTICES);
            return 0;
        }
        desc->kind = LR_COLLIDER_HULL;
        desc->vertices = *floats;
        desc->vertex_count = (uint32_t)count;
        return 1;
    }
    if (gd_is_class(shape, "ConcavePolygonShape3D")) {
        if (!points_of(shape, GD_N_get_faces, scale, floats, &count)) return 0;
        *indices = malloc((size_t)count * sizeof(uint32_t));
        if (!*indices) return 0;
        for (int64_t i = 0; i < count; ++i) (*indices)[i] = (uint32_t)i;
        desc->kind = LR_COLLIDER_MESH;
        desc->vertices = *floats;
        desc->vertex_count = (uint32_t)count;
        desc->indices = *indices;
        desc->triangle_count = (uint32_t)(count / 3);
        return 1;
    }
    if (gd_is_class(shape, "HeightMapShape3D")) return height_map(shape, scale, desc, floats, extra);
    if (gd_is_class(shape, "WorldBoundaryShape3D")) {
        float plane[4]; /* normal, distance from the origin along it */
        if (!gd_call_floats(shape, GD_N_get_plane, GDX_PLANE, plane)) return 0;
        const float length = sqrtf(plane[0] * plane[0] + plane[1] * plane[1] + plane[2] * plane[2]);
        if (!(length > 1e-9f)) return 0;
        const float n[3] = {plane[0] / length, plane[1] / length, plane[2] / length};
        desc->kind = LR_COLLIDER_PLANE;
        for (int i = 0; i < 3; ++i) extra[i] = n[i] * plane[3] / length * scale[i];
        /* The shortest rotation from y to the normal, by the half-way vector; about x if they are opposite. */
        const float w = sqrtf(fmaxf(0.5f * (1.0f + n[1]), 0.0f));
        extra[3] = w > 1e-4f ? 0.5f * n[2] / w : 1.0f;
        extra[4] = 0.0f;
        extra[5] = w > 1e-4f ? -0.5f * n[0] / w : 0.0f;
        extra[6] = w > 1e-4f ? w : 0.0f;
        return 1;
    }
    return 0;
}

/* The collider's pose in the scene for a shape at `global`; 0 if the transform is degenerate. */
static int pose_of(const float* global, const float* extra, float* position, float* orientation, float* scale) {
    float at[3], q[4];
    if (!transform_split(global, at, q, scale)) return 0;
    float frame[12], turned[12], unit[3];
    transform_join(at, q, 1.0f, frame);
    transform_join(extra, extra + 3, 1.0f, turned);
    transform_multiply(frame, turned, frame);
    return transform_split(frame, position, orientation, unit);
}

static void surface_of(gdx_object body, lr_collider_desc* desc) {
    gd_var ret;
    if (!gd_is_class(body, "StaticBody3D") && !gd_is_class(body, "RigidBody3D")) return;
    if (!gd_call(body, GD_N_get_physics_material_override, &ret, 0)) return;
    gdx_object material = gd_to_object(&ret);
    if (material) {
        desc->friction = fminf(fmaxf((float)gd_call_float(material, GD_N_get_friction), 0.0f), 10.0f);
        desc->restitution = fminf(fmaxf((float)gd_call_float(material, GD_N_get_bounce), 0.0f), 1.0f);
    }
    gd_free(&ret);
}

static void make_collider(world_node* self, shape_link* link, gdx_object body, gdx_object shape) {
    lr_collider_desc desc;
    float scale[3], *floats = NULL;
    uint32_t* indices = NULL;
    static const float identity[7] = {0, 0, 0, 0, 0, 0, 1};
    memcpy(link->extra, identity, sizeof identity);
    lr_collider_desc_init(&desc, sizeof desc);
    float position[3], orientation[4];
    if (pose_of(link->pose, link->extra, position, orientation, scale) &&
        describe(shape, scale, &desc, link->extra, &floats, &indices)) {
        pose_of(link->pose, link->extra, desc.position, desc.orientation, scale);
        desc.layers = link->layers;
        surface_of(body, &desc);
        const lr_status status = lr_collider_create(self->world, &desc, 1, &link->collider);
        if (status != LR_OK) {
            link->collider = (lr_collider){0};
            link->unsupported = 1;
            gd_var path;
            gd_call(body, GD_N_get_path, &path, 0);
            char* text = gd_to_utf8(&path);
            gd_warning("%s: shape %lld has no collider: %s", text ? text : "", (long long)link->index,
                       lr_status_string(status));
            free(text);
            gd_free(&path);
        }
    } else {
        link->unsupported = 1;
    }
    free(floats);
    free(indices);
}

static void drop_collider(world_node* self, shape_link* link) {
    if (link->collider.id && self->world) lr_collider_destroy(self->world, &link->collider, 1);
    link->collider = (lr_collider){0};
}

void world_forget_colliders(world_node* self, int destroy) {
    for (uint32_t i = 0; destroy && i < self->colliders.count; ++i) drop_collider(self, &self->colliders.links[i]);
    self->colliders.count = 0;
}

/* ------------------------------------------------------------------------------------------------------------------ */

static shape_link* find_link(collider_set* set, uint64_t body, uint64_t shape, int64_t owner, int64_t index) {
    /* A scan finds shapes in the order of the scan before, except for new and removed shapes. */
    for (uint32_t i = 0; i < set->count; ++i) {
        const uint32_t at = (set->cursor + i) % set->count;
        shape_link* link = &set->links[at];
        if (link->body == body && link->owner == owner && link->index == index && link->shape == shape) {
            set->cursor = at + 1u;
            return link;
        }
    }
    return NULL;
}

static shape_link* add_link(collider_set* set) {
    if (set->count == set->capacity) {
        const uint32_t capacity = set->capacity ? 2u * set->capacity : 32u;
        shape_link* grown = realloc(set->links, capacity * sizeof *grown);
        if (!grown) return NULL;
        set->links = grown;
        set->capacity = capacity;
    }
    shape_link* link = &set->links[set->count++];
    memset(link, 0, sizeof *link);
    return link;
}

static void scan_body(world_node* self, gdx_object body) {
    collider_set* set = &self->colliders;
    const uint64_t id = gd.object_get_instance_id(body);
    gd_var owners, ret;
    if (!gd_call(body, GD_N_get_shape_owners, &owners, 0)) return;
    const int64_t owner_count = gd_array_count(&owners);
    for (int64_t o = 0; o < owner_count; ++o) {
        const int64_t owner = ((const int32_t*)gd_read(&owners))[o];
        gd_call(body, GD_N_shape_owner_get_shape_count, &ret, 1, gd_int(owner));
        const int64_t shape_count = gd_to_int(&ret);
        gd_free(&ret);
        for (int64_t s = 0; s < shape_count; ++s) {
            gd_call(body, GD_N_shape_owner_get_shape, &ret, 2, gd_int(owner), gd_int(s));
            gdx_object shape = gd_to_object(&ret);
            const uint64_t shape_id = shape ? gd.object_get_instance_id(shape) : 0;
            gd_free(&ret);
            if (!shape_id) continue;
            shape_link* link = find_link(set, id, shape_id, owner, s);
            if (!link) {
                link = add_link(set);
                if (!link) break;
                link->body = id;
                link->shape = shape_id;
                link->owner = owner;
                link->index = s;
            }
            link->seen = set->scan;
        }
    }
    gd_free(&owners);
}

void world_scan_colliders(world_node* self) {
    collider_set* set = &self->colliders;
    ++set->scan;
    set->cursor = 0;
    if (self->sync_colliders) {
        gdx_object space = gd_call_object(self->base.object, GD_N_get_world_3d);
        gd_var nodes = gd_nodes_below_viewport(self->base.object, "PhysicsBody3D");
        const int64_t count = gd_type(&nodes) == GDX_ARRAY ? gd_array_count(&nodes) : 0;
        for (int64_t i = 0; i < count; ++i) {
            gd_var node;
            uint8_t valid, out;
            gd.variant_get_indexed(&nodes, i, &node, &valid, &out);
            gdx_object body = gd_to_object(&node);
            if (body && gd_call_object(body, GD_N_get_world_3d) == space) scan_body(self, body);
            gd_free(&node);
        }
        gd_free(&nodes);
    }
    uint32_t kept = 0;
    for (uint32_t i = 0; i < set->count; ++i) {
        if (set->links[i].seen == set->scan)
            set->links[kept++] = set->links[i];
        else
            drop_collider(self, &set->links[i]);
    }
    set->count = kept;
}

/* Updates a shape of a body at `global`. */
static void sync_link(world_node* self, shape_link* link, gdx_object body, const float* global, uint32_t layers) {
    gd_var ret;
    gd_call(body, GD_N_is_shape_owner_disabled, &ret, 1, gd_int(link->owner));
    const int disabled = gd_to_bool(&ret) || layers == 0;
    gd_free(&ret);
    if (disabled) {
        drop_collider(self, link);
        return;
    }
    if (link->unsupported) return;
    float offset[12], pose[12], at[3], turned[4], size[3];
    gd_call(body, GD_N_shape_owner_get_transform, &ret, 1, gd_int(link->owner));
    gd_to_floats(&ret, GDX_TRANSFORM3D, offset);
    gd_free(&ret);
    transform_multiply(global, offset, pose);
    if (!transform_split(pose, at, turned,
                         size)) { /* of no size, perhaps for a while: it has no collider, and gets one when it has */
        drop_collider(self, link);
        return;
    }
    if (link->collider.id && link->layers != layers) drop_collider(self, link);
    if (link->collider.id && memcmp(pose, link->pose, sizeof pose) == 0) return;
    if (link->collider.id) {
        float before[3], after[3];
        lr_collider_motion motion;
        lr_collider_motion_init(&motion, sizeof motion);
        motion.collider = link->collider;
        pose_of(link->pose, link->extra, motion.position, motion.orientation, before);
        if (!pose_of(pose, link->extra, motion.position, motion.orientation, after)) return;
        const float change =
            fmaxf(fabsf(after[0] - before[0]), fmaxf(fabsf(after[1] - before[1]), fabsf(after[2] - before[2])));
        if (change <= 1e-4f * max_abs(before)) {
            memcpy(link->pose, pose, sizeof pose);
            const lr_status status = lr_collider_move(self->world, &motion, 1);
            if (status != LR_OK) gd_error("a collider's motion: %s", lr_status_string(status));
            return;
        }
        drop_collider(self, link); /* its size has changed */
    }
    memcpy(link->pose, pose, sizeof pose);
    link->layers = layers;
    gd_call(body, GD_N_shape_owner_get_shape, &ret, 2, gd_int(link->owner), gd_int(link->index));
    gdx_object shape = gd_to_object(&ret);
    if (shape && gd.object_get_instance_id(shape) == link->shape)
        make_collider(self, link, body, shape);
    else
        self->tree_changed = 1;
    gd_free(&ret);
}

void world_sync_colliders(world_node* self) {
    collider_set* set = &self->colliders;
    uint64_t id = 0;
    gdx_object body = NULL;
    float global[12];
    uint32_t layers = 0;
    for (uint32_t i = 0; i < set->count; ++i) {
        shape_link* link = &set->links[i];
        if (link->body != id) {
            id = link->body;
            body = gd.object_get_instance_from_id(id);
            if (body && !gd_call_floats(body, GD_N_get_global_transform, GDX_TRANSFORM3D, global)) body = NULL;
            if (body) {
                const uint64_t layer = (uint64_t)gd_call_int(body, GD_N_get_collision_layer);
                layers = (uint32_t)(layer & (uint64_t)self->collision_mask);
            }
        }
        if (body)
            sync_link(self, link, body, global, layers);
        else
            drop_collider(self, link);
    }
}
