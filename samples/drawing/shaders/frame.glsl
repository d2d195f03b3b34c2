#version 330 core
// Precedes every shader of the scene.    SPDX-License-Identifier: MIT
uniform vec3 eye;
uniform vec3 sun;              // towards it
uniform mat4 to_clip;
#line 1
