/* SPDX-License-Identifier: MIT */
#ifndef LANGEVIN_HELP_H
#define LANGEVIN_HELP_H

/* Gives the help of all classes to the editor. */
void load_help(void);

#endif
