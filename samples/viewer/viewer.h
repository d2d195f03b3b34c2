/* The viewer: a scene, its picture, and the user's choices.    SPDX-License-Identifier: MIT */
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
    settings wanted; /* values of the sliders */
    camera camera;
    lr_body followed; /* id 0: none */
    int followed_batch;
    vec3 followed_at; /* at this tick */

    int paused, single, quit, snapshot; /* single: take a step; snapshot: take a picture */
    int show_arrows, show_trails, show_overlay;
    int row;            /* of the panel, selected */
    int dragged_button; /* the pressed button; else -1 */
    int dragged_row;    /* the row of the dragged slider; else -1 */
    float pressed_x, pressed_y, pointer_x, pointer_y;
    int moved;            /* the mouse has moved since the button went down: not a click */
    double frame_seconds; /* on the clock, per frame; 0 if pictures must not depend on it */

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

/* Shows another plan, or restarts the same. */
void viewer_show_plan(viewer* v, const scene_plan* plan, const settings* initially, const camera* place);

/* dt: s on the clock. */
void viewer_tick(viewer* v, double dt);

/* Draws a picture of this size into v->picture. */
void viewer_draw(viewer* v, int width, int height);

/* Handles user input: ui.c. */
void viewer_handle(viewer* v, const event* e);

/* Draws the panel over the picture: panel.c. */
void panel_draw(viewer* v);
int panel_row_at(const viewer* v, float x, float y); /* the slider's row at a point; -1: none */
float panel_place(const viewer* v, float x);         /* position along a slider: 0 to 1, also beyond its ends */

#endif
