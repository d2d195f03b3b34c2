/*
 * Rollback: two peers simulate the same leaves. Each applies its own input at once and predicts the other's, which arrives some
 * frames late. After a wrong prediction it restores that frame's snapshot and steps again. Both end with the same hash.
 *
 * SPDX-License-Identifier: MIT
 */
#include <langevin_rigid.h>
#include <stdio.h>
#include <stdlib.h>

enum { FRAMES = 300, LATE = 7, RING = 16, LEAVES = 2000 };

typedef struct {
    float wind, push; /* m/s, uniform wind along x; m/s^2, upward, on all leaves */
} input;

typedef struct {
    lr_world* world;
    lr_batch batch;
    input of[2][FRAMES]; /* of both peers: received or predicted */
    void* ring[RING];    /* the state before a frame */
    uint64_t size[RING], room[RING];
    int replayed; /* frames stepped again */
} peer;

static void check(lr_status status, const char* what) {
    if (status == LR_OK) return;
    fprintf(stderr, "rollback: %s: %s\n", what, lr_status_string(status));
    exit(1);
}

static void create(peer* p, const lr_asset* leaf) {
    lr_world_desc wd;
    lr_batch_desc bd;
    lr_emitter_desc e;
    check(lr_world_desc_init(&wd, sizeof wd), "world");
    check(lr_batch_desc_init(&bd, sizeof bd), "batch");
    check(lr_emitter_desc_init(&e, sizeof e), "emitter");
    bd.asset = leaf, bd.capacity = LEAVES;
    e.shape = LR_EMIT_BOX, e.position[1] = 5.0f, e.size[0] = e.size[1] = e.size[2] = 4.0f;
    check(lr_world_create(&wd, &p->world), "world");
    check(lr_batch_create(p->world, &bd, &p->batch), "batch");
    check(lr_batch_set_emitter(p->world, p->batch, &e), "emitter");
    check(lr_batch_spawn(p->world, p->batch, LEAVES, NULL), "leaves");
}

/* The ring's memory grows with the world; otherwise saving and restoring allocate nothing. */
static void step(peer* p, int frame) {
    const int at = frame % RING;
    lr_batch_force force;
    p->size[at] = lr_world_snapshot_size(p->world);
    if (p->room[at] < p->size[at]) p->ring[at] = realloc(p->ring[at], p->room[at] = p->size[at]);
    check(lr_world_snapshot_save(p->world, p->ring[at], p->size[at], NULL), "save");
    check(lr_batch_force_init(&force, sizeof force), "force");
    force.acceleration[1] = p->of[0][frame].push + p->of[1][frame].push;
    check(lr_world_set_uniform_wind(p->world, p->of[0][frame].wind + p->of[1][frame].wind, 0.0f, 0.0f), "wind");
    check(lr_batch_set_force(p->world, p->batch, &force), "force");
    check(lr_world_step(p->world, 1.0f / 60.0f, 2), "step");
}

/* Receives the other peer's input of an earlier frame; `now` is the next frame to step. */
static void receive(peer* p, int other, int frame, input in, int now) {
    const int right = p->of[other][frame].wind == in.wind && p->of[other][frame].push == in.push;
    for (int f = frame; f < FRAMES; ++f) p->of[other][f] = in; /* the prediction: it stays the same */
    if (right || frame >= now) return;
    check(lr_world_snapshot_restore(p->world, p->ring[frame % RING], p->size[frame % RING]), "restore");
    for (int f = frame; f < now; ++f, ++p->replayed) step(p, f);
}

static input played(int who, int frame) {
    return (input){who == 0 && frame / 40 % 2 ? 3.0f : 0.5f, who == 1 && frame % 50 < 10 ? 6.0f : 0.0f};
}

int main(void) {
    static peer peers[2];
    uint64_t hash[2];
    lr_asset* leaf = NULL;
    lr_ellipsoid_desc shape;
    check(lr_ellipsoid_desc_init(&shape, sizeof shape), "leaf");
    shape.semi_axes[0] = 0.04, shape.semi_axes[1] = 0.02, shape.semi_axes[2] = 1e-4, shape.density = 400.0;
    check(lr_asset_create_ellipsoid(&shape, &leaf), "leaf");
    for (int who = 0; who < 2; ++who) create(&peers[who], leaf);
    for (int frame = 0; frame < FRAMES + LATE; ++frame)
        for (int who = 0; who < 2; ++who) {
            const int now = frame < FRAMES ? frame : FRAMES;
            if (frame >= LATE) receive(&peers[who], !who, frame - LATE, played(!who, frame - LATE), now);
            if (frame < FRAMES) peers[who].of[who][frame] = played(who, frame), step(&peers[who], frame);
        }
    for (int who = 0; who < 2; ++who) {
        check(lr_world_hash(peers[who].world, &hash[who]), "hash");
        printf("peer %d: %d steps redone, hash %016llx\n", who, peers[who].replayed, (unsigned long long)hash[who]);
        lr_world_destroy(peers[who].world);
        for (int at = 0; at < RING; ++at) free(peers[who].ring[at]);
    }
    lr_asset_release(leaf);
    return hash[0] == hash[1] && peers[0].replayed > 0 && peers[1].replayed > 0 ? 0 : 1;
}
