/* The panel: sliders, numbers, keys, and a frame around the followed body.    SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <string.h>

#include "failure.h"
#include "viewer.h"

static const shade ink = {0.96f, 0.96f, 0.94f, 1.0f}, faint = {0.80f, 0.82f, 0.82f, 1.0f},
                   board = {0.05f, 0.06f, 0.07f, 0.58f}, track = {1.0f, 1.0f, 1.0f, 0.16f},
                   filled = {0.98f, 0.72f, 0.22f, 0.85f}, chosen = {1.0f, 1.0f, 1.0f, 0.10f};

/* Positions in px, relative to the height of a letter. */
typedef struct layout {
    float letter, line, left, top, width, bar_left, bar_width, value_left;
} layout;

static layout layout_of(int picture_height) {
    layout l;
    l.letter = roundf(clamped((float)picture_height / 66.0f, 8.0f, 28.0f));
    l.line = roundf(2.0f * l.letter);
    l.left = l.top = roundf(1.2f * l.letter);
    l.bar_left = l.left + 10.2f * l.letter;
    l.bar_width = 9.0f * l.letter;
    l.value_left = l.bar_left + l.bar_width + 0.8f * l.letter;
    l.width = l.value_left + 10.6f * l.letter - l.left;
    return l;
}

static float row_top(const layout* l, int row) {
    return l->top + l->line * ((float)row + 1.5f);
}

int panel_row_at(const viewer* v, float x, float y) {
    const layout l = layout_of(v->picture.height);
    if (!v->show_overlay || x < l.left || x > l.left + l.width) return -1;
    for (int row = 0; row < setting_number; ++row) {
        if (y >= row_top(&l, row) && y < row_top(&l, row) + l.line) return row;
    }
    return -1;
}

float panel_place(const viewer* v, float x) {
    const layout l = layout_of(v->picture.height);
    return (x - l.bar_left) / l.bar_width;
}

static void draw_sliders(viewer* v, const layout* l) {
    text* t = &v->text;
    text_box(t, l->left, l->top, l->width, l->line * ((float)setting_number + 1.9f), board);
    text_write(t, l->left + 0.8f * l->letter, l->top + 1.35f * l->letter, ink, v->scene->plan->title);
    for (int row = 0; row < setting_number; ++row) {
        const float y = row_top(l, row), feet = y + 1.45f * l->letter;
        if (row == v->row) {
            text_box(t, l->left, y, l->width, l->line, chosen);
            text_box(t, l->left, y, 0.3f * l->letter, l->line, filled);
        }
        text_write(t, l->left + 0.8f * l->letter, feet, row == v->row ? ink : faint, setting_kinds[row].label);
        const float part = clamped(setting_place((enum setting)row, v->wanted.value[row]), 0.0f, 1.0f);
        const float bar = y + 0.85f * l->letter, thick = roundf(0.34f * l->letter);
        text_box(t, l->bar_left, bar, l->bar_width, thick, track);
        text_box(t, l->bar_left, bar, l->bar_width * part, thick, filled);
        text_box(t, l->bar_left + l->bar_width * part - 0.2f * l->letter, bar - 0.35f * l->letter, 0.4f * l->letter,
                 thick + 0.7f * l->letter, ink);
        char value[32];
        setting_text(&v->wanted, (enum setting)row, value, sizeof value);
        text_write(t, l->value_left, feet, ink, value);
    }
}

static void draw_lines(viewer* v, const layout* l, float right, float top, char lines[][64], int count) {
    float widest = 0.0f;
    for (int i = 0; i < count; ++i) widest = fmaxf(widest, text_width(&v->text, lines[i]));
    const float left = right - widest - 1.6f * l->letter;
    text_box(&v->text, left, top, widest + 1.6f * l->letter, l->line * ((float)count + 0.35f), board);
    for (int i = 0; i < count; ++i)
        text_write(&v->text, left + 0.8f * l->letter, top + l->line * (float)i + 1.5f * l->letter, ink, lines[i]);
}

enum { phase_number = 7 };

/* The phases of the last step that took a hundredth of a millisecond or more. Returns how many lines it has written. */
static int write_phases(const viewer* v, char lines[][64]) {
    lr_timings t;
    check(lr_timings_init(&t, sizeof t), "lr_timings_init", NULL);
    check(lr_world_get_timings(v->scene->world, &t), "timings", NULL);
    const struct {
        const char* name;
        double seconds;
    } phases[phase_number] = {{"motion", t.motion},       {"wind", t.wind},   {"body contact", t.body_contact},
                              {"colliders", t.colliders}, {"waking", t.wake}, {"emitters and rules", t.emit_and_rules},
                              {"events", t.events}};
    int n = 0;
    for (int i = 0; i < phase_number; ++i)
        if (phases[i].seconds >= 1e-5)
            snprintf(lines[n++], sizeof *lines, "   %s %.2f ms", phases[i].name, 1e3 * phases[i].seconds);
    return n;
}

