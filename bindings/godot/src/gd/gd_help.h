/*
 * The editor's help of a class, from its tables and a list of texts.
 *
 * SPDX-License-Identifier: MIT
 */
#ifndef LANGEVIN_GD_HELP_H
#define LANGEVIN_GD_HELP_H

#include "gd_class.h"

/* Of a member ("step"), or of the class itself (its name). */
typedef struct gd_help {
    const char* name;
    const char* text;
} gd_help;

/* Gives the class's help to the editor, if the engine takes any. help: ends with a null name; a member without a text, or a text
 * without a member, causes a warning. */
void gd_load_help(const gd_class* type, const gd_help* help);

#endif
