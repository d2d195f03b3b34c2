/*
 * The library's side of a batch: created and destroyed, and updated from its node's properties.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"
#include "transform.h"

#include <math.h>
#include <string.h>

static void complain(const batch_node* self, const char* what, lr_status status) {
    if (status != LR_OK) {
        const asset_node* asset = batch_asset(self);
        gd_error("%s, %s: %s", asset ? asset->info.name : "batch", what, lr_status_string(status));
    }
}

static void apply_rules(batch_node* self) {
    lr_batch_rules rules;
    lr_batch_rules_init(&rules, sizeof rules);
    rules.action = self->respawn ? LR_END_RESPAWN : LR_END_DESTROY;
    rules.max_age = (float)self->lifetime;
    if (self->bounds[3] != 0.0f && self->bounds[4] != 0.0f && self->bounds[5] != 0.0f) {
        lr_kill_volume* volume = &rules.volumes[rules.volume_count++];
        volume->shape = LR_VOLUME_BOX;
        volume->side = LR_KILL_OUTSIDE;
        for (int i = 0; i < 3; ++i) {
            volume->size[i] = 0.5f * fabsf(self->bounds[3 + i]);
            volume->center[i] = self->bounds[i] + 0.5f * self->bounds[3 + i];
        }
    }
    complain(self, "rules", lr_batch_set_rules(self->world->world, self->batch, &rules));
}

static void apply_emitter(batch_node* self) {
    float global[12], scale[3];
    lr_emitter_desc desc;
    lr_emitter_desc_init(&desc, sizeof desc);
    desc.shape = LR_EMIT_BOX;
    if (gd_call_floats(self->base.object, GD_N_get_global_transform, GDX_TRANSFORM3D, global) &&
        transform_split(global, desc.position, desc.orientation, scale))
        for (int i = 0; i < 3; ++i) desc.size[i] = self->extents[i] * fabsf(scale[i]);
    desc.pose = self->random_orientation ? LR_POSE_RANDOM : LR_POSE_FIXED;
    memcpy(desc.body_orientation, desc.orientation, sizeof desc.body_orientation);
    const float* v = self->velocity;
    const float speed = sqrtf(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (speed > 0.0f) memcpy(desc.direction, v, sizeof desc.direction);
    desc.speed_min = desc.speed_max = speed;
    desc.spread = (float)(self->spread * 3.14159265358979 / 180.0);
    desc.spin_max = (float)self->spin;
    desc.scale_min = (float)fmin(self->scale_min, self->scale_max);
    desc.scale_max = (float)fmax(self->scale_min, self->scale_max);
    desc.rate = self->emitting ? (float)self->rate : 0.0f;
    complain(self, "emitter", lr_batch_set_emitter(self->world->world, self->batch, &desc));
}

static void apply_all(batch_node* self) {
    lr_world* world = self->world->world;
    lr_load_gains gains;
    lr_load_gains_init(&gains, sizeof gains);
    gains.drag = (float)self->drag;
    gains.lift = (float)self->lift;
    gains.spin_drag = (float)self->spin_drag;
    gains.turbulence = (float)self->turbulence;
    complain(self, "gains", lr_batch_set_load_gains(world, self->batch, &gains));
    lr_batch_contact contact;
    lr_batch_contact_init(&contact, sizeof contact);
    contact.layers = (uint32_t)self->collision_mask;
    contact.friction = (float)self->friction;
    contact.restitution = (float)self->bounce;
    complain(self, "contact", lr_batch_set_contact(world, self->batch, &contact));
    int32_t meets = 0;
    lr_batch_get_body_contact(world, self->batch, self->batch, &meets);
    if (meets != (self->body_contact != 0))
        complain(self, "body_contact",
                 lr_batch_set_body_contact(world, self->batch, self->batch, self->body_contact != 0));
    complain(self, "rate_divisor", lr_batch_set_rate(world, self->batch, (uint32_t)self->rate_divisor));
}

void batch_ensure(batch_node* self) {
    if (!self->world || !self->world->world) return;
    if (self->rebuild) {
        batch_leave(self);
        self->rebuild = 0;
        const asset_node* asset = batch_asset(self);
        if (!asset || !asset->asset) return; /* the editor shows a warning on the node */
        lr_batch_desc desc;
        lr_batch_desc_init(&desc, sizeof desc);
        desc.asset = asset->asset;
        desc.capacity = (uint32_t)self->capacity;
        desc.variation = (float)self->variation;
        const lr_status status = lr_batch_create(self->world->world, &desc, &self->batch);
        complain(self, "batch", status);
        if (status != LR_OK) return;
        batch_draw_changed(self);
        apply_all(self);
        apply_emitter(self);
        apply_rules(self);
        self->retune = self->moved = 0;
        const int64_t first = self->initial_count < self->capacity ? self->initial_count : self->capacity;
        if (first > 0)
            complain(self, "initial_count", lr_batch_spawn(self->world->world, self->batch, (uint32_t)first, NULL));
    }
    if (!self->batch.id) return;
    if (self->retune) {
        apply_all(self);
        apply_emitter(self); /* before the rules: respawning needs an emitter */
        apply_rules(self);
    } else if (self->moved) {
        apply_emitter(self);
    }
    self->retune = self->moved = 0;
}

void batch_leave(batch_node* self) {
    if (self->batch.id && self->world && self->world->world) lr_batch_destroy(self->world->world, self->batch);
    self->batch = (lr_batch){0};
    self->rebuild = 1;
    batch_draw_nothing(self);
    self->drawn = self->moving = 0;
    self->revision = 0;
}
