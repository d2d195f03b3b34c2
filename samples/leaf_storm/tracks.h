// A diagram of single falls from rest in still air, seen from the side, which shows flutter, glide and tumble.
// SPDX-License-Identifier: MIT
#pragma once

#include "image/picture.h"
#include "options.h"

Picture draw_tracks(const Options& options); // of the first asset
