/* The panel over the picture: choices, graphs, the chosen body, history. Dear ImGui draws it.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_PANEL_H
#define VIEWER_PANEL_H

#include "event.h"

#ifdef __cplusplus
extern "C" {
#endif

struct viewer;
struct panel;

struct panel* panel_create(void);
void panel_free(struct panel* p);

/* Gives an event to the panel. 1: it was meant for the panel; 0: for the picture or for the keys. */
int panel_handle(struct viewer* v, const event* e);

/* After a step: keeps what the graphs and the history show. */
void panel_note(struct viewer* v);
/* The world is another one, or its batches are: their history is of no use. */
void panel_forget(struct viewer* v);

/* Draws over the picture. */
void panel_draw(struct viewer* v);

/* Prints the places of all parts that can be used, px: for tests. */
void panel_print_places(const struct panel* p);

#ifdef __cplusplus
}
#endif
#endif
