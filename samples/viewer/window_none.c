/* Replaces window_glfw.c if GLFW is missing.    SPDX-License-Identifier: MIT */
#include <time.h>

#include "drawing/failure.h"
#include "window.h"

int window_possible(void) {
    return 0;
}

window* window_open(int width, int height, const char* title) {
    (void)width, (void)height, (void)title;
    fail("install GLFW (Debian: libglfw3-dev) and build again, or give --png FILE", "built without windows");
}

void window_close(window* w) {
    (void)w;
}

void window_size(const window* w, int* width, int* height) {
    (void)w, *width = *height = 0;
}

int window_event(window* w, event* e) {
    (void)w, e->kind = event_none;
    return 0;
}

void window_show(window* w, GLuint framebuffer, int width, int height) {
    (void)w, (void)framebuffer, (void)width, (void)height;
}

void window_title(window* w, const char* title) {
    (void)w, (void)title;
}

double window_time(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}
