/*
 * Loads the extension like an engine, runs it for a thousand frames and unloads it: host EXTENSION LEAF.lrb
 *
 * SPDX-License-Identifier: MIT
 */
#include "host.h"

#include <dlfcn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int passed, failed;

#define CHECK(condition)                                                                                               \
    do {                                                                                                               \
        if (condition)                                                                                                 \
            ++passed;                                                                                                  \
        else                                                                                                           \
            ++failed, printf("FAILED: line %d: %s (last error: %s)\n", __LINE__, #condition, host.last_error);         \
    } while (0)

static int64_t call_int(host_object* o, const char* method) {
    host_variant v = host_call(o, method, NULL, 0);
    const int64_t value = v.type == GDX_INT ? v.u.integer : -1;
    host_variant_destroy(&v);
    return value;
}

static void set(host_object* o, const char* setter, host_variant value) {
    gdx_call_error error = {99, 0, 0};
    host_variant ret = host_call(o, setter, &error, 1, value);
    CHECK(error.error == GDX_CALL_OK);
    host_variant_destroy(&ret);
}

enum {
    ENTER_TREE = 10,
    EXIT_TREE = 11,
    PROCESS = 25,
    PHYSICS = 26,
    ENTER_WORLD = 41,
    EXIT_WORLD = 42,
    VISIBILITY = 43,
    MOVED = 2000
};

static host_object* load(const char* path) {
    host_object* loader = host_construct("LangevinAssetLoader");
    host_variant hold = host_obj(loader), result = host_nil();
    host_string* text = host_string_new(path);
    const uint8_t threads = 0;
    const int64_t mode = 1;
    const void* args[4] = {&text, &text, &threads, &mode};
    host_virtual(loader, "_load", args, &result);
    host_object* asset = result.type == GDX_OBJECT ? result.u.object : NULL;
    if (asset) ++asset->refs;
    host_variant_destroy(&result);
    host_string* type = NULL;
    host_virtual(loader, "_get_resource_type", args, &type);
    CHECK(type && !strcmp(type->text, strstr(path, ".lrb") ? "LangevinAsset" : ""));
    host_string_free(&type);
    host_string_free(&text);
    host_variant_destroy(&hold);
    return asset;
}

static void release(host_object* counted) {
    host_variant v = host_obj(counted);
    --counted->refs;
    host_variant_destroy(&v);
}

/* Wrong numbers and types of arguments return the expected errors, and change nothing. */
static void test_arguments(host_object* world) {
    gdx_call_error error = {0, 0, 0};
    host_variant ret = host_call(world, "set_seed", &error, 0);
    CHECK(error.error == GDX_CALL_TOO_FEW_ARGUMENTS && error.expected == 1);
    host_variant_destroy(&ret);
    ret = host_call(world, "get_seed", &error, 1, host_int(1));
    CHECK(error.error == GDX_CALL_TOO_MANY_ARGUMENTS && error.expected == 0);
    host_variant_destroy(&ret);
    ret = host_call(world, "set_seed", &error, 1, host_text("nine"));
    CHECK(error.error == GDX_CALL_INVALID_ARGUMENT && error.argument == 0 && error.expected == GDX_INT);
    host_variant_destroy(&ret);
    set(world, "set_seed", host_float(5.0));
    CHECK(call_int(world, "get_seed") == 5);
    const int before = host.errors;
    set(world, "set_substeps", host_int(0));
    CHECK(host.errors == before + 1 && call_int(world, "get_substeps") == 2);
    /* The calls of compiled code: pointers to values. */
    host_method* setter = host_find_method(world, "set_wind");
    host_method* getter = host_find_method(world, "get_wind");
    const float wind[3] = {1.0f, 0.0f, 0.5f};
    float got[3] = {0};
    const void* args[1] = {wind};
    setter->info.ptrcall(setter->info.userdata, world->instance, args, NULL);
    getter->info.ptrcall(getter->info.userdata, world->instance, NULL, got);
    CHECK(!memcmp(wind, got, sizeof got));
}

static host_object* new_batch(host_object* world, host_object* asset, host_object* mesh, int count) {
    host_object* batch = host_construct("LangevinBatch");
    batch->parent = world;
    batch->transform[10] = 3.0f;
    set(batch, "set_asset", host_obj(asset));
    set(batch, "set_mesh", host_obj(mesh));
    set(batch, "set_capacity", host_int(600));
    set(batch, "set_initial_count", host_int(count));
    set(batch, "set_emission_extents", host_vector(1, 1, 1));
    host_notify(batch, ENTER_TREE);
    host_notify(batch, ENTER_WORLD);
    return batch;
}

static void leave(host_object* batch) {
    host_notify(batch, EXIT_WORLD);
    host_notify(batch, EXIT_TREE);
}

/* Warnings in the editor on an incomplete node. */
static void test_warnings(host_object* asset) {
    host_object* batch = host_construct("LangevinBatch");
    host_variant list = host_nil();
    host_virtual(batch, "_get_configuration_warnings", NULL, &list.u.array);
    CHECK(list.u.array && list.u.array->count == 3); /* no world, no asset, no mesh */
    set(batch, "set_asset", host_obj(asset));
    host_virtual(batch, "_get_configuration_warnings", NULL, &list.u.array);
    CHECK(list.u.array && list.u.array->count == 2);
    host_array_free(&list.u.array);
    host_free(batch);
}

/* A new file each time; the last has room for the beginning only. */
static void test_recordings(host_object* world) {
    for (int turn = 0; turn < 2; ++turn) {
        host_object* file = host_new("FileAccess", 1);
        host_variant hold = host_obj(file), answer;
        host.stored = 0, host.room = 1 << 30;
        answer = host_call(world, "start_recording", NULL, 1, host_obj(file));
        CHECK(answer.u.integer == 0 && file->refs == 2);
        const int64_t begun = host.stored;
        CHECK(begun > 1000 && host.flushes > 0); /* assets and a snapshot */
        answer = host_call(world, "start_recording", NULL, 1, host_obj(world));
        CHECK(answer.u.integer == 31); /* no file */
        answer = host_call(world, "start_recording", NULL, 1, host_obj(file));
        CHECK(answer.u.integer == 31 && file->refs == 2); /* a recording is already running */
        if (turn == 1) host.room = 0;
        for (int frame = 0; frame < 3; ++frame) host_notify(world, PHYSICS);
        CHECK((host.stored > begun) == (turn == 0));
        CHECK(call_int(world, "stop_recording") == (turn == 0 ? 0 : 31) && file->refs == 1);
        const int64_t ended = host.stored;
        host_notify(world, PHYSICS);
        CHECK(host.stored == ended);
        host_variant_destroy(&hold);
    }
}

/* A body that grows from nothing, as by a tween of its scale, gets its collider then; one that shrinks to nothing has none. */
static void test_size_of_nothing(void) {
    host_object* world = host_construct("LangevinWorld");
    const float scales[] = {0.0f, 1.0f, 0.0f, 2.0f};
    world->parent = host_root;
    host_notify(world, ENTER_TREE);
    for (int i = 0; i < 4; ++i) {
        for (int axis = 0; axis < 3; ++axis) host_body->transform[4 * axis] = scales[i];
        host_notify(world, PHYSICS);
        CHECK(call_int(world, "get_collider_count") == (scales[i] > 0.0f));
    }
    for (int axis = 0; axis < 3; ++axis) host_body->transform[4 * axis] = 1.0f;
    host_free(world);
}

/* Bodies that end while their node is hidden are not drawn when it is shown again, also in a paused game. */
static void test_hidden(host_object* asset, host_object* mesh) {
    host_object* world = host_construct("LangevinWorld");
    world->parent = host_root;
    host_notify(world, ENTER_TREE);
    host_object* batch = new_batch(world, asset, mesh, 50);
    set(batch, "set_emission_rate", host_float(0.0));
    set(batch, "set_lifetime", host_float(0.5));
    for (int frame = 0; frame < 5; ++frame) host_notify(world, PHYSICS);
    CHECK(host.shown == 50);
    for (int turn = 0; turn < 2; ++turn) {
        host.hidden = 1;
        host_notify(batch, VISIBILITY);
        for (int frame = 0; frame < 60 * turn; ++frame) host_notify(world, PHYSICS);
        host.hidden = 0;
        host_notify(batch, VISIBILITY);
        CHECK(call_int(batch, "get_body_count") == (turn ? 0 : 50) && host.shown == (turn ? 0 : 50));
    }
    leave(batch);
    host_free(world);
    host_free(batch);
}

static uint64_t run(host_object* asset, host_object* mesh, int frames) {
    host_object* world = host_construct("LangevinWorld");
    world->parent = host_root;
    set(world, "set_events", host_int(31));
    test_arguments(world);
    host_notify(world, ENTER_TREE);
    CHECK(host.connections == 3);
    host_object* batch = new_batch(world, asset, mesh, 200);
    host_object* other = new_batch(world, asset, mesh, 10);
    set(other, "set_lifetime", host_float(0.5));
    for (int frame = 0; frame < frames; ++frame) {
        if (frame == 100) batch->transform[9] = 1.0f, host_notify(batch, MOVED);
        if (frame == 200) host_body->transform[10] = 0.01f;
        host_notify(world, PHYSICS);
    }
    host_body->transform[10] = 0.0f;
    CHECK(call_int(batch, "get_body_count") == 600); /* 100 per second, up to the capacity */
    CHECK(call_int(world, "get_collider_count") == 1);
    CHECK(host.signals_touched > 0 && host.signals_landed > 0 && host.bodies_landed > 50);
    CHECK(host.buffers > frames && host.visible > 0);

    /* Results that own memory, by both kinds of calls. */
    host_variant rows = host_call(batch, "get_transforms", NULL, 0);
    host_variant drawn = host_call(batch, "get_instance_buffer", NULL, 0);
    CHECK(rows.u.array->count == 7200 && drawn.u.array->count >= 7200);
    CHECK(!memcmp(rows.u.array->data, drawn.u.array->data, 7200 * sizeof(float)));
    host_method* m = host_find_method(batch, "get_bodies");
    host_variant ids = host_call(batch, "get_bodies", NULL, 0), typed = host_nil();
    m->info.ptrcall(m->info.userdata, batch->instance, NULL, &typed.u.array);
    typed.type = GDX_PACKED_INT64_ARRAY;
    CHECK(typed.u.array->count == 600 && !memcmp(typed.u.array->data, ids.u.array->data, 600 * 8));
    m = host_find_method(batch, "get_asset");
    host_object* got = NULL;
    const int refs = asset->refs;
    m->info.ptrcall(m->info.userdata, batch->instance, NULL, &got);
    CHECK(got == asset && asset->refs == refs + 1);
    --asset->refs;
    host_variant_destroy(&typed);
    host_variant_destroy(&ids);
    host_variant_destroy(&rows);
    host_variant_destroy(&drawn);

    host_variant snapshot = host_call(world, "save_snapshot", NULL, 0), answer;
    CHECK(snapshot.u.array->count > 1000);
    answer = host_call(world, "restore_snapshot", NULL, 1, snapshot);
    CHECK(answer.u.integer == 0);
    host_variant_destroy(&answer);
    const uint64_t hash = (uint64_t)call_int(world, "get_state_hash");
    test_recordings(world);
    host_object* file = host_new("FileAccess", 1); /* the world releases it on leaving the tree */
    host.room = 1 << 30;
    answer = host_call(world, "start_recording", NULL, 1, host_obj(file));
    CHECK(answer.u.integer == 0);

    /* Freed in three orders: the batch first, the world first, and a batch while it is in the tree. */
    leave(other);
    CHECK(call_int(other, "get_body_count") == 0);
    host_notify(world, PHYSICS);
    host_free(other);
    host_notify(world, PHYSICS);
    leave(batch);
    host_notify(world, EXIT_TREE);
    CHECK(host.connections == 0);
    host_notify(world, ENTER_TREE);
    host_notify(batch, ENTER_TREE);
    host_notify(world, PHYSICS);
    CHECK(call_int(batch, "get_body_count") == 201 || call_int(batch, "get_body_count") == 200);
    host_free(world);
    CHECK(call_int(batch, "get_body_count") == 0);
    host_free(batch);
    return hash;
}

static int is(host_object* plugin, const char* method, host_object* node) {
    uint8_t yes = 2;
    const void* args[1] = {&node};
    host_virtual(plugin, method, args, &yes);
    return yes;
}

static void edit(host_object* plugin, host_object* node) {
    const void* args[1] = {&node};
    host_virtual(plugin, "_edit", args, NULL);
}

static void redraw(host_object* gizmos, host_object* gizmo, host_object* node) {
    const void* args[1] = {&gizmo}; /* a Ref has one pointer */
    gizmo->parent = node;
    host.reach = 0.0f;
    host_virtual(gizmos, "_redraw", args, NULL);
}

/* In the editor nodes are drawn by lines; bodies fall while their node is selected. */
static void test_editor(host_object* asset, host_object* mesh) {
    host_object* plugin = host_construct(host.plugin ? host.plugin->text : "");
    host_notify(plugin, ENTER_TREE);
    CHECK(host.gizmo_plugins == 1 && host.materials == 3);
    host_object* gizmos = host_construct("LangevinGizmoPlugin");
    host_object* gizmo = host_new("EditorNode3DGizmo", 0); /* held by the caller */
    host_variant hold = host_obj(gizmos);
    host_string* name = NULL;
    host_virtual(gizmos, "_get_gizmo_name", NULL, &name);
    CHECK(name && !strcmp(name->text, "Langevin Rigid"));
    host_string_free(&name);

    host_object* world = host_construct("LangevinWorld");
    world->parent = host_root;
    host_notify(world, ENTER_TREE);
    host_object* batch = new_batch(world, asset, mesh, 50);
    CHECK(is(plugin, "_handles", world) && is(plugin, "_handles", batch) && !is(plugin, "_handles", host_body));
    CHECK(is(gizmos, "_has_gizmo", batch) && !is(gizmos, "_has_gizmo", host_body) && !is(plugin, "_handles", NULL));
    redraw(gizmos, gizmo, world);
    CHECK(host.lines == 0); /* no wind */
    const int asked = host.redraws;
    set(world, "set_wind", host_vector(7, 0, 0));
    set(batch, "set_initial_velocity", host_vector(0, -3, 0));
    set(batch, "set_spread", host_float(20));
    CHECK(host.redraws == asked + 3);
    redraw(gizmos, gizmo, world);
    CHECK(host.lines == 5 && host.clicks == 5 && host.reach == 7.0f);
    redraw(gizmos, gizmo, batch);
    CHECK(host.lines == 12 + 5 + 8 && host.clicks == 12 && host.reach < 3.0f);

    host_notify(world, PROCESS);
    CHECK(call_int(world, "get_body_count") == 0 && !host.internal_process); /* nothing is selected */
    edit(plugin, batch);
    CHECK(host.internal_process == 1);
    const int drawn = host.visible;
    for (int frame = 0; frame < 30; ++frame) host_notify(world, PROCESS);
    CHECK(call_int(world, "get_body_count") >= 95 && host.visible > drawn && host.signals_landed == host.landed_before);
    edit(plugin, world); /* the same world: it goes on */
    CHECK(call_int(world, "get_body_count") >= 95);
    set(world, "set_preview", host_bool(0));
    CHECK(call_int(world, "get_body_count") == 0 && host.shown == 0 && !host.internal_process && host.connections == 0);
    set(world, "set_preview", host_bool(1));
    host_notify(world, PROCESS);
    CHECK(call_int(world, "get_body_count") >= 50 && host.shown >= 50);
    edit(plugin, NULL);
    CHECK(call_int(world, "get_body_count") == 0 && host.shown == 0 && host.connections == 0);
    edit(plugin, world);
    leave(batch); /* the scene is closed, and opened again */
    host_notify(world, EXIT_TREE);
    host_notify(world, ENTER_TREE);
    host_notify(batch, ENTER_TREE);
    CHECK(call_int(world, "get_body_count") == 0 && !host.internal_process);
    edit(plugin, world);
    CHECK(host.internal_process == 1);
    host_notify(batch, EXIT_TREE);
    host_notify(world, EXIT_TREE);
    host_free(batch);
    host_free(world); /* deleted while selected */
    edit(plugin, NULL);
    host_notify(plugin, EXIT_TREE);
    CHECK(host.gizmo_plugins == 0);
    host_free(plugin);
    host_free(gizmo);
    host_variant_destroy(&hold);
}

int main(int argc, char** argv) {
    if (argc != 3) return 2;
    host_start();
    void* library = dlopen(argv[1], RTLD_NOW);
    if (!library) return fprintf(stderr, "%s\n", dlerror()), 2;
    uint8_t (*init)(gdx_get_proc_address, gdx_library, gdx_initialization*);
    *(void**)&init = dlsym(library, "langevin_rigid_init");
    gdx_initialization levels;
    memset(&levels, 0, sizeof levels);
    CHECK(init && init(host_get, library, &levels) == 1 && levels.minimum_level == GDX_LEVEL_SCENE);
    const int objects = host.objects;
    for (gdx_level level = 0; level <= GDX_LEVEL_EDITOR; ++level) levels.initialize(levels.userdata, level);
    CHECK(host.help == 3 && host.warnings == 0 &&
          host.errors == 0); /* a warning names what has no text, or no member */
    host_class* batch = host_find_class("LangevinBatch");
    CHECK(batch && !strcmp(batch->parent, "Node3D") && batch->properties > 25 && batch->signals == 7);
    CHECK(host_find_class("LangevinWorld") && host_find_class("LangevinWorld")->constants == 10);
    CHECK(host_find_class("LangevinAsset") && !strcmp(host_find_class("LangevinAsset")->parent, "Resource"));

    CHECK(load("/nothing/there.lrb") == NULL && host.errors == 1);
    CHECK(load(argv[0]) == NULL && host.errors > 1); /* this program is not an asset */
    host_object* asset = load(argv[2]);
    host_object* mesh = host_new("MeshResource", 1);
    host_variant hold = host_obj(mesh);
    CHECK(asset != NULL);
    if (asset) {
        test_warnings(asset);
        test_size_of_nothing();
        test_hidden(asset, mesh);
        const uint64_t first = run(asset, mesh, 1000);
        const int errors = host.errors, names = host.names, live = host.objects;
        CHECK(run(asset, mesh, 1000) == first && first != 0);
        CHECK(host.names == names && host.objects == live);
        CHECK(host.errors == errors + 6); /* one from test_arguments, and five from test_recordings */
        CHECK(host.warnings == 2);        /* a recording without room, in each run */
        release(asset);
    }
    host_variant_destroy(&hold);
    CHECK(host.rids == 0 && host.multimeshes == 5 && host.redraws == 0);
    CHECK(host.postinitialize > 8);

    for (int level = GDX_LEVEL_EDITOR; level >= 0; --level) levels.deinitialize(levels.userdata, (gdx_level)level);
    CHECK(host.objects == objects && host.names == 0 && !host.plugin && !host_find_class("LangevinWorld"));

    /* An editor that finds the extension while it runs. */
    host.editor = 1;
    host.landed_before = host.signals_landed;
    for (gdx_level level = 0; level <= GDX_LEVEL_EDITOR; ++level) levels.initialize(levels.userdata, level);
    CHECK(host.plugin && host.help == 6);
    asset = load(argv[2]);
    mesh = host_new("MeshResource", 1);
    hold = host_obj(mesh);
    test_editor(asset, mesh);
    release(asset);
    host_variant_destroy(&hold);
    for (int level = GDX_LEVEL_EDITOR; level >= 0; --level) levels.deinitialize(levels.userdata, (gdx_level)level);
    CHECK(host.objects == objects && host.names == 0 && host.rids == 0 && !host.plugin);
    /* A class that stays crashes the editor at its end. */
    static const char* const names[] = {"LangevinAsset", "LangevinAssetLoader", "LangevinWorld",
                                        "LangevinBatch", "LangevinGizmoPlugin", "LangevinEditorPlugin"};
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) CHECK(!host_find_class(names[i]));
    host_stop();
    CHECK(host.objects == 0);
    printf("host: %d passed, %d failed\n", passed, failed);
    return failed != 0;
}
