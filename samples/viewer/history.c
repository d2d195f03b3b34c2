/* SPDX-License-Identifier: MIT */
#include "history.h"

#include <stdlib.h>

#include "drawing/failure.h"

static const double apart = 0.25; /* s */
static const uint64_t most_bytes = 512ull << 20;

static int place(const history* h, int i) {
    return (h->first + i) % history_room;
}

static void forget_first(history* h) {
    free(h->kept[h->first].bytes);
    h->kept[h->first].bytes = NULL;
    h->first = place(h, 1);
    --h->count;
}

void history_note(history* h, lr_world* world, double time) {
    if (!h->on || (h->count > 0 && time < h->kept[place(h, h->count - 1)].time + apart)) return;
    uint64_t size = lr_world_snapshot_size(world), all = size;
    for (int i = 0; i < h->count; ++i) all += h->kept[place(h, i)].size;
    for (; h->count > 0 && (h->count == history_room || all > most_bytes); forget_first(h))
        all -= h->kept[h->first].size;
    void* bytes = allocate((size_t)size, 1);
    check(lr_world_snapshot_save(world, bytes, size, &size), "snapshot", NULL);
    const int at = place(h, h->count++);
    h->kept[at].time = time, h->kept[at].bytes = bytes, h->kept[at].size = size;
}

double history_return(history* h, lr_world* world, double time) {
    if (h->count == 0) return -1.0;
    while (h->count > 1 && h->kept[place(h, h->count - 1)].time > time + 1e-9) {
        const int last = place(h, --h->count);
        free(h->kept[last].bytes);
        h->kept[last].bytes = NULL;
    }
    const int at = place(h, h->count - 1);
    check(lr_world_snapshot_restore(world, h->kept[at].bytes, h->kept[at].size), "going back", NULL);
    return h->kept[at].time;
}

void history_clear(history* h) {
    while (h->count > 0) forget_first(h);
}
