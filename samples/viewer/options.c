/* SPDX-License-Identifier: MIT */
#include "options.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "drawing/failure.h"
#include "film.h"
#include "key_presses.h"
#include "window.h"

static const char help[] =
    "viewer: falling bodies in a window, or in pictures and films without a display\n"
    "\n"
    "  viewer                                    a window, scene leaf\n"
    "  viewer --scene petals --png petals.png    one picture after 8 s\n"
    "  viewer --frames 300 --png film_%04d.png   numbered pictures; --png film.mp4 goes through ffmpeg\n"
    "  viewer --asset my.lrb --mesh my.obj       your own bodies, up to four pairs\n"
    "\n"
    "  --scene NAME         leaf, paper, petals, confetti, planes, water or flight; default: leaf\n"
    "  --asset FILE.lrb     a body baked by lr_bake, instead of the scene's\n"
    "  --mesh FILE.obj      the mesh to draw for the preceding --asset; default: an ellipsoid\n"
    "  --baked DIR          folder of the scenes' assets (samples/viewer/bake.sh)\n"
    "  --meshes DIR         folder of their meshes\n"
    "  --count N            number of bodies, once all are spawned\n"
    "  --wind, --gusts, --turbulence SPEED   m/s; --direction DEGREES: direction to which the wind blows\n"
    "  --time-scale X, --substeps N          of the world\n"
    "  --model aerodynamic|langevin|none     loads; --body-contact: contact between bodies\n"
    "  --seed N, --threads N                 of the world\n"
    "  --png FILE           a picture, or with --frames a film; without --window needs no display\n"
    "  --frames N, --fps N  length of the film and its rate, a divisor of 60; default: 30\n"
    "  --seconds S          time of the picture or of the film's start; with a window: time of its end\n"
    "  --size WIDTHxHEIGHT  px; default: 1280x720\n"
    "  --camera AZIMUTH,ELEVATION,DISTANCE   degrees and m;  --target X,Y,Z   m\n"
    "  --arrows, --trails, --no-overlay      parts of the first display\n"
    "  --places                              print the places of the panel's parts at the end\n"
    "  --press T:WHAT[*N],...   simulates user input at T s: a key (space up down left right tab escape, letters, "
    "digits),\n"
    "                       click@X/Y or drag@X/Y/X/Y (parts of the picture), scroll@N, type@TEXT\n"
    "  --window             a window even with --png; the picture is then taken at its end\n"
    "  --help\n"
    "\n"
    "Exit code 0: success, 1: bad usage, 2: run-time failure, with a message that says what to do.\n";

static double number(const char* option, const char* text, double low, double high) {
    char* end = NULL;
    const double value = text ? strtod(text, &end) : 0.0;
    if (!text || end == text || *end || !(value >= low && value <= high))
        fail_usage("%s takes a number from %g to %g, not '%s'", option, low, high, text ? text : "");
    return value;
}

static double whole(const char* option, const char* text, double low, double high) {
    const double value = number(option, text, low, high);
    if (value != floor(value)) fail_usage("%s takes a whole number, not '%s'", option, text);
    return value;
}

static const char* text_of(const char* option, const char* text) {
    if (!text || !*text) fail_usage("%s takes a value", option);
    return text;
}

static void numbers(const char* option, const char* text, const char* form, float* values) {
    char rest = 0;
    if (!text || sscanf(text, "%f,%f,%f%c", &values[0], &values[1], &values[2], &rest) != 3 || !isfinite(values[0]) ||
        !isfinite(values[1]) || !isfinite(values[2]))
        fail_usage("%s takes %s, not '%s'", option, form, text ? text : "");
}

static void read_size(options* o, const char* text) {
    char rest = 0;
    if (!text || sscanf(text, "%dx%d%c", &o->width, &o->height, &rest) != 2 || o->width < 64 || o->height < 64 ||
        o->width > 8192 || o->height > 8192)
        fail_usage("--size takes WIDTHxHEIGHT, each 64 to 8192, not '%s'", text ? text : "");
}

