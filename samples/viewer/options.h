/* The command line.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_OPTIONS_H
#define VIEWER_OPTIONS_H

#include "event.h"
#include "scene.h"

enum { press_room = 256, ticks_a_second = 60 };

/* An event of --press. */
typedef struct press {
    double time; /* s on the clock, since the start */
    event what;  /* x and y relative to the picture's width and height */
    int times;
} press;

typedef struct options {
    const scene_plan* plan;
    scene_source source;
    struct settings settings;
    int window; /* open a window */
    int width, height;
    double seconds;  /* on the clock; with a window, below 0: until it is closed */
    const char* png; /* null: no picture */
    unsigned frames; /* length of the film; 0: a single picture */
    int fps;
    int arrows, trails, overlay;
    int places; /* print those of the panel at the end */
    struct camera camera;
    press presses[press_room];
    int press_count;
} options;

/* Prints help and exits, or fails with a message. */
void options_read(options* o, int count, char** arguments);

#endif
