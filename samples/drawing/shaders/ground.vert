// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;
layout(location = 1) in vec3 normal;
out vec3 at, facing;
void main() {
    // Bodies penetrate the ground by the contact's slop, and sheets are thinner than the depth buffer resolves.
    at = position - vec3(0.0, 0.0005, 0.0);
    facing = normal;
    gl_Position = to_clip * vec4(at, 1.0);
}
