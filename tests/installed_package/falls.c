/* A minimal outside program: a body falls, and its pose is written as a matrix. */
#include <langevin_rigid.h>
#include <stdio.h>

int main(void) {
    lr_ellipsoid_desc shape;
    lr_world_desc world_desc;
    lr_batch_desc batch_desc;
    lr_body_desc body_desc;
    lr_asset* asset = NULL;
    lr_world* world = NULL;
    lr_batch batch = {0};
    lr_body body = {0};
    float matrix[16];
    uint32_t written = 0;
    uint64_t hash = 0;
    int step;

    if (lr_version() >> 12 != ((LR_VERSION_MAJOR << 10) | LR_VERSION_MINOR)) return 1;
    if (lr_ellipsoid_desc_init(&shape, sizeof shape)) return 2;
    shape.semi_axes[0] = 0.04;
    shape.semi_axes[1] = 0.02;
    shape.semi_axes[2] = 0.001;
    shape.density = 300.0;
    if (lr_asset_create_ellipsoid(&shape, &asset)) return 3;
    if (lr_world_desc_init(&world_desc, sizeof world_desc) || lr_world_create(&world_desc, &world)) return 4;
    if (lr_batch_desc_init(&batch_desc, sizeof batch_desc)) return 5;
    batch_desc.asset = asset;
    batch_desc.capacity = 1;
    if (lr_batch_create(world, &batch_desc, &batch)) return 6;
    lr_asset_release(asset);
    if (lr_body_desc_init(&body_desc, sizeof body_desc) || lr_body_create(world, batch, &body_desc, 1, &body)) return 7;
    for (step = 0; step < 60; ++step)
        if (lr_world_step(world, 1.0f / 60.0f, 4)) return 8;
    if (lr_batch_write_transforms(world, batch, LR_TRANSFORM_4X4_COLUMN_MAJOR, matrix, 0, 1, &written)) return 9;
    if (written != 1 || !(matrix[13] < -0.1f)) return 10;
    if (lr_world_hash(world, &hash)) return 11;
    printf("%08lx%08lx\n", (unsigned long)(hash >> 32), (unsigned long)(hash & 0xffffffffu));
    lr_world_destroy(world);
    return 0;
}
