/* The viewer: a scene, its picture, and the user's choices.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_VIEWER_H
#define VIEWER_VIEWER_H

#include <stdio.h>

#include "arrows.h"
#include "drawing/bodies.h"
#include "drawing/landscape.h"
#include "drawing/picture.h"
#include "drawing/shadow.h"
#include "history.h"
#include "options.h"
#include "panel.h"
#include "trails.h"

typedef struct viewer {
    struct options options;
    struct scene* scene;
    settings wanted; /* the user's choice */
    struct camera camera;
    lr_body followed; /* id 0: none */
    int followed_batch;
    vec3 followed_at; /* at this tick */

    int paused, single, quit, snapshot; /* single: take a step; snapshot: take a picture */
    int show_arrows, show_trails, show_overlay;
    int dragged_button; /* the pressed button; else -1 */
    float pressed_x, pressed_y, pointer_x, pointer_y;
    int moved;            /* the mouse has moved since the button went down: not a click */
    double frame_seconds; /* on the clock, per frame; 0 if pictures must not depend on it */

    struct picture picture;
    struct shadow shadow;
    struct bodies bodies;
    struct landscape landscape;
    struct arrows arrows;
    struct trails trails;
    struct panel* panel;
    struct history history;
    FILE* recording; /* null: none */
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

/* Turns the world back to the last kept state at or before a time. */
void viewer_return(viewer* v, double time);
/* Starts a recording of the world, or ends it. lr_replay plays the file. */
void viewer_record(viewer* v, int on);

#endif
