// SPDX-License-Identifier: MIT
layout(location = 0) in vec3 position;   // of an arrow along +z from 0 to 1, of radius 1
layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 foot;
layout(location = 3) in vec3 wind;       // m/s
uniform vec2 size;                       // m: length of a fast one, radius
out vec3 at, facing;
out vec4 tint;

vec3 of_speed(float s) {                 // blue, green, yellow, red
    return clamp(vec3(1.5 - abs(4.0 * s - 3.4), 1.45 - abs(4.0 * s - 2.0), 1.5 - abs(4.0 * s - 0.7)), 0.0, 1.0);
}

void main() {
    float speed = length(wind);
    vec3 z = speed > 1e-4 ? wind / speed : vec3(1.0, 0.0, 0.0);
    vec3 x = normalize(cross(abs(z.y) < 0.9 ? vec3(0.0, 1.0, 0.0) : vec3(1.0, 0.0, 0.0), z)), y = cross(z, x);
    float reach = size.x * speed / (speed + 2.0), thick = size.y * min(1.0, 1.5 * speed);
    at = foot + x * position.x * thick + y * position.y * thick + z * (position.z - 0.5) * reach;
    facing = x * normal.x + y * normal.y + z * normal.z;
    tint = vec4(0.15 + 0.85 * of_speed(min(speed / 6.0, 1.0)), 0.85);
    gl_Position = to_clip * vec4(at, 1.0);
}
