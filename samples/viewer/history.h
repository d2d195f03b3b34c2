/* The last seconds of a world as snapshots: time can be turned back.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_HISTORY_H
#define VIEWER_HISTORY_H

#include <langevin_rigid.h>
#include <stddef.h>

enum { history_room = 256 };

typedef struct history {
    int on;
    int first, count;
    struct {
        double time; /* s of the world */
        void* bytes;
        uint64_t size;
    } kept[history_room];
} history;

/* Keeps the present state, if a quarter of a second has passed since the last; the oldest goes beyond the room or 512 MB. */
void history_note(history* h, lr_world* world, double time);
/* Goes back to the last state at or before a time, and forgets later ones. Returns its time, or -1 without one. */
double history_return(history* h, lr_world* world, double time);
void history_clear(history* h);

#endif
