/*
 * The scene and the servers of the host: the engine's methods that the extension calls by name.
 *
 * SPDX-License-Identifier: MIT
 */
#include "host.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

host_object *host_tree, *host_root, *host_body;
static host_object *engine, *rendering, *loaders, *space, *shape;
static host_object* loader; /* the registered resource loader */

void scene_call(host_variant* self, const char* method, const void* const* args, int64_t count, host_variant* ret,
                gdx_call_error* error);
host_object* scene_singleton(const char* name);

void host_start(void) {
    engine = host_new("Engine", 0);
    rendering = host_new("RenderingServer", 0);
    loaders = host_new("ResourceLoader", 0);
    host_tree = host_new("SceneTree", 0);
    host_root = host_new("Viewport", 0);
    space = host_new("World3D", 0);
    host_body = host_new("StaticBody3D", 0);
    shape = host_new("WorldBoundaryShape3D", 0);
    host_body->parent = host_root;
}

void host_stop(void) {
    host_object* all[] = {engine, rendering, loaders, host_tree, host_root, space, host_body, shape};
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) host_free(all[i]);
}

host_object* scene_singleton(const char* name) {
    if (!strcmp(name, "Engine")) return engine;
    if (!strcmp(name, "RenderingServer")) return rendering;
    if (!strcmp(name, "ResourceLoader")) return loaders;
    return NULL;
}

static int is_class(const host_object* o, const char* name) {
    if (o->extension && !strcmp(o->extension->name, name)) return 1;
    if (!strcmp(o->class_name, name)) return 1;
    if (!strcmp(name, "RefCounted")) return o->counted;
    if (!strcmp(name, "Mesh")) return !strcmp(o->class_name, "MeshResource");
    if (!strcmp(name, "PhysicsBody3D") || !strcmp(name, "CollisionObject3D")) return o == host_body;
    return 0;
}

static host_variant rid(uint64_t id) {
    host_variant v = host_value_of(GDX_RID);
    v.u.rid = id;
    return v;
}

static host_variant transform(const float* floats) {
    host_variant v = host_value_of(GDX_TRANSFORM3D);
    v.u.many = malloc(48);
    memcpy(v.u.many, floats, 48);
    return v;
}

static host_variant list_of(host_object* object) {
    host_variant v = host_value_of(GDX_ARRAY);
    v.u.list = calloc(1, sizeof *v.u.list);
    v.u.list->refs = 1;
    if (object) v.u.list->items[v.u.list->count++] = host_obj(object);
    return v;
}

static const char* text_of(const host_variant* v) {
    return v->type == GDX_STRING ? v->u.string->text : v->type == GDX_STRING_NAME ? v->u.name->text : "";
}

static int render(const char* method, const host_variant* const* args, int64_t count, host_variant* ret) {
    static uint64_t next = 100;
    static int64_t sizes[256]; /* instances of each multimesh */
    int64_t* size = count > 0 && args[0]->type == GDX_RID ? &sizes[args[0]->u.rid % 256] : sizes;
    if (!strcmp(method, "multimesh_create") || !strcmp(method, "instance_create2")) {
        host.multimeshes += !strcmp(method, "multimesh_create");
        ++host.rids;
        *ret = rid(next++);
    } else if (!strcmp(method, "free_rid")) {
        assert(args[0]->type == GDX_RID && args[0]->u.rid >= 100);
        --host.rids;
    } else if (!strcmp(method, "multimesh_allocate_data")) {
        assert(count == 5 && args[2]->u.integer == 1);
        *size = args[1]->u.integer;
    } else if (!strcmp(method, "multimesh_set_buffer")) {
        /* The engine refuses a buffer of any other length. */
        assert(args[1]->type == GDX_PACKED_FLOAT32_ARRAY && args[1]->u.array->count == 12 * *size);
        ++host.buffers;
    } else if (!strcmp(method, "multimesh_set_visible_instances")) {
        assert(args[1]->u.integer <= *size);
        host.visible += args[1]->u.integer > 0;
        host.shown = args[1]->u.integer;
    } else if (!strcmp(method, "multimesh_set_custom_aabb")) {
        for (int i = 3; i < 6; ++i) assert(args[1]->u.many[i] >= 0.0f && args[1]->u.many[i] < 1e4f);
    } else {
        static const char* const others[] = {"multimesh_set_mesh",
                                             "multimesh_set_physics_interpolated",
                                             "instance_set_visible",
                                             "instance_set_layer_mask",
                                             "instance_geometry_set_cast_shadows_setting",
                                             "instance_geometry_set_material_override"};
        for (size_t i = 0; i < sizeof others / sizeof *others; ++i)
            if (!strcmp(method, others[i])) return 1;
        return 0;
    }
    return 1;
}

