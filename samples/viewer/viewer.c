/* SPDX-License-Identifier: MIT */
#include "viewer.h"

#include "failure.h"

void viewer_create(viewer* v) {
    picture_create(&v->picture);
    shadow_create(&v->shadow);
    arrows_create(&v->arrows);
    trails_create(&v->trails);
    text_create(&v->text);
    v->show_arrows = v->options.arrows, v->show_trails = v->options.trails, v->show_overlay = v->options.overlay;
    v->dragged_button = v->dragged_row = -1;
    viewer_show_plan(v, v->options.plan, &v->options.settings, &v->options.camera);
}

static void free_scene(viewer* v) {
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
    text_free(&v->text);
}

void viewer_show_plan(viewer* v, const scene_plan* plan, const settings* initially, const camera* place) {
    const settings begin = *initially; /* can be an alias of the old scene's */
    if (v->scene) free_scene(v);
    v->scene = scene_create(plan, &v->options.source, &begin);
    v->wanted = begin;
    v->camera = *place;
    v->followed = (lr_body){0};
    bodies_create(&v->bodies, v->scene);
    landscape_create(&v->landscape, v->scene);
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
    }
    if (!v->paused || v->single) {
        /* A single step is a sixtieth of a second, whatever the window's frame rate. */
        const double clock = v->single ? 1.0 / ticks_a_second : dt;
        scene_step(v->scene, (float)clock * v->wanted.value[setting_time]);
        v->single = 0;
        if (v->show_trails || v->followed.id) trails_sample(&v->trails, v->scene, v->followed);
    }
    follow(v, dt);
}

void viewer_draw(viewer* v, int width, int height) {
    picture_resize(&v->picture, width, height);
    pass p = {.view = camera_look(&v->camera, (float)width / (float)height)};
    bodies_update(&v->bodies, v->scene);
    shadow_begin(&v->shadow, &v->camera, &p);
    landscape_draw_shadow(&v->landscape, &p);
    bodies_draw_shadow(&v->bodies, v->scene, &p);
    picture_begin(&v->picture);
    bodies_draw(&v->bodies, v->scene, &p, height);
    landscape_draw(&v->landscape, v->scene, &p);
    if (v->show_arrows) arrows_draw(&v->arrows, v->scene, &p, &v->camera);
    landscape_draw_water(&v->landscape, v->scene, &p, scene_look(v->scene, 0).time);
    if (v->show_trails || v->followed.id) trails_draw(&v->trails, &p, v->show_trails);
    picture_resolve(&v->picture);
    if (v->show_overlay) panel_draw(v);
    gl_check("drawing");
}
