/* Values of the sliders.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_SETTINGS_H
#define VIEWER_SETTINGS_H

#include <stdint.h>

enum setting {
    setting_wind,       /* m/s */
    setting_direction,  /* degrees: direction to which it blows, from +x towards -z */
    setting_gusts,      /* m/s, root mean square */
    setting_turbulence, /* m/s, root mean square of each component */
    setting_count,
    setting_time, /* s of the world per second of the clock */
    setting_substeps,
    setting_model,   /* index in load_models */
    setting_contact, /* contact between bodies: 0 or 1 */
    setting_number
};

typedef struct settings {
    float value[setting_number];
} settings;

typedef struct setting_kind {
    const char* label;
    const char* unit;
    const char* option; /* of the command line */
    float low, high;
    int decimals;
    int geometric; /* a slider multiplies */
} setting_kind;

extern const setting_kind setting_kinds[setting_number];

typedef struct load_model {
    const char* name;
    int32_t value; /* LR_LOADS_* */
} load_model;

enum { load_model_count = 3 };
extern const load_model load_models[load_model_count];

/* A value as it is shown and used: with few decimals, and within its range. */
float setting_rounded(enum setting which, float value);

/* Value and unit as text. */
void setting_text(const settings* s, enum setting which, char* text, unsigned size);

#endif
