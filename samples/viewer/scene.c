/* SPDX-License-Identifier: MIT */
#include "scene.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "drawing/failure.h"
#include "drawing/vectors.h"
#include "ground.h"
#include "scene_wind.h"

const lr_wave pond_waves[pond_wave_count] = {{{1.0f, 0.0f, -0.4f}, 0.9f, 0.012f, 0.0f},
                                             {{0.7f, 0.0f, 0.7f}, 0.55f, 0.006f, 1.3f},
                                             {{0.3f, 0.0f, -1.0f}, 1.7f, 0.014f, 2.1f}};

static void log_warnings(void* user, int32_t level, const char* message) {
    (void)user;
    if (level <= LR_LOG_WARNING) fprintf(stderr, "langevin_rigid: %s\n", message);
}

static void create_world(scene* s, const scene_source* source) {
    lr_world_desc desc;
    check(lr_world_desc_init(&desc, sizeof desc), "lr_world_desc_init", "header and library differ: build again");
    desc.seed = source->seed;
    desc.worker_count = source->threads - 1;
    desc.log = log_warnings;
    check(lr_world_create(&desc, &s->world), "cannot create the world", "try fewer --threads");
}

static void create_solids(scene* s) {
    ground_create(s->world, s->plan->relief, s->plan->ground_level);
    for (int i = 0; i < scene_solids && s->plan->solids[i].kind; ++i) {
        const ground_solid* solid = &s->plan->solids[i];
        lr_collider_desc desc;
        check(lr_collider_desc_init(&desc, sizeof desc), "lr_collider_desc_init", NULL);
        desc.kind = solid->kind;
        memcpy(desc.position, solid->at, sizeof desc.position);
        memcpy(desc.size, solid->size, sizeof desc.size);
        desc.orientation[1] = sinf(0.5f * solid->turn);
        desc.orientation[3] = cosf(0.5f * solid->turn);
        check(lr_collider_create(s->world, &desc, 1, NULL), "cannot create a collider", NULL);
    }
    if (!s->plan->water) return;
    lr_water_desc surface;
    check(lr_water_desc_init(&surface, sizeof surface), "lr_water_desc_init", NULL);
    surface.wave_count = pond_wave_count;
    memcpy(surface.waves, pond_waves, sizeof pond_waves);
    check(lr_world_set_water(s->world, &surface), "cannot make the water", NULL);
}

static void load_asset(scene_batch* b, const scene_source* source, int k) {
    char asset[1024], drawn[1024];
    const int own = source->own_assets[k] != NULL;
    snprintf(asset, sizeof asset, own ? "%s" : "%s/%s.lrb", own ? source->own_assets[k] : source->baked,
             b->kind->asset);
    snprintf(drawn, sizeof drawn, "%s/%s.obj", source->meshes,
             strcmp(b->kind->asset, "rubber") == 0 ? "ellipsoid_rubber" : b->kind->asset);
    const lr_status status = lr_asset_load_file(asset, &b->asset);
    if (status != LR_OK)
        fail("bake it: samples/viewer/bake.sh LR_BAKE ASSETS FOLDER, then --baked FOLDER; or give --asset FILE.lrb",
             "asset %s: %s", asset, lr_status_string(status));
    check(lr_asset_info_init(&b->info, sizeof b->info), "lr_asset_info_init", NULL);
    check(lr_asset_get_info(b->asset, &b->info), asset, NULL);
    if (!own)
        b->mesh = mesh_load_obj(drawn, &b->info);
    else
        b->mesh = source->own_meshes[k] ? mesh_load_obj(source->own_meshes[k], &b->info) : mesh_ellipsoid(&b->info);
    if (!(mesh_radius(&b->mesh) > 0.0f)) fail("give another --mesh", "the mesh of %s has no size", asset);
}

static void create_batch(scene* s, scene_batch* b) {
    lr_batch_desc desc;
    check(lr_batch_desc_init(&desc, sizeof desc), "lr_batch_desc_init", NULL);
    desc.asset = b->asset;
    desc.capacity = b->capacity;
    desc.load_model = load_models[(int)s->now.value[setting_model]].value;
    check(lr_batch_create(s->world, &desc, &b->batch), "cannot create the bodies", "try a smaller --count");
    lr_batch_contact contact;
    check(lr_batch_contact_init(&contact, sizeof contact), "lr_batch_contact_init", NULL);
    contact.ground_effect = s->plan->ground_effect;
    check(lr_batch_set_contact(s->world, b->batch, &contact), "contact", NULL);
}