static void read_camera(options* o, const char* text) {
    float values[3];
    numbers("--camera", text, "AZIMUTH,ELEVATION,DISTANCE", values);
    if (values[1] < -5.0f || values[1] > 85.0f || values[2] < 0.15f || values[2] > 25.0f)
        fail_usage("--camera: elevation is from -5 to 85 degrees, distance from 0.15 to 25 m");
    o->camera.azimuth = values[0] * PI / 180.0f;
    o->camera.elevation = values[1] * PI / 180.0f;
    o->camera.distance = values[2];
}

static float model_of(const char* text) {
    for (int k = 0; text && k < load_model_count; ++k)
        if (strcmp(load_models[k].name, text) == 0) return (float)k;
    fail_usage("--model is aerodynamic, langevin or none, not '%s'", text ? text : "");
}

/* Reads an option of a slider and its value. Returns 1 if the option is one of these. */
static int read_setting(settings* s, const char* option, const char* value) {
    for (int k = 0; k < setting_number; ++k) {
        const setting_kind* kind = &setting_kinds[k];
        if (strcmp(kind->option, option) != 0 || k == setting_contact) continue;
        if (k == setting_model)
            s->value[k] = model_of(value);
        else
            s->value[k] = (float)(kind->decimals == 0 && k != setting_direction ? whole : number)(
                option, value, (double)kind->low, (double)kind->high);
        return 1;
    }
    return 0;
}

static void add_own(const char** list, const char* option, const char* value) {
    int k = 0;
    while (k < scene_kinds && list[k]) ++k;
    if (k == scene_kinds) fail_usage("%s can be given %d times at most", option, (int)scene_kinds);
    list[k] = text_of(option, value);
}

static void read_mesh(options* o, const char* value) {
    int k = 0;
    while (k < scene_kinds && o->source.own_assets[k]) ++k;
    if (k == 0) fail_usage("--mesh needs an --asset before it");
    if (o->source.own_meshes[k - 1]) fail_usage("two --mesh for one --asset");
    o->source.own_meshes[k - 1] = text_of("--mesh", value);
}

/* Reads an option with a value. Returns 0 if the option is not one of these. */
static int read_valued(options* o, const char* option, const char* value) {
    if (strcmp(option, "--asset") == 0)
        add_own(o->source.own_assets, option, value);
    else if (strcmp(option, "--mesh") == 0)
        read_mesh(o, value);
    else if (strcmp(option, "--baked") == 0)
        o->source.baked = text_of(option, value);
    else if (strcmp(option, "--meshes") == 0)
        o->source.meshes = text_of(option, value);
    else if (strcmp(option, "--seed") == 0)
        o->source.seed = (uint64_t)whole(option, value, 0.0, 9e15);
    else if (strcmp(option, "--threads") == 0)
        o->source.threads = (uint32_t)whole(option, value, 1.0, 64.0);
    else if (strcmp(option, "--png") == 0)
        o->png = text_of(option, value);
    else if (strcmp(option, "--frames") == 0)
        o->frames = (unsigned)whole(option, value, 1.0, 1e6);
    else if (strcmp(option, "--fps") == 0)
        o->fps = (int)whole(option, value, 1.0, ticks_a_second);
    else if (strcmp(option, "--seconds") == 0)
        o->seconds = number(option, value, 0.0, 1e5);
    else if (strcmp(option, "--size") == 0)
        read_size(o, value);
    else if (strcmp(option, "--press") == 0)
        presses_read(o, text_of(option, value));
    else
        return 0;
    return 1;
}

