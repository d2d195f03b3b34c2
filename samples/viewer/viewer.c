/* SPDX-License-Identifier: MIT */
#include "viewer.h"

#include <stdlib.h>

#include "drawing/failure.h"
#include "film.h"
#include "ground.h"

void viewer_create(viewer* v) {
    picture_create(&v->picture);
    shadow_create(&v->shadow);
    arrows_create(&v->arrows);
    trails_create(&v->trails);
    v->panel = panel_create();
    v->show_arrows = v->options.arrows, v->show_trails = v->options.trails, v->show_overlay = v->options.overlay;
    v->dragged_button = -1;
    viewer_show_plan(v, v->options.plan, &v->options.settings, &v->options.camera);
}

static const drawn_batch* drawn(const scene* s) {
    static drawn_batch batches[scene_kinds];
    for (int k = 0; k < s->batch_count; ++k)
        batches[k] = (drawn_batch){s->batches[k].batch, &s->batches[k].mesh, s->batches[k].kind->look};
    return batches;
}

static void create_landscape(landscape* l, const scene_plan* plan) {
    float* heights = allocate(ground_side * ground_side, sizeof(float));
    ground_heights(plan->relief, plan->ground_level, heights);
    const ground_shape shape = {ground_side, GROUND_CELL, plan->ground_level, heights};
    landscape_create(l, &light_day, &shape);
    free(heights);
    int count = 0;
    while (count < scene_solids && plan->solids[count].kind) ++count;
    landscape_place(l, plan->solids, count);
}

static void free_scene(viewer* v) {
    viewer_record(v, 0);
    panel_forget(v);
    bodies_free(&v->bodies);
    landscape_free(&v->landscape);
    scene_free(v->scene);
    v->scene = NULL;
}

void viewer_free(viewer* v) {
    free_scene(v);
    picture_free(&v->picture);
    shadow_free(&v->shadow);
    arrows_free(&v->arrows);
    trails_free(&v->trails);
    panel_free(v->panel);
}

void viewer_show_plan(viewer* v, const scene_plan* plan, const settings* initially, const camera* place) {
    const settings begin = *initially; /* can be an alias of the old scene's */
    if (v->scene) free_scene(v);
    v->scene = scene_create(plan, &v->options.source, &begin);
    v->wanted = begin;
    v->camera = *place;
    v->followed = (lr_body){0};
    bodies_create(&v->bodies, &light_day, drawn(v->scene), v->scene->batch_count);
    create_landscape(&v->landscape, plan);
    trails_clear(&v->trails);
}

static void follow(viewer* v, double dt) {
    lr_body_state state;
    check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", NULL);
    if (!v->followed.id) return;
    check(lr_body_get_state(v->scene->world, v->followed, &state), "state", NULL);
    const vec3 at = from_array(state.position);
    if (length(sub(at, v->followed_at)) > 0.6f) v->camera.target = at; /* it has respawned elsewhere */
    v->followed_at = at;
    v->camera.target = mixed(v->camera.target, at, 1.0f - expf(-8.0f * (float)dt));
}

void viewer_tick(viewer* v, double dt) {
    if (scene_apply(v->scene, &v->wanted)) {
        if (v->followed.id) v->followed = scene_renamed(v->scene, v->followed);
        trails_rename(&v->trails, v->scene);
        panel_forget(v);
    }
    if (!v->paused || v->single) {
        /* A single step is a sixtieth of a second, whatever the window's frame rate. */
        const double clock = v->single ? 1.0 / ticks_a_second : dt;
        scene_step(v->scene, (float)clock * v->wanted.value[setting_time]);
        v->single = 0;
        panel_note(v);
        if (v->show_trails || v->followed.id) trails_sample(&v->trails, v->scene, v->followed);
    }
    follow(v, dt);
}

void viewer_return(viewer* v, double time) {
    if (history_return(&v->history, v->scene->world, time) < 0.0) return;
    trails_clear(&v->trails);
    v->paused = 1;
    if (!v->followed.id) return;
    lr_body_state state;
    check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", NULL);
    if (lr_body_get_state(v->scene->world, v->followed, &state) != LR_OK) v->followed = (lr_body){0}; /* not yet born */
}

static int32_t write_recording(void* file, const void* bytes, uint64_t size) {
    return fwrite(bytes, 1, (size_t)size, file) != size;
}

void viewer_record(viewer* v, int on) {
    if (v->recording && !on) {
        lr_world_record_stop(v->scene->world); /* refused if writing has failed before */
        if (fclose(v->recording) != 0) fprintf(stderr, "viewer: the recording is not complete: the disk is full?\n");
        v->recording = NULL;
    } else if (on && !v->recording) {
        char path[64];
        v->recording = new_file("lrr", path, sizeof path);
        lr_recording_desc desc;
        check(lr_recording_desc_init(&desc, sizeof desc), "lr_recording_desc_init", NULL);
        desc.write = write_recording;
        desc.user = v->recording;
        check(lr_world_record_start(v->scene->world, &desc), "recording", NULL);
        printf("recording %s\n", path);
    }
}

void viewer_draw(viewer* v, int width, int height) {
    picture_resize(&v->picture, width, height);
    const scene* s = v->scene;
    pass p = {.light = &light_day, .haze = 90.0f, .view = camera_look(&v->camera, (float)width / (float)height)};
    bodies_update(&v->bodies, s->world, drawn(s));
    shadow_begin(&v->shadow, &v->camera, &p);
    landscape_draw_shadow(&v->landscape, &p);
    bodies_draw_shadow(&v->bodies, s->world, drawn(s), &p);
    picture_begin(&v->picture);
    bodies_draw(&v->bodies, s->world, drawn(s), &p, height);
    landscape_draw(&v->landscape, s->plan->ground, &p);
    if (v->show_arrows) arrows_draw(&v->arrows, v->scene, &p, &v->camera);
    if (s->plan->water) landscape_draw_water(&v->landscape, pond_waves, &p, scene_look(s, 0).time);
    if (v->show_trails || v->followed.id) trails_draw(&v->trails, &p, v->show_trails);
    picture_resolve(&v->picture);
    if (v->show_overlay) panel_draw(v);
    gl_check("drawing");
}