/* Old bodies, and bodies outside the visible part, respawn. */
static void set_rules(scene* s, const scene_batch* b) {
    lr_batch_rules rules;
    check(lr_batch_rules_init(&rules, sizeof rules), "lr_batch_rules_init", NULL);
    rules.action = LR_END_RESPAWN;
    rules.max_age = s->plan->life;
    rules.volume_count = 1;
    rules.volumes[0].shape = LR_VOLUME_BOX;
    rules.volumes[0].side = LR_KILL_OUTSIDE;
    to_array(v3(0.0f, 20.0f - 3.0f, 0.0f), rules.volumes[0].center);
    to_array(v3(GROUND_HALF - 0.5f, 20.0f, GROUND_HALF - 0.5f), rules.volumes[0].size);
    check(lr_batch_set_rules(s->world, b->batch, &rules), "rules", NULL);
}

static lr_emitter_desc emitter_of(const scene* s, const scene_batch* b) {
    const scene_kind* kind = b->kind;
    lr_emitter_desc desc;
    check(lr_emitter_desc_init(&desc, sizeof desc), "lr_emitter_desc_init", NULL);
    desc.shape = LR_EMIT_BOX;
    memcpy(desc.position, kind->at, sizeof desc.position);
    memcpy(desc.size, kind->half, sizeof desc.size);
    if (kind->thrown) {
        /* Nose along x, top along z: laid flat, then rotated about y. */
        const float half = 0.5f * atan2f(-kind->direction[2], kind->direction[0]);
        const float c = cosf(half), t = sinf(half), r = sqrtf(0.5f);
        desc.pose = LR_POSE_FIXED;
        desc.body_orientation[0] = -r * c;
        desc.body_orientation[1] = r * t;
        desc.body_orientation[2] = r * t;
        desc.body_orientation[3] = r * c;
    }
    if (kind->speed_max > 0.0f) memcpy(desc.direction, kind->direction, sizeof desc.direction);
    desc.spread = kind->spread;
    desc.speed_min = kind->speed_min, desc.speed_max = kind->speed_max;
    desc.spin_max = kind->spin;
    desc.scale_min = kind->scale_min, desc.scale_max = kind->scale_max;
    if (kind->burst > 0.0f) {
        desc.burst_interval = kind->burst;
        desc.burst_count = (uint32_t)ceilf((float)b->count * kind->burst / s->plan->life);
    } else {
        desc.rate = (float)b->count / s->plan->life;
    }
    return desc;
}

static void emit(scene* s, const scene_batch* b, const lr_emitter_desc* desc, uint32_t count) {
    check(lr_batch_set_emitter(s->world, b->batch, desc), "emitter", "try a smaller --count");
    check(lr_batch_spawn(s->world, b->batch, count < b->count ? count : b->count, NULL), "births", NULL);
}

/* Fills the air at once: with the number of bodies that spawn during a fall, at all heights; or with the first burst. */
static void fill_air(scene* s, const scene_batch* b) {
    const scene_kind* kind = b->kind;
    lr_emitter_desc desc = emitter_of(s, b);
    if (kind->burst > 0.0f) emit(s, b, &desc, desc.burst_count);
    if (!(s->plan->ready > 0.0f) || kind->burst > 0.0f) return;
    const float top = kind->at[1] + kind->half[1], bottom = 0.25f * top;
    const float fall = s->plan->ready * (top - bottom) / 1.1f; /* s, from about the speed of leaves and paper */
    const uint32_t count = (uint32_t)(desc.rate * fall);
    desc.position[1] = 0.5f * (top + bottom);
    desc.size[1] = 0.5f * (top - bottom);
    emit(s, b, &desc, count);
}

static void set_emitter(scene* s, const scene_batch* b) {
    const lr_emitter_desc desc = emitter_of(s, b);
    check(lr_batch_set_emitter(s->world, b->batch, &desc), "emitter", "try a smaller --count");
}

