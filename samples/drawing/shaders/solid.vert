// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 own_place;
layout(location = 3) in float look_of;
out vec3 at, facing, own;
out float look;
void main() {
    at = position - 0.0004 * normal; // as in ground.vert
    facing = normal;
    own = own_place;
    look = look_of;
    gl_Position = to_clip * vec4(at, 1.0);
}
