/* SPDX-License-Identifier: MIT */
#include "ground.h"

#include <stdlib.h>

#include "drawing/failure.h"
#include "drawing/vectors.h"

float ground_height(float relief, float level, float x, float z) {
    const float waves = sinf(0.9f * x + 0.4f * z + 1.0f) + 0.8f * sinf(-0.5f * x + 1.1f * z) +
                        0.45f * sinf(1.9f * x - 1.6f * z + 2.0f) + 0.2f * sinf(3.7f * x + 3.1f * z);
    const float r = sqrtf(x * x + z * z);
    return level + 0.6f * relief * waves * (1.0f - smooth(6.0f, 11.0f, r));
}

float ground_surface(float relief, float level, float x, float z) {
    const float column = floorf((x + GROUND_HALF) / GROUND_CELL), row = floorf((z + GROUND_HALF) / GROUND_CELL);
    const float x0 = column * GROUND_CELL - GROUND_HALF, z0 = row * GROUND_CELL - GROUND_HALF;
    const float u = (x - x0) / GROUND_CELL, v = (z - z0) / GROUND_CELL;
    const float near = ground_height(relief, level, x0, z0);
    const float far = ground_height(relief, level, x0 + GROUND_CELL, z0 + GROUND_CELL);
    const float corner =
        u > v ? ground_height(relief, level, x0 + GROUND_CELL, z0) : ground_height(relief, level, x0, z0 + GROUND_CELL);
    return u > v ? near + u * (corner - near) + v * (far - corner) : near + v * (corner - near) + u * (far - corner);
}

void ground_heights(float relief, float level, float heights[ground_side * ground_side]) {
    for (int k = 0; k < ground_side; ++k)
        for (int i = 0; i < ground_side; ++i)
            heights[k * ground_side + i] = ground_height(relief, level, (float)i * GROUND_CELL - GROUND_HALF,
                                                         (float)k * GROUND_CELL - GROUND_HALF);
}

lr_collider ground_create(lr_world* world, float relief, float level) {
    lr_collider_desc desc;
    check(lr_collider_desc_init(&desc, sizeof desc), "lr_collider_desc_init", NULL);
    desc.friction = 0.7f;
    float* heights = NULL;
    if (relief > 0.0f) {
        heights = allocate(ground_side * ground_side, sizeof(float));
        ground_heights(relief, level, heights);
        desc.kind = LR_COLLIDER_HEIGHTFIELD;
        desc.position[0] = desc.position[2] = -GROUND_HALF;
        desc.counts[0] = desc.counts[1] = ground_side;
        desc.spacing[0] = desc.spacing[1] = GROUND_CELL;
        desc.heights = heights;
    } else {
        desc.kind = LR_COLLIDER_PLANE;
        desc.position[1] = level;
    }
    lr_collider ground = {0};
    check(lr_collider_create(world, &desc, 1, &ground), "cannot create the ground", NULL);
    free(heights);
    return ground;
}
