/* Parses --press.    SPDX-License-Identifier: MIT */
#ifndef VIEWER_KEY_PRESSES_H
#define VIEWER_KEY_PRESSES_H

#include "options.h"

/* Adds the events of a text like 1:space,2:right*4. Fails with a message. */
void presses_read(options* o, const char* text);

#endif
