/* The command line.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_OPTIONS_H
#define VIEWER_OPTIONS_H

#include "event.h"
#include "scene.h"

enum { press_room = 256, ticks_a_second = 60 };

/* An event of --press. */
typedef struct press {
    double time; /* s on the clock, from the start */
    event what;  /* x and y as parts of the picture's width and height */
    int times;
} press;

typedef struct options {
    const scene_plan* plan;
    scene_source source;
    settings settings;
    int window; /* a window is wanted */
    int width, height;
    double seconds;  /* on the clock; of a window under 0: until it is closed */
    const char* png; /* null: none */
    unsigned frames; /* of a film; 0: one picture */
    int fps;
    int arrows, trails, overlay;
    camera camera;
    press presses[press_room];
    int press_count;
} options;

/* Prints help and exits, or fails with a message. */
void options_read(options* o, int count, char** arguments);

#endif
