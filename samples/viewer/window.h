/* The OpenGL context: in a window, or without a display.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_WINDOW_H
#define VIEWER_WINDOW_H

#include "drawing/gl.h"
#include "event.h"

/* Whether this program was built with GLFW. */
int window_possible(void);

typedef struct window window;

/* Opens the only window. Fails with a message. */
window* window_open(int width, int height, const char* title);
void window_close(window* w);

/* Size of its picture, px; on some displays more than requested. */
void window_size(const window* w, int* width, int* height);

/* The next user input; event_none if there is no more. Returns 0 if the window is to close. */
int window_event(window* w, event* e);

/* Shows a framebuffer's colours. */
void window_show(window* w, GLuint framebuffer, int width, int height);

void window_title(window* w, const char* title);

/* s on the clock. */
double window_time(void);

#endif