static void apply_body_contact(scene* s) {
    for (int a = 0; a < s->batch_count; ++a)
        for (int b = 0; b <= a; ++b)
            check(lr_batch_set_body_contact(s->world, s->batches[a].batch, s->batches[b].batch,
                                            s->now.value[setting_contact] > 0.0f),
                  "cannot set contact between bodies", "try a smaller --count");
}

static uint32_t share_of(const scene* s, int k, float count) {
    float whole = 0.0f, before = 0.0f;
    for (int i = 0; i < s->batch_count; ++i) {
        if (i < k) before += s->batches[i].kind->share;
        whole += s->batches[i].kind->share;
    }
    const float share = s->batches[k].kind->share;
    const uint32_t n = (uint32_t)roundf(count * (before + share) / whole) - (uint32_t)roundf(count * before / whole);
    return n;
}

scene* scene_create(const scene_plan* plan, const scene_source* source, const settings* initially) {
    scene* s = allocate(1, sizeof *s);
    s->plan = plan;
    s->now = *initially;
    create_world(s, source);
    create_solids(s);
    while (s->batch_count < scene_kinds && plan->kinds[s->batch_count].asset &&
           !(source->own_assets[0] && !source->own_assets[s->batch_count]))
        s->batches[s->batch_count].kind = &plan->kinds[s->batch_count], ++s->batch_count;
    /* If the user gives more assets than the plan has kinds, the others spawn like its first kind. */
    while (s->batch_count < scene_kinds && source->own_assets[s->batch_count])
        s->batches[s->batch_count].kind = &plan->kinds[0], ++s->batch_count;
    for (int k = 0; k < s->batch_count; ++k) {
        scene_batch* b = &s->batches[k];
        load_asset(b, source, k);
        b->count = share_of(s, k, s->now.value[setting_count]);
        b->capacity = b->count ? b->count : 1;
        create_batch(s, b);
        fill_air(s, b);
        set_emitter(s, b);
        set_rules(s, b);
    }
    if (s->now.value[setting_contact] > 0.0f) apply_body_contact(s);
    scene_wind_create(s);
    return s;
}

void scene_free(scene* s) {
    if (!s) return;
    lr_world_destroy(s->world);
    for (int k = 0; k < s->batch_count; ++k) {
        lr_asset_release(s->batches[k].asset);
        mesh_free(&s->batches[k].mesh);
    }
    free(s->renamed);
    free(s);
}

/* Makes a new batch with the same bodies: a batch's loads and capacity cannot change. */
static void replace_batch(scene* s, scene_batch* b) {
    lr_batch_view view;
    check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
    check(lr_batch_get_view(s->world, b->batch, &view), "view", NULL);
    const uint32_t count = view.count < b->capacity ? view.count : b->capacity, first = s->renamed_count;
    s->renamed_count += count;
    if (s->renamed_count > s->renamed_room)
        s->renamed = grow(s->renamed, s->renamed_room = s->renamed_count, sizeof *s->renamed);
    lr_body_desc* bodies = allocate(count, sizeof *bodies);
    for (uint32_t i = 0; i < count; ++i) {
        lr_body_state state;
        s->renamed[first + i][0] = view.ids[i];
        check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", NULL);
        check(lr_body_get_state(s->world, view.ids[i], &state), "state", NULL);
        check(lr_body_desc_init(&bodies[i], sizeof bodies[i]), "lr_body_desc_init", NULL);
        bodies[i].noise_seed = state.noise_seed;
        memcpy(bodies[i].position, state.position, sizeof state.position);
        memcpy(bodies[i].orientation, state.orientation, sizeof state.orientation);
        memcpy(bodies[i].linear_velocity, state.linear_velocity, sizeof state.linear_velocity);
        memcpy(bodies[i].angular_velocity, state.angular_velocity, sizeof state.angular_velocity);
        bodies[i].scale = state.scale;
        bodies[i].age = state.age;
    }
    const lr_batch old = b->batch;
    create_batch(s, b);
    lr_body* ids = allocate(count, sizeof *ids);
    check(lr_body_create(s->world, b->batch, bodies, count, ids), "cannot create the bodies", "try a smaller --count");
    for (uint32_t i = 0; i < count; ++i) s->renamed[first + i][1] = ids[i];
    check(lr_batch_destroy(s->world, old), "batch", NULL);
    free(bodies);
    free(ids);
}

