// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec4 shade;
out vec3 at, facing;
out vec4 tint;
void main() {
    at = position;
    facing = normal;
    tint = shade;
    gl_Position = to_clip * vec4(position, 1.0);
}
