/* Keys and mouse.    SPDX-License-Identifier: MIT */
#include <stdio.h>

#include "drawing/failure.h"
#include "viewer.h"

static const float click_reach = 5.0f; /* px: a smaller motion of the mouse is a click */

static void press_key(viewer* v, int key) {
    switch (key) {
    case ' ':
        v->paused = !v->paused;
        break;
    case 'n':
    case '.':
        v->paused = v->single = 1;
        break;
    case 'r':
        viewer_show_plan(v, v->scene->plan, &v->wanted, &v->camera);
        break;
    case 'c':
        v->camera = v->scene->plan->camera;
        v->followed = (lr_body){0};
        break;
    case 'f':
        v->followed = (lr_body){0};
        break;
    case 'a':
        v->show_arrows = !v->show_arrows;
        break;
    case 't':
        v->show_trails = !v->show_trails;
        trails_clear(&v->trails);
        break;
    case 'h':
        v->show_overlay = !v->show_overlay;
        break;
    case 'p':
        v->snapshot = 1;
        break;
    case key_escape:
        if (v->followed.id)
            v->followed = (lr_body){0};
        else
            v->quit = 1;
        break;
    case 'q':
        v->quit = 1;
        break;
    default:
        if (key >= '1' && key < '1' + scene_plan_count) {
            const scene_plan* plan = &scene_plans[key - '1'];
            viewer_show_plan(v, plan, &plan->initially, &plan->camera);
        }
    }
}

static int batch_of(const viewer* v, lr_body body) {
    for (int k = 0; k < v->scene->batch_count; ++k) {
        lr_batch_view view;
        check(lr_batch_view_init(&view, sizeof view), "lr_batch_view_init", NULL);
        check(lr_batch_get_view(v->scene->world, v->scene->batches[k].batch, &view), "view", NULL);
        for (uint32_t i = 0; i < view.count; ++i)
            if (view.ids[i].id == body.id) return k;
    }
    return 0;
}

/* Picks the body under the pointer or next to it: casts rays through rings of points around it; the innermost hit counts. */
static void pick(viewer* v, float x, float y) {
    enum { rings = 4, around = 8, ray_count = 1 + rings * around };
    const float w = (float)v->picture.width, h = (float)v->picture.height;
    const camera_view view = camera_look(&v->camera, w / h);
    lr_ray rays[ray_count];
    lr_ray_hit hits[ray_count];
    for (int i = 0; i < ray_count; ++i) {
        const float reach = i ? 2.5f * (float)(1 + (i - 1) / around) * h / 720.0f : 0.0f;
        const float turn = 2.0f * PI * (float)(i % around) / around;
        check(lr_ray_init(&rays[i], sizeof rays[i]), "lr_ray_init", NULL);
        const float px = x + reach * cosf(turn), py = y + reach * sinf(turn);
        to_array(view.eye, rays[i].origin);
        to_array(camera_ray(&view, 2.0f * px / w - 1.0f, 1.0f - 2.0f * py / h), rays[i].direction);
    }
    check(lr_world_ray_cast(v->scene->world, rays, ray_count, hits), "lr_world_ray_cast", NULL);
    for (int i = 0; i < ray_count; ++i) {
        if (!hits[i].body.id) continue;
        v->followed = hits[i].body;
        v->followed_batch = batch_of(v, v->followed);
        v->followed_at = from_array(hits[i].position);
        return;
    }
}

static void press_button(viewer* v, const event* e) {
    v->pressed_x = v->pointer_x = e->x, v->pressed_y = v->pointer_y = e->y;
    v->moved = 0;
    v->dragged_button = e->button;
}

static void move(viewer* v, const event* e) {
    const float h = (float)v->picture.height, dx = (e->x - v->pointer_x) / h, dy = (e->y - v->pointer_y) / h;
    v->pointer_x = e->x, v->pointer_y = e->y;
    if (v->dragged_button < 0) return;
    if (hypotf(e->x - v->pressed_x, e->y - v->pressed_y) > click_reach) v->moved = 1;
    if (!v->moved) return;
    if (v->dragged_button == button_left) {
        camera_orbit(&v->camera, dx, dy);
    } else {
        v->followed = (lr_body){0};
        camera_pan(&v->camera, dx, dy);
    }
}

void viewer_handle(viewer* v, const event* e) {
    /* The panel hears of everything; a drag that began on the picture ends on it. */
    if (panel_handle(v, e) && v->dragged_button < 0) return;
    switch (e->kind) {
    case event_key:
        press_key(v, e->key);
        break;
    case event_press:
        press_button(v, e);
        break;
    case event_move:
        move(v, e);
        break;
    case event_release:
        if (v->dragged_button == button_left && !v->moved) pick(v, e->x, e->y);
        v->dragged_button = -1;
        break;
    case event_scroll:
        camera_zoom(&v->camera, e->notches);
        break;
    default:
        break;
    }
}