static void shrink(scene* s, const scene_batch* b) {
    lr_batch_view view;
    check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
    check(lr_batch_get_view(s->world, b->batch, &view), "view", NULL);
    if (view.count <= b->count) return;
    const uint32_t surplus = view.count - b->count;
    lr_body* ids = allocate(surplus, sizeof *ids); /* destroying bodies invalidates the view */
    memcpy(ids, view.ids + b->count, surplus * sizeof *ids);
    check(lr_body_destroy(s->world, ids, surplus), "ends", NULL);
    free(ids);
}

int scene_apply(scene* s, const settings* wanted) {
    const settings before = s->now;
    s->now = *wanted;
    int other = 0, changed[setting_number];
    for (int k = 0; k < setting_number; ++k) changed[k] = before.value[k] != wanted->value[k], other |= changed[k];
    if (!other) return 0;
    s->renamed_count = 0;
    for (int k = 0; (changed[setting_count] || changed[setting_model]) && k < s->batch_count; ++k) {
        scene_batch* b = &s->batches[k];
        lr_batch_contact contact;
        check(lr_batch_contact_init(&contact, sizeof contact), "lr_batch_contact_init", NULL);
        check(lr_batch_get_contact(s->world, b->batch, &contact), "contact", NULL);
        lr_emitter_desc emitter;
        int32_t present;
        check(lr_emitter_desc_init(&emitter, sizeof emitter), "lr_emitter_desc_init", NULL);
        check(lr_batch_get_emitter(s->world, b->batch, &emitter, &present), "emitter", NULL);
        b->count = share_of(s, k, s->now.value[setting_count]);
        const uint32_t needed = b->count ? b->count : 1;
        shrink(s, b);
        /* The emitter fills a batch to its capacity, which is therefore the count. */
        b->capacity = needed;
        replace_batch(s, b);
        /* The user may have changed both; only the number of births follows the count. */
        const lr_emitter_desc planned = emitter_of(s, b);
        emitter.rate = planned.rate, emitter.burst_count = planned.burst_count;
        check(lr_batch_set_contact(s->world, b->batch, &contact), "contact", NULL);
        check(lr_batch_set_emitter(s->world, b->batch, &emitter), "emitter", "try a smaller --count");
        set_rules(s, b);
    }
    if (changed[setting_count] || changed[setting_model] || changed[setting_contact]) apply_body_contact(s);
    if (changed[setting_wind] || changed[setting_direction] || changed[setting_gusts] || changed[setting_turbulence])
        scene_wind_update(s);
    return changed[setting_count] || changed[setting_model];
}

lr_body scene_renamed(const scene* s, lr_body old) {
    for (uint32_t i = 0; i < s->renamed_count; ++i)
        if (s->renamed[i][0].id == old.id) return s->renamed[i][1];
    return (lr_body){0};
}

static double seconds_now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void scene_step(scene* s, float dt) {
    const double start = seconds_now();
    /* Faster time takes more substeps of the same length, slower time shorter substeps. */
    const uint32_t substeps = (uint32_t)s->now.value[setting_substeps] * (uint32_t)ceilf(dt * 59.0f);
    check(lr_world_step(s->world, dt, substeps ? substeps : 1), "step", "try more --substeps");
    s->stepping = seconds_now() - start;
}

scene_report scene_look(const scene* s, int whole) {
    lr_world_info info;
    check(lr_world_info_init(&info, sizeof info), "lr_world_info_init", NULL);
    check(lr_world_get_info(s->world, &info), "world info", NULL);
    scene_report report = {info.body_count, info.awake_count, info.time, 0, 1e9f};
    if (!whole) return report;
    check(lr_world_hash(s->world, &report.hash), "hash", NULL);
    for (int k = 0; k < s->batch_count; ++k) {
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
        check(lr_batch_get_view(s->world, s->batches[k].batch, &view), "view", NULL);
        for (uint32_t i = 0; i < view.count; ++i) {
            const float ground =
                ground_surface(s->plan->relief, s->plan->ground_level, view.position[0][i], view.position[2][i]);
            report.lowest = fminf(report.lowest, view.position[1][i] - ground);
        }
    }
    return report;
}
