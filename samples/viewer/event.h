/* User input, from a window or from --press.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_EVENT_H
#define VIEWER_EVENT_H

enum event_kind { event_none, event_key, event_text, event_press, event_release, event_move, event_scroll };

/* Keys are lower-case letters, digits and ' ', or one of these. */
enum { key_up = 256, key_down, key_left, key_right, key_escape, key_tab, key_enter, key_back, key_delete, key_end };
enum { button_left, button_right, button_middle };

typedef struct event {
    enum event_kind kind;
    int key, shift, control;
    unsigned letter; /* of text: its code point */
    int button;
    float x, y;    /* px from the top left of the picture */
    float notches; /* of the wheel, away from the user */
} event;

#endif
