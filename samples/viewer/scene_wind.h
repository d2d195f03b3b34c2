/* SPDX-License-Identifier: MIT */
#ifndef VIEWER_SCENE_WIND_H
#define VIEWER_SCENE_WIND_H

#include "scene.h"

/* Adds the sources, with the values of the scene's sliders. */
void scene_wind_create(scene* s);

/* Updates wind and sources from the sliders. */
void scene_wind_update(scene* s);

#endif
