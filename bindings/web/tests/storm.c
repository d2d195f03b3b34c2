/*
 * The storm of storm.mjs, natively: prints hash and ns a body-step of each instruction set, and writes a snapshot.
 *   storm leaf.lrb BODIES FRAMES snapshot
 *
 * SPDX-License-Identifier: MIT
 */
#define _POSIX_C_SOURCE 199309L
#include <langevin_rigid.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static void check(lr_status status, const char* what) {
    if (status != LR_OK) {
        fprintf(stderr, "storm: %s: %s\n", what, lr_status_string(status));
        exit(2);
    }
}

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

int main(int count, char** arguments) {
    if (count != 5) return 2;
    const uint32_t bodies = (uint32_t)atoi(arguments[2]);
    const int frames = atoi(arguments[3]);
    int32_t targets[8];
    uint32_t target_count = 0;
    check(lr_simd_targets(targets, 8, &target_count), "targets");
    lr_asset* leaf = NULL;
    check(lr_asset_load_file(arguments[1], &leaf), "leaf");
    for (uint32_t t = 0; t < target_count; ++t) {
        lr_world_desc wd;
        lr_batch_desc bd;
        lr_gusts_desc gusts;
        lr_collider_desc ground;
        lr_world* world = NULL;
        lr_batch batch = {0};
        check(lr_world_desc_init(&wd, sizeof wd), "world desc");
        check(lr_batch_desc_init(&bd, sizeof bd), "batch desc");
        check(lr_gusts_desc_init(&gusts, sizeof gusts), "gusts desc");
        check(lr_collider_desc_init(&ground, sizeof ground), "collider desc");
        wd.seed = 7;
        wd.simd_target = targets[t];
        check(lr_world_create(&wd, &world), "world");
        bd.asset = leaf;
        bd.capacity = bodies;
        check(lr_batch_create(world, &bd, &batch), "batch");
        check(lr_world_set_uniform_wind(world, 2.0f, 0.0f, 0.0f), "wind");
        check(lr_world_add_gusts(world, &gusts, NULL), "gusts");
        ground.kind = LR_COLLIDER_PLANE;
        check(lr_collider_create(world, &ground, 1, NULL), "ground");
        for (uint32_t i = 0; i < bodies; ++i) {
            lr_body_desc body;
            check(lr_body_desc_init(&body, sizeof body), "body desc");
            body.position[0] = 0.25f * (float)(i % 100);
            body.position[1] = 0.5f + 0.25f * (float)(i / 100 % 20);
            body.position[2] = 0.25f * (float)(i / 2000);
            body.orientation[0] = 0.5f;
            check(lr_body_create(world, batch, &body, 1, NULL), "body");
        }
        double least = 1e300; /* s, of ten frames: what other programs take is not counted */
        for (int frame = 0; frame < frames;) {
            const double since = now();
            const int end = frame + 10 < frames ? frame + 10 : frames;
            const int counted = end - frame;
            for (; frame < end; ++frame) check(lr_world_step(world, 1.0f / 64.0f, 2), "step");
            const double spent = (now() - since) / counted;
            least = spent < least ? spent : least;
        }
        const double ns = 1e9 * least / (double)bodies;
        uint64_t hash = 0;
        check(lr_world_hash(world, &hash), "hash");
        printf("%016llx %.1f %s\n", (unsigned long long)hash, ns, lr_simd_target_name(targets[t]));
        if (t == 0) {
            const uint64_t size = lr_world_snapshot_size(world);
            void* const bytes = malloc(size);
            if (!bytes) return 2;
            check(lr_world_snapshot_save(world, bytes, size, NULL), "snapshot");
            FILE* const file = fopen(arguments[4], "wb");
            if (!file || fwrite(bytes, 1, size, file) != size || fclose(file) != 0) return 2;
            free(bytes);
        }
        lr_world_destroy(world);
    }
    lr_asset_release(leaf);
    return 0;
}