static void draw_numbers(viewer* v, const layout* l) {
    const scene_report r = scene_look(v->scene, 0);
    char lines[4 + phase_number][64];
    int n = 0;
    snprintf(lines[n++], sizeof *lines, "%llu bodies, %llu asleep", (unsigned long long)r.bodies,
             (unsigned long long)(r.bodies - r.awake));
    snprintf(lines[n++], sizeof *lines, "t = %.2f s%s", r.time, v->paused ? "   paused" : "");
    if (v->frame_seconds > 0.0) {
        snprintf(lines[n++], sizeof *lines, "step %.2f ms", 1e3 * v->scene->stepping);
        n += write_phases(v, lines + n);
        snprintf(lines[n++], sizeof *lines, "%.0f pictures/s", 1.0 / v->frame_seconds);
    }
    draw_lines(v, l, (float)v->picture.width - l->left, l->top, lines, n);
    lr_body_state state;
    check(lr_body_state_init(&state, sizeof state), "lr_body_state_init", NULL);
    if (!v->followed.id) return;
    check(lr_body_get_state(v->scene->world, v->followed, &state), "state", NULL);
    const lr_asset_info* info = &v->scene->batches[v->followed_batch].info;
    const float top = l->top + l->line * ((float)n + 0.9f);
    char told[5][64];
    snprintf(told[0], sizeof *told, "%.40s, %.2f g", info->name,
             1e3 * info->mass * (double)(state.scale * state.scale * state.scale));
    snprintf(told[1], sizeof *told, "height %.2f m", (double)state.position[1]);
    snprintf(told[2], sizeof *told, "falls %.2f m/s", -(double)state.linear_velocity[1]);
    snprintf(told[3], sizeof *told, "drifts %.2f m/s",
             (double)hypotf(state.linear_velocity[0], state.linear_velocity[2]));
    snprintf(told[4], sizeof *told, "turns %.1f rad/s%s", (double)length(from_array(state.angular_velocity)),
             state.sleep_state == LR_SLEEP_ASLEEP ? ", at rest" : "");
    draw_lines(v, l, (float)v->picture.width - l->left, top, told, 5);
}

/* Draws corners around the followed body. */
static void draw_frame(viewer* v, const layout* l) {
    const camera_view view = camera_look(&v->camera, (float)v->picture.width / (float)v->picture.height);
    float x, y;
    if (!v->followed.id || !camera_project(&view, v->followed_at, &x, &y)) return;
    const float w = (float)v->picture.width, h = (float)v->picture.height;
    const float depth = -dot(sub(v->followed_at, view.eye), view.back);
    const float reach =
        fmaxf(0.5f * h * v->bodies.batches[v->followed_batch].radius / (view.tan_half * depth) + 0.7f * l->letter,
              1.2f * l->letter);
    const float mx = 0.5f * (1.0f + x) * w, my = 0.5f * (1.0f - y) * h, thick = fmaxf(1.0f, 0.16f * l->letter),
                arm = 0.5f * reach;
    for (int i = 0; i < 4; ++i) {
        const float sx = i & 1 ? 1.0f : -1.0f, sy = i & 2 ? 1.0f : -1.0f;
        const float cx = mx + sx * reach, cy = my + sy * reach;
        text_box(&v->text, sx > 0.0f ? cx - arm : cx, cy - 0.5f * thick, arm, thick, filled);
        text_box(&v->text, cx - 0.5f * thick, sy > 0.0f ? cy - arm : cy, thick, arm, filled);
    }
}

static void draw_keys(viewer* v, const layout* l) {
    static const char* const lines[2] = {
        "space: pause   n: step   arrows: sliders (shift: 5 steps)   r: restart   1 - 7: scenes   p: picture   q: end",
        "mouse: turn, right: shift, wheel: zoom, click: follow   f: let go   a: wind   t: trails   c: camera   h: hide "
        "this"};
    const float top = (float)v->picture.height - 2.0f * l->line - 0.8f * l->letter;
    text_box(&v->text, 0.0f, top, (float)v->picture.width, 2.0f * l->line + 0.8f * l->letter, board);
    const float full = fmaxf(text_width(&v->text, lines[0]), text_width(&v->text, lines[1]));
    if (full > (float)v->picture.width - 2.0f * l->left) {
        text_write(&v->text, l->left, top + 2.6f * l->letter, faint, "space: pause   h: hide   q: end");
        return;
    }
    for (int i = 0; i < 2; ++i)
        text_write(&v->text, l->left, top + 1.7f * l->letter + l->line * (float)i, faint, lines[i]);
}

void panel_draw(viewer* v) {
    const layout l = layout_of(v->picture.height);
    text_set_height(&v->text, l.letter);
    draw_frame(v, &l);
    draw_sliders(v, &l);
    draw_numbers(v, &l);
    draw_keys(v, &l);
    text_draw(&v->text, v->picture.width, v->picture.height);
}
