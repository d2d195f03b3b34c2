/* The whole: a scene, what is drawn of it, and what the user has chosen.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include "arrows.h"
#include "bodies.h"
#include "landscape.h"
#include "options.h"
#include "picture.h"
#include "shadow.h"
#include "text.h"
#include "trails.h"

typedef struct viewer {
    options options;
    scene* scene;
    settings wanted; /* of the sliders */
    camera camera;
    lr_body followed; /* id 0: nobody */
    int followed_batch;
    vec3 followed_at; /* of this tick */

    int paused, single, quit, snapshot; /* single: a step is wanted; snapshot: a picture is */
    int show_arrows, show_trails, show_overlay;
    int row;            /* of the panel, selected */
    int dragged_button; /* while one is down; else -1 */
    int dragged_row;    /* whose slider the pointer holds; else -1 */
    float pressed_x, pressed_y, pointer_x, pointer_y;
    int moved;            /* since the button went down: not a click */
    double frame_seconds; /* on the clock, of a frame; 0 where pictures must not depend on it */

    picture picture;
    shadow shadow;
    bodies bodies;
    landscape landscape;
    arrows arrows;
    trails trails;
    text text;
} viewer;

void viewer_create(viewer* v);
void viewer_free(viewer* v);

/* Another plan, or the same from its beginning. */
void viewer_show_plan(viewer* v, const scene_plan* plan, const settings* initially, const camera* place);

/* dt: s on the clock. */
void viewer_tick(viewer* v, double dt);

/* Draws a picture of this size; it is then in v->picture. */
void viewer_draw(viewer* v, int width, int height);

/* What the user does: ui.c. */
void viewer_handle(viewer* v, const event* e);

/* The panel over the picture: panel.c. */
void panel_draw(viewer* v);
int panel_row_at(const viewer* v, float x, float y); /* whose slider is there; -1: none */
float panel_place(const viewer* v, float x);         /* along a slider: 0 to 1, and beyond its ends */

#endif