static int read_flag(options* o, settings* s, const char* option) {
    if (strcmp(option, "--arrows") == 0)
        o->arrows = 1;
    else if (strcmp(option, "--trails") == 0)
        o->trails = 1;
    else if (strcmp(option, "--no-overlay") == 0)
        o->overlay = 0;
    else if (strcmp(option, "--places") == 0)
        o->places = 1;
    else if (strcmp(option, "--window") == 0)
        o->window = 1;
    else if (strcmp(option, "--body-contact") == 0)
        s->value[setting_contact] = 1.0f;
    else
        return 0;
    return 1;
}

static void read_scene(options* o, int count, char** arguments) {
    o->plan = &scene_plans[0];
    for (int i = 1; i < count; ++i) {
        if (strcmp(arguments[i], "--scene") != 0) continue;
        const char* name = i + 1 < count ? arguments[i + 1] : "";
        o->plan = scene_find(name);
        if (!o->plan) fail_usage("--scene is leaf, paper, petals, confetti, planes, water or flight, not '%s'", name);
    }
}

/* A picture under the name of another format would not open everywhere. Names without an ending are taken. */
static int is_picture_name(const char* path) {
    const char* folder = strrchr(path, '/');
    const char* ending = strrchr(folder ? folder : path, '.');
    return !ending || strcasecmp(ending, ".png") == 0;
}

static void check_all(options* o) {
    if (ticks_a_second % o->fps != 0) fail_usage("--fps is a divisor of %d, not %d", (int)ticks_a_second, o->fps);
    if (o->frames && !o->png) fail_usage("--frames needs --png FILE: a name with %%04d in it, or film.mp4");
    if (o->frames && o->window) fail_usage("--frames works without a window only");
    if (!o->frames && o->png && film_is_numbered(o->png)) fail_usage("--png with a number in its name needs --frames");
    if (o->frames && !film_is_numbered(o->png) && (strchr(o->png, '%') || !strchr(o->png, '.')))
        fail_usage("--png with --frames takes one %%d, as in film_%%04d.png, or a name as film.mp4, not '%s'", o->png);
    if (o->frames && strlen(o->png) > 4 && strcmp(o->png + strlen(o->png) - 4, ".png") == 0 &&
        !film_is_numbered(o->png))
        fail_usage("%u pictures cannot have the same name '%s': use a name with %%04d", o->frames, o->png);
    if (o->png && (!o->frames || film_is_numbered(o->png)) && !is_picture_name(o->png))
        fail_usage("--png writes PNGs; the name '%s' must end in .png", o->png);
    if (!o->png) o->window = 1;
    if (o->seconds < 0.0 && !o->window) o->seconds = o->frames ? 0.0 : 8.0;
}

void options_read(options* o, int count, char** arguments) {
    memset(o, 0, sizeof *o);
    for (int i = 1; i < count; ++i) {
        if (strcmp(arguments[i], "--help") != 0 && strcmp(arguments[i], "-h") != 0) continue;
        fputs(help, stdout);
        if (!window_possible()) fputs("This program was built without windows (GLFW).\n", stdout);
        exit(0);
    }
    read_scene(o, count, arguments);
    o->settings = o->plan->initially;
    o->source.baked = VIEWER_BAKED;
    o->source.meshes = VIEWER_MESHES;
    o->source.threads = 1;
    o->width = 1280, o->height = 720, o->fps = 30;
    o->seconds = -1.0;
    o->overlay = 1;
    o->camera = o->plan->camera;
    for (int i = 1; i < count; ++i) {
        const char *option = arguments[i], *value = i + 1 < count ? arguments[i + 1] : NULL;
        if (read_flag(o, &o->settings, option)) continue;
        ++i;
        if (strcmp(option, "--scene") == 0) continue;
        if (strcmp(option, "--camera") == 0) {
            read_camera(o, value);
        } else if (strcmp(option, "--target") == 0) {
            float target[3];
            numbers(option, value, "X,Y,Z", target);
            o->camera.target = from_array(target);
        } else if (!read_setting(&o->settings, option, value) && !read_valued(o, option, value)) {
            fail_usage("unknown option '%s'", option);
        }
    }
    check_all(o);
}
