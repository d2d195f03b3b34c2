// SPDX-License-Identifier: MIT
#pragma once

#include "image/picture.h"
#include "output_file.h"

// Writes and commits; throws Failure.
void write_png(const Picture& picture, OutputFile& file);

// The same with a palette, much smaller: for pictures of few colours.
void write_diagram_png(const Picture& picture, OutputFile& file);
