/*
 * The first falling bodies: a few of the paper's leaves, released at different tilts, for two seconds.
 *
 * SPDX-License-Identifier: MIT
 */
#include <langevin_rigid.h>
#include <stdio.h>
#include <stdlib.h>

#define BODIES 6u

static void check(lr_status status, const char* what) {
    if (status != LR_OK) {
        fprintf(stderr, "hello: %s: %s\n", what, lr_status_string(status));
        exit(2);
    }
}

int main(void) {
    /* The shape: a thin ellipsoid, 8 cm x 2 cm x 0.1 mm. Closed forms give its mass and added mass. */
    lr_ellipsoid_desc shape;
    lr_asset* leaf = NULL;
    check(lr_ellipsoid_desc_init(&shape, sizeof shape), "ellipsoid desc");
    shape.semi_axes[0] = 0.04;
    shape.semi_axes[1] = 0.01;
    shape.semi_axes[2] = 0.00005;
    shape.density = 800.0;
    check(lr_asset_create_ellipsoid(&shape, &leaf), "ellipsoid");

    /* A world with still air, gravity along -y, and a batch: all bodies of one asset. */
    lr_world_desc world_desc;
    lr_world* world = NULL;
    check(lr_world_desc_init(&world_desc, sizeof world_desc), "world desc");
    world_desc.seed = 1;
    check(lr_world_create(&world_desc, &world), "world");

    lr_batch_desc batch_desc;
    lr_batch batch = {0};
    check(lr_batch_desc_init(&batch_desc, sizeof batch_desc), "batch desc");
    batch_desc.asset = leaf;
    batch_desc.capacity = BODIES;
    check(lr_batch_create(world, &batch_desc, &batch), "batch");
    lr_asset_release(leaf); /* the batch keeps its own reference */

    /* The thin axis (body z) points up, then tilts a little more from leaf to leaf. */
    lr_body_desc descs[BODIES];
    lr_body bodies[BODIES];
    for (unsigned i = 0; i < BODIES; ++i) {
        check(lr_body_desc_init(&descs[i], sizeof descs[i]), "body desc");
        descs[i].position[0] = 0.5f * (float)i;
        descs[i].position[1] = 10.0f;
        descs[i].orientation[0] = -1.0f;
        descs[i].orientation[1] = 0.15f * (float)i;
        descs[i].orientation[3] = 1.0f;
    }
    check(lr_body_create(world, batch, descs, BODIES, bodies), "bodies");

    /* Two seconds of frames. A renderer would write the transforms into its instance buffer after each. */
    float transforms[BODIES][12];
    for (int frame = 0; frame < 120; ++frame) {
        check(lr_world_step(world, 1.0f / 60.0f, 4), "step");
        check(lr_batch_write_transforms(world, batch, LR_TRANSFORM_3X4_ROW_MAJOR, transforms, 0, BODIES, NULL),
              "transforms");
    }

    lr_body_state state;
    check(lr_body_state_init(&state, sizeof state), "state");
    printf("leaf  fallen m  aside m  speed down m/s  spin y rad/s\n");
    for (unsigned i = 0; i < BODIES; ++i) {
        check(lr_body_get_state(world, bodies[i], &state), "state");
        printf("%4u  %8.3f  %7.3f  %14.3f  %12.2f\n", i, (double)(descs[i].position[1] - state.position[1]),
               (double)(state.position[0] - descs[i].position[0]), (double)-state.linear_velocity[1],
               (double)state.angular_velocity[1]);
    }
    uint64_t hash = 0;
    check(lr_world_hash(world, &hash), "hash");
    printf("state %08lx%08lx after 2 s\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    lr_world_destroy(world);
    return 0;
}
