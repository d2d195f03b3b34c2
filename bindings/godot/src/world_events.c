/*
 * Signals: the bodies that spawned, hit something, landed, woke, ended, respawned or diverged in a step. A signal per batch and kind, with
 * packed arrays of all these bodies.
 *
 * SPDX-License-Identifier: MIT
 */
#include "nodes.h"

#include <stdlib.h>
#include <string.h>

typedef struct report {
    uint64_t node; /* instance id of the batch's node */
    int kind;      /* LR_EVENT_* */
    gd_var bodies, positions, speeds;
} report;

static const struct {
    int kind, signal;
} kinds[] = {{LR_EVENT_SPAWNED, GD_N_spawned},  {LR_EVENT_HIT, GD_N_touched},  {LR_EVENT_LANDED, GD_N_landed},
             {LR_EVENT_WOKE, GD_N_woke},        {LR_EVENT_KILLED, GD_N_ended}, {LR_EVENT_RESPAWNED, GD_N_respawned},
             {LR_EVENT_DIVERGED, GD_N_diverged}};
#define KINDS (sizeof kinds / sizeof kinds[0])

static int fill(report* r, const lr_event_list* list, const batch_node* batch, int kind) {
    int64_t count = 0;
    for (uint32_t i = 0; i < list->count; ++i)
        count += list->events[i].batch.id == batch->batch.id && list->events[i].kind == kind;
    if (count == 0) return 0;
    r->node = batch->base.id;
    r->kind = kind;
    r->bodies = gd_array(GDX_PACKED_INT64_ARRAY, count);
    r->positions = gd_array(GDX_PACKED_VECTOR3_ARRAY, count);
    r->speeds = gd_array(GDX_PACKED_FLOAT32_ARRAY, kind == LR_EVENT_HIT ? count : 0);
    int64_t* bodies = gd_data(&r->bodies);
    float *positions = gd_data(&r->positions), *speeds = gd_data(&r->speeds);
    for (uint32_t i = 0; i < list->count; ++i) {
        const lr_event* event = &list->events[i];
        if (event->batch.id != batch->batch.id || event->kind != kind) continue;
        *bodies++ = (int64_t)event->body.id;
        memcpy(positions, event->position, sizeof event->position);
        positions += 3;
        if (speeds) *speeds++ = event->speed;
    }
    return 1;
}

void world_emit_events(world_node* self) {
    lr_event_list list;
    lr_event_list_init(&list, sizeof list);
    if (lr_world_get_events(self->world, &list) != LR_OK) return;
    if (list.lost > 0 && list.lost == list.total_lost)
        gd_warning("%llu events of this step were lost: raise event_capacity", (unsigned long long)list.lost);
    if (list.count == 0) return;
    report* reports = calloc((size_t)self->batch_count * KINDS, sizeof *reports);
    if (!reports) return;
    uint32_t count = 0;
    for (uint32_t b = 0; b < self->batch_count; ++b)
        for (uint32_t k = 0; k < KINDS && self->batches[b]->batch.id; ++k)
            count += (uint32_t)fill(&reports[count], &list, self->batches[b], kinds[k].kind);
    /* From here on handlers run, which can free any node: do not use `self` below. */
    for (uint32_t i = 0; i < count; ++i) {
        report* r = &reports[i];
        gdx_object node = gd.object_get_instance_from_id(r->node);
        int signal = GD_N_touched;
        for (uint32_t k = 0; k < KINDS; ++k)
            if (kinds[k].kind == r->kind) signal = kinds[k].signal;
        if (node && r->kind == LR_EVENT_HIT)
            gd_call(node, GD_N_emit_signal, NULL, 4, gd_name_var(signal), gd_copy(&r->bodies), gd_copy(&r->positions),
                    gd_copy(&r->speeds));
        else if (node)
            gd_call(node, GD_N_emit_signal, NULL, 3, gd_name_var(signal), gd_copy(&r->bodies), gd_copy(&r->positions));
        gd_free(&r->bodies);
        gd_free(&r->positions);
        gd_free(&r->speeds);
    }
    free(reports);
}