static int physics(const char* method, host_variant* ret) {
    static const float identity[12] = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
    if (!strcmp(method, "get_shape_owners")) {
        *ret = host_value_of(GDX_PACKED_INT32_ARRAY);
        ret->u.array = calloc(1, sizeof(host_array));
        ret->u.array->refs = 1;
        ret->u.array->count = 1;
        ret->u.array->width = 4;
        ret->u.array->data = calloc(1, 4);
    } else if (!strcmp(method, "shape_owner_get_shape_count") || !strcmp(method, "get_collision_layer")) {
        *ret = host_int(1);
    } else if (!strcmp(method, "shape_owner_get_shape")) {
        *ret = host_obj(shape);
    } else if (!strcmp(method, "shape_owner_get_transform")) {
        *ret = transform(identity);
    } else if (!strcmp(method, "is_shape_owner_disabled")) {
        *ret = host_bool(0);
    } else if (!strcmp(method, "get_plane")) {
        *ret = host_value_of(GDX_PLANE);
        ret->u.floats[1] = 1.0f;
    } else if (strcmp(method, "get_physics_material_override") != 0) {
        return 0;
    }
    return 1;
}

/* The editor's plugins, and a gizmo, whose `parent` is its node. */
static int editor(host_object* o, const char* method, const host_variant* const* args, int64_t count,
                  host_variant* ret) {
    if (!strcmp(method, "add_node_3d_gizmo_plugin") || !strcmp(method, "remove_node_3d_gizmo_plugin")) {
        assert(!strcmp(args[0]->u.object->class_name, "EditorNode3DGizmoPlugin"));
        host.gizmo_plugins += *method == 'a' ? 1 : -1;
    } else if (!strcmp(method, "create_material")) {
        assert(count == 2 && args[0]->type == GDX_STRING && args[1]->type == GDX_COLOR);
        ++host.materials;
    } else if (!strcmp(method, "get_material")) {
        static const char* const names[] = {"emitter", "bounds", "wind"};
        int known = 0;
        for (int i = 0; i < 3; ++i) known += !strcmp(names[i], text_of(args[0]));
        assert(known && count == 2 && !strcmp(args[1]->u.object->class_name, "EditorNode3DGizmo"));
    } else if (!strcmp(method, "get_node_3d")) {
        *ret = host_obj(o->parent);
    } else if (!strcmp(method, "clear")) {
        host.lines = host.clicks = 0;
    } else if (!strcmp(method, "add_lines") || !strcmp(method, "add_collision_segments")) {
        assert(args[0]->type == GDX_PACKED_VECTOR3_ARRAY && args[0]->u.array->count % 2 == 0);
        const float* at = (const float*)(void*)args[0]->u.array->data;
        for (int64_t i = 0; i < 3 * args[0]->u.array->count; ++i) {
            assert(at[i] > -1e3f && at[i] < 1e3f);
            host.reach = at[i] > host.reach ? at[i] : host.reach;
        }
        *(!strcmp(method, "add_lines") ? &host.lines : &host.clicks) += (int)args[0]->u.array->count / 2;
    } else {
        return 0;
    }
    return 1;
}

