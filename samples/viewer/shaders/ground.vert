// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 at, facing;
void main() {
    at = position;
    facing = normal;
    gl_Position = to_clip * vec4(position, 1.0);
}
