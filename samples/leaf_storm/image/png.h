// SPDX-License-Identifier: MIT
#pragma once

#include "image/picture.h"
#include "output_file.h"

// Writes and commits; throws Failure.
void write_png(const Picture& picture, OutputFile& file);