static int node(host_object* o, const char* method, const host_variant* const* args, int64_t count, host_variant* ret) {
    if (!strcmp(method, "get_parent"))
        *ret = host_obj(o->parent);
    else if (!strcmp(method, "get_tree"))
        *ret = host_obj(host_tree);
    else if (!strcmp(method, "get_viewport"))
        *ret = host_obj(host_root);
    else if (!strcmp(method, "get_world_3d"))
        *ret = host_obj(space);
    else if (!strcmp(method, "get_scenario") || !strcmp(method, "get_rid"))
        *ret = rid(7);
    else if (!strcmp(method, "is_visible_in_tree"))
        *ret = host_bool(!host.hidden);
    else if (!strcmp(method, "get_global_transform"))
        *ret = transform(o->transform);
    else if (!strcmp(method, "get_physics_process_delta_time") || !strcmp(method, "get_process_delta_time"))
        *ret = host_float(1.0 / 60.0);
    else if (!strcmp(method, "find_children"))
        *ret = list_of(!strcmp(text_of(args[1]), "PhysicsBody3D") ? host_body : NULL);
    else if (!strcmp(method, "is_connected"))
        *ret = host_bool(host.connections & (strcmp(text_of(args[0]), "node_added") ? 2 : 1));
    else if (!strcmp(method, "connect"))
        host.connections |= strcmp(text_of(args[0]), "node_added") ? 2 : 1;
    else if (!strcmp(method, "disconnect"))
        host.connections &= strcmp(text_of(args[0]), "node_added") ? 1 : 2;
    else if (!strcmp(method, "get_aabb")) {
        *ret = host_value_of(GDX_AABB);
        ret->u.many = calloc(6, sizeof(float));
        ret->u.many[3] = ret->u.many[4] = 0.1f;
    } else if (!strcmp(method, "emit_signal")) {
        const char* name = text_of(args[0]);
        assert(args[1]->type == GDX_PACKED_INT64_ARRAY && args[2]->type == GDX_PACKED_VECTOR3_ARRAY);
        assert(args[1]->u.array->count == args[2]->u.array->count && args[1]->u.array->count > 0);
        host.signals_touched += !strcmp(name, "touched") && count == 4;
        host.signals_landed += !strcmp(name, "landed") && count == 3;
        if (!strcmp(name, "landed")) host.bodies_landed += (int)args[1]->u.array->count;
    } else if (!strcmp(method, "set_process_internal")) {
        host.internal_process = args[0]->u.flag;
    } else if (!strcmp(method, "update_gizmos")) {
        ++host.redraws;
    } else if (strcmp(method, "set_notify_transform") != 0 && strcmp(method, "set_physics_process_internal") != 0 &&
               strcmp(method, "update_configuration_warnings") != 0) {
        return 0;
    }
    return 1;
}

void scene_call(host_variant* self, const char* method, const void* const* args, int64_t count, host_variant* ret,
                gdx_call_error* error) {
    const host_variant* values[8];
    host_object* o = self->u.object;
    for (int64_t i = 0; i < count && i < 8; ++i) values[i] = args[i];
    if (!strcmp(method, "is_class")) {
        *ret = host_bool(is_class(o, text_of(values[0])));
    } else if (o == engine && !strcmp(method, "is_editor_hint")) {
        *ret = host_bool(host.editor);
    } else if (o == loaders && !strcmp(method, "add_resource_format_loader")) {
        loader = values[0]->u.object;
    } else if (o == loaders && !strcmp(method, "remove_resource_format_loader")) {
        assert(values[0]->u.object == loader);
        loader = NULL;
    } else if (!strcmp(o->class_name, "FileAccess") && !strcmp(method, "store_buffer")) {
        assert(count == 1 && values[0]->type == GDX_PACKED_BYTE_ARRAY && values[0]->u.array->count > 0);
        const int fits = values[0]->u.array->count <= host.room;
        if (fits) host.stored += values[0]->u.array->count, host.room -= values[0]->u.array->count;
        *ret = host_bool(fits);
    } else if (!strcmp(o->class_name, "FileAccess") && !strcmp(method, "flush")) {
        ++host.flushes;
    } else if (!(o == rendering ? render(method, values, count, ret)
                                : physics(method, ret) || node(o, method, values, count, ret) ||
                                      editor(o, method, values, count, ret))) {
        fprintf(stderr, "the host has no %s\n", method);
        error->error = GDX_CALL_INVALID_METHOD;
    }
}
