/* SPDX-License-Identifier: MIT */
#include "settings.h"

#include <langevin_rigid.h>
#include <math.h>
#include <stdio.h>

#include "drawing/vectors.h"

const setting_kind setting_kinds[setting_number] = {
    {"wind", "m/s", "--wind", 0.0f, 12.0f, 2, 0},        {"direction", "deg", "--direction", 0.0f, 360.0f, 0, 0},
    {"gusts", "m/s", "--gusts", 0.0f, 4.0f, 1, 0},       {"turbulence", "m/s", "--turbulence", 0.0f, 3.0f, 1, 0},
    {"bodies", "", "--count", 1.0f, 100000.0f, 0, 1},    {"time", "x", "--time-scale", 0.05f, 4.0f, 2, 1},
    {"substeps", "", "--substeps", 1.0f, 16.0f, 0, 0},   {"loads", "", "--model", 0.0f, load_model_count - 1, 0, 0},
    {"contact", "", "--body-contact", 0.0f, 1.0f, 0, 0},
};

const load_model load_models[load_model_count] = {
    {"aerodynamic", LR_LOADS_AERODYNAMIC}, {"langevin", LR_LOADS_LANGEVIN}, {"none", LR_LOADS_NONE}};

float setting_rounded(enum setting which, float value) {
    const setting_kind* kind = &setting_kinds[which];
    const float per_unit = powf(10.0f, (float)kind->decimals);
    return clamped(roundf(value * per_unit) / per_unit, kind->low, kind->high);
}

void setting_text(const settings* s, enum setting which, char* text, unsigned size) {
    const setting_kind* kind = &setting_kinds[which];
    const float value = s->value[which];
    if (which == setting_model)
        snprintf(text, size, "%s", load_models[(int)value].name);
    else if (which == setting_contact)
        snprintf(text, size, "%s", value > 0.0f ? "yes" : "no");
    else
        snprintf(text, size, "%.*f%s%s", kind->decimals, (double)value, *kind->unit ? " " : "", kind->unit);
}
