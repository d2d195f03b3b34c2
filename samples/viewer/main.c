/* A window on falling bodies, or pictures and films of them without a display.    SPDX-License-Identifier: MIT */
#include <stdio.h>
#include <stdlib.h>

#include "drawing/failure.h"
#include "film.h"
#include "viewer.h"
#include "window.h"

static unsigned char* shot(viewer* v) {
    unsigned char* rgb = allocate(3 * (size_t)v->picture.width * (size_t)v->picture.height, 1);
    picture_read(&v->picture, rgb);
    return rgb;
}

static void write_shot(viewer* v, const char* path) {
    unsigned char* rgb = shot(v);
    film_write_png(path, rgb, v->picture.width, v->picture.height);
    free(rgb);
    printf("wrote %s\n", path);
}

/* Writes the picture of key p under the first free name. */
static void write_snapshot(viewer* v) {
    char path[64];
    fclose(new_file("png", path, sizeof path));
    write_shot(v, path);
    v->snapshot = 0;
}

/* Handles the events of --press up to this time on the clock. */
static void press_until(viewer* v, double clock, int* next) {
    const options* o = &v->options;
    while (*next < o->press_count && o->presses[*next].time <= clock + 1e-9) {
        const press* p = &o->presses[(*next)++];
        event e = p->what;
        e.x *= (float)v->picture.width, e.y *= (float)v->picture.height;
        for (int k = 0; k < p->times; ++k) viewer_handle(v, &e);
    }
}

static void report(const viewer* v, unsigned pictures) {
    const scene_report r = scene_look(v->scene, 1);
    printf("scene %s: %u pictures, t = %.4f s, %llu bodies, %llu asleep, lowest %.4f m, hash %016llx\n",
           v->scene->plan->name, pictures, r.time, (unsigned long long)r.bodies,
           (unsigned long long)(r.bodies - r.awake), (double)r.lowest, (unsigned long long)r.hash);
    const camera* c = &v->camera;
    printf("camera %.1f,%.1f,%.3f target %.3f,%.3f,%.3f%s%s\n", (double)(c->azimuth * 180.0f / PI),
           (double)(c->elevation * 180.0f / PI), (double)c->distance, (double)c->target.x, (double)c->target.y,
           (double)c->target.z, v->followed.id ? " following" : "", v->paused ? " paused" : "");
    for (int k = 0; k < setting_number; ++k) {
        char value[32];
        setting_text(&v->wanted, (enum setting)k, value, sizeof value);
        printf("%s%s %s", k ? ", " : "", setting_kinds[k].label, value);
    }
    putchar('\n');
    if (v->options.places) panel_print_places(v->panel);
}

/* Pictures without a display: time advances in ticks of a sixtieth of a second, independent of the clock. */
static unsigned run_without_display(viewer* v) {
    const options* o = &v->options;
    picture_resize(&v->picture, o->width, o->height); /* clicks need its size */
    film out;
    if (o->frames) film_begin(&out, o->png, o->width, o->height, o->fps);
    const unsigned first = (unsigned)(o->seconds * ticks_a_second + 0.5), apart = (unsigned)(ticks_a_second / o->fps);
    const unsigned last = first + (o->frames ? (o->frames - 1) * apart : 0);
    unsigned pictures = 0;
    int next = 0;
    for (unsigned tick = 0;; ++tick) {
        press_until(v, (double)tick / ticks_a_second, &next);
        if (v->snapshot) {
            viewer_draw(v, o->width, o->height);
            write_snapshot(v);
        }
        if (v->quit) break;
        if (tick >= first && (tick - first) % apart == 0) {
            viewer_draw(v, o->width, o->height);
            ++pictures;
            if (o->frames) {
                unsigned char* rgb = shot(v);
                film_add(&out, rgb);
                free(rgb);
            } else {
                write_shot(v, o->png);
            }
        }
        if (tick >= last) break;
        viewer_tick(v, 1.0 / ticks_a_second);
    }
    if (o->frames) {
        film_end(&out);
        printf("wrote %u pictures to %s\n", pictures, o->png);
    }
    return pictures;
}

static unsigned run_window(viewer* v, window* w) {
    const options* o = &v->options;
    const double start = window_time();
    double before = start;
    unsigned pictures = 0;
    int next = 0, width = 0, height = 0, open = 1;
    event e;
    v->frame_seconds = 1.0 / 60.0;
    picture_resize(&v->picture, o->width, o->height); /* clicks before the first picture need its size, too */
    while (open && !v->quit && (o->seconds < 0.0 || before - start < o->seconds)) {
        while ((open = window_event(w, &e)), e.kind != event_none) viewer_handle(v, &e);
        press_until(v, before - start, &next);
        const double now = window_time(), elapsed = now - before;
        before = now;
        v->frame_seconds += 0.1 * (elapsed - v->frame_seconds);
        /* The world must not jump after a pause of the window. */
        viewer_tick(v, elapsed < 0.001 ? 0.001 : elapsed > 0.05 ? 0.05 : elapsed);
        window_size(w, &width, &height);
        if (width <= 0 || height <= 0) continue; /* the window is minimised */
        viewer_draw(v, width, height);
        if (v->snapshot) write_snapshot(v);
        window_show(w, v->picture.target[1], width, height);
        ++pictures;
    }
    if (o->png && pictures) write_shot(v, o->png);
    return pictures;
}

int main(int count, char** arguments) {
    static viewer v;
    options_read(&v.options, count, arguments);
    window* w = NULL;
    if (v.options.window)
        w = window_open(v.options.width, v.options.height, "Langevin Rigid");
    else
        context_without_display();
    viewer_create(&v);
    const unsigned pictures = w ? run_window(&v, w) : run_without_display(&v);
    report(&v, pictures);
    viewer_free(&v);
    if (w) window_close(w);
    return fflush(stdout) == 0 ? 0 : EXIT_FAILED;
}
