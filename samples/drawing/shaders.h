/* The text of shaders/, from the file that embed.cmake makes.    SPDX-License-Identifier: MIT */
#ifndef DRAWING_SHADERS_H
#define DRAWING_SHADERS_H

extern const char shader_frame_glsl[], shader_air_glsl[], shader_day_glsl[], shader_evening_glsl[];
extern const char shader_sky_vert[], shader_sky_frag[], shader_evening_sky_frag[];
extern const char shader_body_vert[], shader_body_frag[];
extern const char shader_ground_vert[], shader_ground_frag[];
extern const char shader_solid_vert[], shader_solid_frag[];
extern const char shader_water_vert[], shader_water_frag[];
extern const char shader_arrow_vert[], shader_mark_vert[], shader_mark_frag[];
extern const char shader_nothing_frag[];

#endif
