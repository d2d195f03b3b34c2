/* SPDX-License-Identifier: MIT */
#include "window.h"

#include <string.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "drawing/failure.h"

enum { queue_room = 256 };

struct window {
    GLFWwindow* handle;
    event queue[queue_room];
    int first, count;
    float scale_x, scale_y; /* px of the picture per unit of the pointer's position */
    double x, y;            /* pointer position at the last event: GLFW only gives the present position */
};

static window the_window;
static char last_error[256] = "unknown reason";

static void on_error(int code, const char* text) {
    (void)code;
    strncpy(last_error, text, sizeof last_error - 1);
}

static void enqueue(window* w, event e) {
    if (w->count == queue_room) return; /* no user types as fast */
    w->queue[(w->first + w->count++) % queue_room] = e;
}

static int key_of(int key) {
    switch (key) {
    case GLFW_KEY_UP:
        return key_up;
    case GLFW_KEY_DOWN:
        return key_down;
    case GLFW_KEY_LEFT:
        return key_left;
    case GLFW_KEY_RIGHT:
        return key_right;
    case GLFW_KEY_ESCAPE:
        return key_escape;
    case GLFW_KEY_TAB:
        return key_tab;
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER:
        return key_enter;
    case GLFW_KEY_BACKSPACE:
        return key_back;
    case GLFW_KEY_DELETE:
        return key_delete;
    case GLFW_KEY_END:
        return key_end;
    default:
        break;
    }
    if (key >= GLFW_KEY_A && key <= GLFW_KEY_Z) return 'a' + key - GLFW_KEY_A;
    if (key >= GLFW_KEY_0 && key <= GLFW_KEY_9) return '0' + key - GLFW_KEY_0;
    return key == GLFW_KEY_SPACE ? ' ' : key == GLFW_KEY_PERIOD ? '.' : 0;
}

static void on_key(GLFWwindow* handle, int key, int scan_code, int action, int modifiers) {
    (void)scan_code;
    const event e = {.kind = event_key,
                     .key = key_of(key),
                     .shift = (modifiers & GLFW_MOD_SHIFT) != 0,
                     .control = (modifiers & GLFW_MOD_CONTROL) != 0};
    if (action != GLFW_RELEASE && e.key) enqueue(glfwGetWindowUserPointer(handle), e);
}

static void on_letter(GLFWwindow* handle, unsigned letter) {
    const event e = {.kind = event_text, .letter = letter};
    enqueue(glfwGetWindowUserPointer(handle), e);
}

static event at_pointer(GLFWwindow* handle, enum event_kind kind) {
    const window* w = glfwGetWindowUserPointer(handle);
    const event e = {.kind = kind, .x = (float)w->x * w->scale_x, .y = (float)w->y * w->scale_y};
    return e;
}

static void on_button(GLFWwindow* handle, int button, int action, int modifiers) {
    event e = at_pointer(handle, action == GLFW_PRESS ? event_press : event_release);
    e.shift = (modifiers & GLFW_MOD_SHIFT) != 0, e.control = (modifiers & GLFW_MOD_CONTROL) != 0;
    e.button = button == GLFW_MOUSE_BUTTON_LEFT    ? button_left
               : button == GLFW_MOUSE_BUTTON_RIGHT ? button_right
                                                   : button_middle;
    enqueue(glfwGetWindowUserPointer(handle), e);
}

static void on_move(GLFWwindow* handle, double x, double y) {
    window* w = glfwGetWindowUserPointer(handle);
    w->x = x, w->y = y;
    enqueue(w, at_pointer(handle, event_move));
}

static void on_scroll(GLFWwindow* handle, double x, double y) {
    (void)x;
    event e = at_pointer(handle, event_scroll);
    e.notches = (float)y;
    enqueue(glfwGetWindowUserPointer(handle), e);
}

int window_possible(void) {
    return 1;
}

window* window_open(int width, int height, const char* title) {
    window* w = &the_window;
    glfwSetErrorCallback(on_error);
    if (!glfwInit()) fail("start it on a desktop, or give --png FILE", "no window: %s", last_error);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, GLFW_TRUE);
    glfwWindowHint(GLFW_DEPTH_BITS, 0); /* the picture has its own */
    w->handle = glfwCreateWindow(width, height, title, NULL, NULL);
    if (!w->handle) fail("install a driver of OpenGL 3.3, or give --png FILE", "no window: %s", last_error);
    glfwMakeContextCurrent(w->handle);
    glfwSwapInterval(1);
    glfwSetWindowUserPointer(w->handle, w);
    glfwSetKeyCallback(w->handle, on_key);
    glfwSetCharCallback(w->handle, on_letter);
    glfwSetMouseButtonCallback(w->handle, on_button);
    glfwSetCursorPosCallback(w->handle, on_move);
    glfwSetScrollCallback(w->handle, on_scroll);
    w->scale_x = w->scale_y = 1.0f;
    glfwGetCursorPos(w->handle, &w->x, &w->y);
    return w;
}

void window_close(window* w) {
    glfwDestroyWindow(w->handle);
    glfwTerminate();
    memset(w, 0, sizeof *w);
}

void window_size(const window* w, int* width, int* height) {
    glfwGetFramebufferSize(w->handle, width, height);
}

int window_event(window* w, event* e) {
    if (w->count == 0) {
        int wide = 0, tall = 0, pointer_wide = 0, pointer_tall = 0;
        glfwGetFramebufferSize(w->handle, &wide, &tall);
        glfwGetWindowSize(w->handle, &pointer_wide, &pointer_tall);
        if (pointer_wide > 0 && pointer_tall > 0)
            w->scale_x = (float)wide / (float)pointer_wide, w->scale_y = (float)tall / (float)pointer_tall;
        glfwPollEvents();
    }
    e->kind = event_none;
    if (w->count > 0) {
        *e = w->queue[w->first];
        w->first = (w->first + 1) % queue_room;
        --w->count;
    }
    return !glfwWindowShouldClose(w->handle);
}

void window_show(window* w, GLuint framebuffer, int width, int height) {
    glBindFramebuffer(GL_READ_FRAMEBUFFER, framebuffer);
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, 0);
    glBlitFramebuffer(0, 0, width, height, 0, 0, width, height, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glfwSwapBuffers(w->handle);
}

void window_title(window* w, const char* title) {
    glfwSetWindowTitle(w->handle, title);
}

double window_time(void) {
    return glfwGetTime();
}
