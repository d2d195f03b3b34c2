/*
 * SPDX-License-Identifier: MIT
 *
 * Makes all typical calls of a host on the library, between marks that strace shows (check_syscalls.sh): accesses to files that do
 * not exist. Otherwise it makes no system calls, and it uses the library's default allocator, the C library's.
 *   quiet_scene leaf.lrb [open]     open: a callback breaks the rule, which the check must detect
 */
#include <langevin_rigid.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define NEED(call)                                                                                                     \
    if ((call) != LR_OK) return __LINE__

static void mark(const char* name) {
    char path[64] = "/lr-mark-";
    strncat(path, name, 40);
    (void)access(path, F_OK);
}

static const char* misdeed = "";

static void wind(void* user, const lr_wind_query* query) {
    uint32_t i;
    (void)user;
    for (i = 0; i < query->count; ++i) query->velocity[0][i] = 1.0f;
    if (strcmp(misdeed, "open") == 0) {
        FILE* const file = fopen("/etc/hostname", "r");
        if (file) fclose(file);
    }
}

static int fill(lr_world* world, lr_asset* leaf, lr_batch* batch) {
    lr_batch_desc b;
    lr_emitter_desc e;
    lr_batch_rules r;
    lr_gusts_desc g;
    lr_vortex_desc v;
    lr_blower_desc o;
    lr_turbulence_desc t;
    lr_collider_desc c;
    lr_water_desc w;
    NEED(lr_batch_desc_init(&b, sizeof b));
    b.asset = leaf, b.capacity = 4000;
    NEED(lr_batch_create(world, &b, batch));
    NEED(lr_emitter_desc_init(&e, sizeof e));
    e.shape = LR_EMIT_BOX, e.position[1] = 1.0f, e.size[0] = e.size[2] = 2.0f, e.size[1] = 0.5f, e.rate = 500.0f;
    NEED(lr_batch_set_emitter(world, *batch, &e));
    NEED(lr_batch_spawn(world, *batch, 3000, NULL));
    NEED(lr_batch_rules_init(&r, sizeof r));
    r.max_age = 1.0f, r.action = LR_END_RESPAWN;
    NEED(lr_batch_set_rules(world, *batch, &r));
    NEED(lr_gusts_desc_init(&g, sizeof g));
    NEED(lr_world_add_gusts(world, &g, NULL));
    NEED(lr_vortex_desc_init(&v, sizeof v));
    NEED(lr_world_add_vortex(world, &v, NULL));
    NEED(lr_blower_desc_init(&o, sizeof o));
    NEED(lr_world_add_blower(world, &o, NULL));
    NEED(lr_turbulence_desc_init(&t, sizeof t));
    NEED(lr_world_add_turbulence(world, &t, NULL));
    NEED(lr_world_set_wind_callback(world, wind, NULL));
    NEED(lr_water_desc_init(&w, sizeof w));
    w.position[1] = 0.2f;
    NEED(lr_world_set_water(world, &w));
    NEED(lr_collider_desc_init(&c, sizeof c));
    c.kind = LR_COLLIDER_PLANE;
    NEED(lr_collider_create(world, &c, 1, NULL));
    NEED(lr_batch_set_body_contact(world, *batch, *batch, 1));
    NEED(lr_world_set_events(world, 1000, LR_EVENTS_ALL));
    return 0;
}

static int look(lr_world* world, lr_batch batch) {
    static float matrices[4000][12];
    lr_ray ray;
    lr_ray_hit hit;
    uint64_t hash = 0;
    const uint64_t size = lr_world_snapshot_size(world);
    void* const memory = malloc((size_t)size);
    if (!memory) return __LINE__;
    NEED(lr_batch_write_transforms(world, batch, LR_TRANSFORM_3X4_ROW_MAJOR, matrices, 0, 4000, NULL));
    NEED(lr_ray_init(&ray, sizeof ray));
    NEED(lr_world_ray_cast(world, &ray, 1, &hit));
    NEED(lr_world_hash(world, &hash));
    NEED(lr_world_snapshot_save(world, memory, size, NULL));
    NEED(lr_world_snapshot_restore(world, memory, size));
    free(memory);
    return 0;
}

static int play(const char* path) {
    lr_world_desc d;
    lr_asset *leaf = NULL, *none = NULL;
    lr_world* world = NULL;
    lr_batch batch = {0};
    int frame, failed;
    mark("load");
    NEED(lr_asset_load_file(path, &leaf));
    mark("scene");
    if (lr_asset_load_memory("not an asset", 12, &none) != LR_ERROR_ASSET_FORMAT) return __LINE__;
    NEED(lr_world_desc_init(&d, sizeof d));
    d.worker_count = 2;
    NEED(lr_world_create(&d, &world));
    if ((failed = fill(world, leaf, &batch)) != 0) return failed;
    NEED(lr_world_step(world, 1.0f / 60.0f, 2));
    mark("steps");
    for (frame = 0; frame < 45; ++frame) NEED(lr_world_step(world, 1.0f / 60.0f, 2));
    mark("look");
    if ((failed = look(world, batch)) != 0) return failed;
    lr_world_destroy(world);
    lr_asset_release(leaf);
    mark("end");
    return 0;
}

int main(int count, char** arguments) {
    int failed;
    if (count < 2) return 2;
    if (count > 2) misdeed = arguments[2];
    failed = play(arguments[1]);
    if (failed) fprintf(stderr, "quiet_scene.c:%d\n", failed);
    return failed != 0;
}
