/* SPDX-License-Identifier: MIT */
#include "key_presses.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "drawing/failure.h"

static const struct {
    const char* name;
    int key;
} named_keys[] = {{"space", ' '},       {"up", key_up},     {"down", key_down},     {"left", key_left},
                  {"right", key_right}, {"tab", key_tab},   {"escape", key_escape}, {"period", '.'},
                  {"enter", key_enter}, {"back", key_back}, {"delete", key_delete}, {"end", key_end}};

static int key_of(const char* name) {
    for (size_t k = 0; k < sizeof named_keys / sizeof *named_keys; ++k)
        if (strcmp(named_keys[k].name, name) == 0) return named_keys[k].key;
    const int one = (unsigned char)name[0];
    return one && !name[1] && (islower(one) || isdigit(one)) ? one : 0;
}

static void schedule(options* o, double time, event what, int times) {
    if (o->press_count == press_room) fail_usage("--press takes %d events at most", (int)press_room);
    if (o->press_count && time < o->presses[o->press_count - 1].time)
        fail_usage("--press takes its events in order of time");
    const press p = {time, what, times};
    o->presses[o->press_count++] = p;
}

static void add_pointer(options* o, double time, enum event_kind kind, float x, float y) {
    const event e = {.kind = kind, .button = button_left, .x = x, .y = y};
    schedule(o, time, e, 1);
}

static void read_one(options* o, const char* text) {
    char* name = NULL;
    const double time = strtod(text, &name);
    if (name == text || *name != ':' || !(time >= 0.0 && time <= 1e5))
        fail_usage("--press: '%s' does not begin with a time and ':'", text);
    ++name;
    float a, b, c, d;
    char rest;
    if (sscanf(name, "click@%f/%f%c", &a, &b, &rest) == 2) {
        add_pointer(o, time, event_press, a, b);
        add_pointer(o, time, event_release, a, b);
    } else if (sscanf(name, "drag@%f/%f/%f/%f%c", &a, &b, &c, &d, &rest) == 4) {
        add_pointer(o, time, event_press, a, b);
        add_pointer(o, time, event_move, c, d);
        add_pointer(o, time, event_release, c, d);
    } else if (strncmp(name, "type@", 5) == 0) {
        for (const char* letter = name + 5; *letter; ++letter) {
            const event e = {.kind = event_text, .letter = (unsigned char)*letter};
            schedule(o, time, e, 1);
        }
    } else if (sscanf(name, "scroll@%f%c", &a, &rest) == 1) {
        const event e = {.kind = event_scroll, .notches = a};
        schedule(o, time, e, 1);
    } else {
        char* star = strchr(name, '*');
        char* end = NULL;
        const long times = star ? strtol(star + 1, &end, 10) : 1;
        if (star && (*end || end == star + 1 || times < 1 || times > 1000))
            fail_usage("--press: '%s' is not a number of repetitions", star + 1);
        if (star) *star = 0;
        const event e = {.kind = event_key, .key = key_of(name)};
        if (!e.key) fail_usage("--press: '%s' is not a key, click@X/Y, drag@X/Y/X/Y, type@TEXT or scroll@N", name);
        schedule(o, time, e, (int)times);
    }
}

void presses_read(options* o, const char* text) {
    char* copy = allocate(strlen(text) + 1, 1);
    strcpy(copy, text);
    for (char* one = strtok(copy, ","); one; one = strtok(NULL, ",")) read_one(o, one);
    free(copy);
}
